// SPDX-License-Identifier: MIT
// The reciprocal square root in Q16.16 without a table, bit for bit like avr/roots_q16_16_small.S;
// within 0.68 ulp.
#pragma once

#include <fixedpoint/integer.hpp>

namespace fixedpoint {
namespace portable {

// 2^31 / sqrt(radicand) or up to 2^-11 of it less, below 2^16. `radicand` must be at least 2^30.
FIXEDPOINT_CONSTEXPR uint32_t reciprocal_root_small(uint32_t radicand) {
    constexpr uint32_t c0 = 128, c1 = 59, c3 = 198, bias = 12;
    const uint32_t z = ~radicand >> 24;
    const uint32_t seed = c0 + (z * (c1 + ((z * z >> 8) * c3 >> 8)) >> 8);
    const uint32_t square = ((radicand >> 16) * seed >> 8) * seed >> 8;
    const int32_t error = static_cast<int32_t>(0x8000 - bias) - static_cast<int32_t>(2 * square);
    const int32_t coarse = error >> 8;
    return (seed << 8) + static_cast<uint32_t>(error * static_cast<int32_t>(seed) >> 8) +
           static_cast<uint32_t>(coarse * coarse);
}

FIXEDPOINT_CONSTEXPR int32_t reciprocal_sqrt_small_q16_16(int32_t a) {
    if (a <= 1) return a < 0 ? 0 : a == 0 ? RawLimits<int32_t>::max : int32_t(1) << 24;
    uint32_t radicand = static_cast<uint32_t>(a);
    int shift = 15;
    for (; radicand < uint32_t(1) << 30; radicand <<= 2) --shift;

    const uint32_t root = reciprocal_root_small(radicand), square = root * root;
    const uint32_t m3 = radicand >> 24, m2 = radicand >> 16 & 0xff, m1 = radicand >> 8 & 0xff;
    const uint32_t s3 = square >> 24, s2 = square >> 16 & 0xff, s1 = square >> 8 & 0xff,
                   s0 = square & 0xff;
    // radicand square modulo 1, in units of 2^-30.
    const uint32_t product = (m3 * s0 >> 8) + (m2 * s1 >> 8) + (m1 * s2 >> 8) + m3 * s1 + m2 * s2 +
                             m1 * s3 + ((m2 * s3 + m3 * s2) << 8) + (m3 * s3 << 16);
    const uint32_t doubled = (~product & 0x7fffff) << 1;
    const uint32_t e2 = doubled >> 16, e1 = doubled >> 8 & 0xff, e0 = doubled & 0xff;
    const uint32_t high = root >> 8, low = root & 0xff;
    const uint32_t growth = (e2 * high << 8) + e2 * low + e1 * high + (e0 * high >> 8) + e2 * e2;
    const uint32_t fine = (root << 8) + (growth >> 8) + 1;
    return static_cast<int32_t>(shift == 0 ? fine : ((fine >> (shift - 1)) + 1) >> 1);
}

}  // namespace portable
}  // namespace fixedpoint
