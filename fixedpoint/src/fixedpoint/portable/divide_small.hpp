// SPDX-License-Identifier: MIT
// divide_small: the quotient of divide, bit by bit in one word, without a table or wider integers.
#pragma once

#include <fixedpoint/portable/divide.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw divide_small(Raw a, Raw b) {
    if (b == 0) return a > 0 ? RawLimits<Raw>::max : a < 0 ? RawLimits<Raw>::min : Raw(0);
    constexpr unsigned char top = RawLimits<Raw>::width - 1;
    const bool negative = (a < 0) != (b < 0);
    Unsigned<Raw> dividend = magnitude(a);
    const Unsigned<Raw> divisor = magnitude(b);
    Unsigned<Raw> rest = 0;  // below the divisor, which is at most 2^top, so doubling it fits
    Unsigned<Raw> quotient = 0;
    bool fits = true;
    for (unsigned char i = 0; i < RawLimits<Raw>::width + F; ++i) {
        rest = static_cast<Unsigned<Raw>>(rest << 1 | dividend >> top);
        dividend = static_cast<Unsigned<Raw>>(dividend << 1);
        fits = fits && quotient >> top == 0;
        quotient = static_cast<Unsigned<Raw>>(quotient << 1);
        if (rest >= divisor) {
            rest = static_cast<Unsigned<Raw>>(rest - divisor);
            quotient = static_cast<Unsigned<Raw>>(quotient | 1);
        }
    }
    if (!fits || quotient >> top != 0) {
        return saturated_with_sign<Raw>(magnitude_overflow<Raw>(), negative);
    }
    const Unsigned<Raw> other = static_cast<Unsigned<Raw>>(divisor - rest);
    const bool up = negative ? rest > other : rest >= other;
    return saturated_with_sign<Raw>(static_cast<Unsigned<Raw>>(quotient + up), negative);
}

}  // namespace portable
}  // namespace fixedpoint
