// SPDX-License-Identifier: MIT
// Absolute values modulo 2^W: copysign is |a| with the sign of b, abs_diff is |a - b|.
#pragma once

#include <fixedpoint/integer.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int F>
constexpr Raw copysign(Raw a, Raw b) {
    return signs_differ(a, b) ? wrapping_negate(a) : a;
}
template <class Raw, int F>
constexpr Raw abs_diff(Raw a, Raw b) {
    return a < b ? wrapping_subtract(b, a) : wrapping_subtract(a, b);
}

}  // namespace portable
}  // namespace fixedpoint
