// SPDX-License-Identifier: MIT
// Sine and cosine in Q16.16 without a table, bit for bit like avr/sin_q16_16_small.S; within
// 0.74 ulp for every input, in [-1, 1].
#pragma once

#include <stdint.h>

namespace fixedpoint {
namespace portable {

// The angle in quarter turns, modulo 256, with 24 fraction bits, as the kernel computes it: off by
// up to 7 units.
FIXEDPOINT_CONSTEXPR uint32_t quarter_turns_small_q16_16(int32_t angle) {
    const uint32_t a = static_cast<uint32_t>(angle) + (uint32_t(1) << 31);
    const uint32_t a0 = a & 0xff, a1 = a >> 8 & 0xff, a2 = a >> 16 & 0xff, a3 = a >> 24;
    // 2/pi = 0.a2f9836e4e..., and a2f9 is a300 - 7.
    constexpr uint32_t m1 = 0x6e, m2 = 0x83, m3 = 7, m4 = 0xa3;
    return a0 * m4 + (a1 * m2 >> 8) + (a2 * m1 >> 8) + (a3 * m4 >> 9) - a1 * m3 + a2 * m2 +
           a3 * m1 + ((a1 * m4 - a2 * m3 + a3 * m2) << 8) + ((a2 * m4 - a3 * m3) << 16) +
           (a3 * m4 << 24) - 0x7cc1b72a;  // 2^31 times 2/pi, plus 3
}

// With x the distance from the peak in quarter turns and y = x^2, the magnitude is
// 1 - y - y (1 - y) b, b = c0 - y c1 - c2 y (1 - y); `bracket` is 4 b in 16 bits.
FIXEDPOINT_CONSTEXPR int32_t sine_of_quarter_turns_small_q16_16(uint32_t turns) {
    const bool lower = (turns >> 25 & 1) != 0;
    const uint32_t x = ((turns >> 24 & 1) != 0 ? turns : ~turns) & 0xffffff;
    const uint32_t x0 = x & 0xff, x1 = x >> 8 & 0xff, x2 = x >> 16;
    const uint32_t y = (x2 * x2 << 8) + (x1 * x1 >> 8) + 2 * ((x2 * x0 >> 8) + x2 * x1);
    const uint32_t y1 = y >> 8 & 0xff, y2 = y >> 16;
    const uint32_t z1 = 0xff - y1, z2 = 0xff - y2;          // 1 - y
    const uint32_t s = y2 * z1 + y1 * z2 + (y2 * z2 << 8);  // y (1 - y)
    const uint32_t s0 = s & 0xff, s1 = s >> 8 & 0xff, s2 = s >> 16;
    constexpr uint32_t c1 = 5006 & 0xff, c2 = 5006 >> 8;
    const uint32_t bracket = 61268 - (y1 * c2 >> 8) - y2 * c2 - ((y2 * c1 >> 8) + s2);
    const uint32_t b1 = bracket & 0xff, b2 = bracket >> 8;
    const uint32_t product = (s2 * b2 << 8) + (s1 * b1 >> 8) + (s0 * b2 >> 8) + s2 * b1 + s1 * b2;
    // Truncation subtracts a mean of 28 units.
    const int32_t missing = static_cast<int32_t>((y + (product >> 2) + 128 + 28) >> 8);
    const int32_t one = int32_t(1) << 16;
    return lower ? missing - one : one - missing;
}

FIXEDPOINT_CONSTEXPR int32_t sin_small_q16_16(int32_t angle) {
    return sine_of_quarter_turns_small_q16_16(quarter_turns_small_q16_16(angle));
}

FIXEDPOINT_CONSTEXPR int32_t cos_small_q16_16(int32_t angle) {
    return sine_of_quarter_turns_small_q16_16(quarter_turns_small_q16_16(angle) +
                                              (uint32_t(1) << 24));
}

}  // namespace portable
}  // namespace fixedpoint
