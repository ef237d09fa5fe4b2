// SPDX-License-Identifier: MIT
// multiply_add: floor((a b + c 2^F) / 2^F + 1/2) modulo 2^W: a b + c, rounded once. A whole number
// of ulps may be added after the rounding.
#pragma once

#include <fixedpoint/portable/multiply.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int F>
constexpr Raw multiply_add(Raw a, Raw b, Raw c) {
    return wrapping_add(multiply<Raw, F>(a, b), c);
}

}  // namespace portable
}  // namespace fixedpoint
