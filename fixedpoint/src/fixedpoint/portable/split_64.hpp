// SPDX-License-Identifier: MIT
// Products, quotients and roots in 64-bit formats with the fraction bits, at most 63, as an
// operand: the results of the kernels that serve every format. portable::multiply, divide, sqrt and
// dot define them.
#pragma once

#include <fixedpoint/portable/divide.hpp>
#include <fixedpoint/portable/dot.hpp>
#include <fixedpoint/portable/sqrt.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int>
FIXEDPOINT_CONSTEXPR Raw dot_64(const Raw* a, const Raw* b, uint8_t n, uint8_t fraction) {
    Word128 sum;
    for (uint8_t i = 0; i < n; ++i) sum = sum + exact_product(a[i], b[i]);
    return static_cast<Raw>((sum + ((Word128(1) << fraction) >> 1)) >> fraction);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw multiply_64(Raw a, Raw b, uint8_t fraction) {
    return dot_64<Raw, F>(&a, &b, 1, fraction);
}
template <class Raw, int>
FIXEDPOINT_CONSTEXPR Raw divide_64(Raw a, Raw b, uint8_t fraction) {
    if (b == 0) return quotient_by_zero(a);
    const bool negative = (a < 0) != (b < 0);
    return saturated_with_sign<Raw>(
        rounded_quotient_64(magnitude(a), magnitude(b), fraction, !negative), negative);
}
template <class Raw, int>
constexpr Raw sqrt_64(Raw a, uint8_t fraction) {
    return a <= 0 ? Raw(0)
                  : nearest_root<Raw>(static_cast<Unsigned<Raw>>(a) >> 1 >> (63 - fraction),
                                      static_cast<Unsigned<Raw>>(a) << fraction);
}

}  // namespace portable
}  // namespace fixedpoint
