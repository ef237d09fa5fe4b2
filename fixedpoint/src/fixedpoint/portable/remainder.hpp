// SPDX-License-Identifier: MIT
// remainder: a - b trunc(a / b), exact, with the sign of a; a where b = 0.
#pragma once

#include <fixedpoint/integer.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int F>
constexpr Raw remainder(Raw a, Raw b) {
    // A divisor of -1 is taken apart: the quotient of the smallest number would not fit.
    return b == 0 ? a : b == -1 ? Raw(0) : static_cast<Raw>(a % b);
}

}  // namespace portable
}  // namespace fixedpoint
