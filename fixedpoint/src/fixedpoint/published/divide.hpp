// SPDX-License-Identifier: MIT
// divide: a 2^F / b truncated toward zero, modulo 2^W, by the algorithm of the 2016 design. b = 0:
// the largest number if a > 0, the smallest if a < 0, 0 if a = 0.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/published/magnitude.hpp>

namespace fixedpoint {
namespace published {

// Both operands are made positive, the dividend is widened and shifted left, and the sign is
// restored. Corrected: a zero divisor has a result, the most negative number has a magnitude, and
// no negative number is shifted left.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw divide(Raw a, Raw b) {
    if (b == 0) return a > 0 ? RawLimits<Raw>::max : a < 0 ? RawLimits<Raw>::min : Raw(0);
    int flip = 1;
    if (a < 0) {
        a = wrapping_negate(a);
        flip = -flip;
    }
    if (b < 0) {
        b = wrapping_negate(b);
        flip = -flip;
    }
    return flip_sign<Raw>(
        divide_magnitudes<Raw, F>(static_cast<Unsigned<Raw>>(a), static_cast<Unsigned<Raw>>(b)),
        flip);
}

}  // namespace published
}  // namespace fixedpoint
