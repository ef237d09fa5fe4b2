// SPDX-License-Identifier: MIT
// The reciprocal square root of Q32.32, bit for bit as avr/reciprocal_sqrt_q32_32.S computes it.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/reciprocal_root.hpp>

namespace fixedpoint {
namespace portable {

// Byte i after the point of a fraction in units of 2^-8n; the first byte is byte 1.
constexpr uint32_t byte_of_fraction(uint64_t fraction, int n, int i) {
    return static_cast<uint32_t>(fraction >> 8 * (n - i) & 0xff);
}

// 1/4 - m s in units of 2^-56, for m in units of 2^-64 and s in units of 2^-48. The result must be
// below 2^-19.
FIXEDPOINT_CONSTEXPR uint64_t quarter_less_product(uint64_t m, uint64_t s) {
    uint64_t product = 0;
    for (int i = 1; i <= 5; ++i) {
        for (int j = 1; j <= 6; ++j) {
            const int weight = i + j;
            const uint64_t digits = byte_of_fraction(m, 8, i) * byte_of_fraction(s, 6, j);
            // A product of the fifth byte counts only above 2^-48. Of any other product below the
            // last byte that counts, only the upper byte counts.
            const int last = i <= 2 ? 7 : 6;
            if (weight < 3 || weight > last + 1 || (i == 5 && weight > 6)) continue;
            product += weight > last ? digits >> 8 << 8 * (7 - last)
                                     : digits << 8 * (weight > last ? 0 : 7 - weight);
        }
    }
    return (0 - product) & 0xffffffffff;
}

FIXEDPOINT_CONSTEXPR int64_t reciprocal_sqrt_q32_32(int64_t a) {
    if (a <= 0) return a < 0 ? 0 : RawLimits<int64_t>::max;
    // The result is the mantissa 2^-shift.
    uint64_t m = static_cast<uint64_t>(a);
    int shift = 39;
    while (m >> 62 == 0) {
        m <<= 2;
        --shift;
    }
    const uint64_t y = (reciprocal_root_mantissa(static_cast<uint32_t>(m >> 32)) - 9) << 1;
    const uint64_t e = quarter_less_product(m, y * y);

    // (8 e)^2 in units of 2^-62, without the lowest byte; twelve times it, in units of 2^-56, is 3
    // e^2.
    const uint32_t u = static_cast<uint32_t>(e >> 21);
    const uint32_t u0 = u & 0xff, u1 = u >> 8;
    const uint32_t square = (u1 * u1 << 8) + 2 * u0 * u1 + (u0 * u0 >> 8);
    const uint64_t w = e + (12 * static_cast<uint64_t>(square) >> 8);

    uint64_t rise = 0;
    for (int i = 1; i <= 3; ++i) {
        for (int j = 3; j <= 7 && i + j <= 8; ++j) {
            const uint64_t digits = byte_of_fraction(y, 3, i) * byte_of_fraction(w, 7, j);
            rise += i + j == 8 ? digits >> 8 : digits << 8 * (i + j == 8 ? 0 : 7 - i - j);
        }
    }
    const uint64_t mantissa = (y << 32) + 2 * rise;
    return static_cast<int64_t>(((mantissa >> (shift - 1)) + 1) >> 1);
}

}  // namespace portable
}  // namespace fixedpoint
