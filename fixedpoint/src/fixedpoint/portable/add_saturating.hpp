// SPDX-License-Identifier: MIT
// add_saturating, subtract_saturating: a + b and a - b, saturated to the smallest or largest
// number.
#pragma once

#include <fixedpoint/integer.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw>
constexpr Raw limit_by_sign(Raw a) {
    return a < 0 ? RawLimits<Raw>::min : RawLimits<Raw>::max;
}

template <class Raw>
FIXEDPOINT_CONSTEXPR Raw add_saturating(Raw a, Raw b) {
    const Raw sum = wrapping_add(a, b);
    if (!RawLimits<Raw>::is_signed) return sum < a ? RawLimits<Raw>::max : sum;
    // The sum overflowed if both operands differ in sign from the wrapped sum.
    return ((a ^ sum) & (b ^ sum)) < 0 ? limit_by_sign(a) : sum;
}

template <class Raw>
FIXEDPOINT_CONSTEXPR Raw subtract_saturating(Raw a, Raw b) {
    const Raw difference = wrapping_subtract(a, b);
    if (!RawLimits<Raw>::is_signed) return a < b ? RawLimits<Raw>::min : difference;
    return ((a ^ b) & (a ^ difference)) < 0 ? limit_by_sign(a) : difference;
}

}  // namespace portable
}  // namespace fixedpoint
