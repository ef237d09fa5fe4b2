// SPDX-License-Identifier: MIT
// atan2 and atan in Q16.16, bit for bit as avr/atan2_q16_16.S computes them; within 0.75 ulp.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/arctangent_table.hpp>
#include <fixedpoint/portable/interpolation.hpp>
#include <fixedpoint/portable/ratio_table.hpp>

namespace fixedpoint {
namespace portable {

// numerator / denominator with 24 fraction bits, below 1. Needs numerator <= denominator, not 0.
constexpr uint32_t ratio_q16_16(uint32_t numerator, uint32_t denominator) {
    // Whole bytes first, so that bits are lost only beyond 24 of the denominator.
    while (denominator < uint32_t(1) << 16) {
        denominator <<= 8;
        numerator <<= 8;
    }
    if (denominator < uint32_t(1) << 24) {
        denominator <<= 8;
        numerator <<= 8;
    }
    while ((denominator >> 31) == 0) {
        denominator <<= 1;
        numerator <<= 1;
    }
    const uint32_t reciprocal = interpolate_falling<RatioTable<>>(denominator >> 7 & 0xffffff);
    const uint32_t n0 = numerator >> 8 & 0xff, n1 = numerator >> 16 & 0xff, n2 = numerator >> 24;
    const uint32_t r0 = reciprocal & 0xff, r1 = reciprocal >> 8 & 0xff, r2 = reciprocal >> 16;
    const uint32_t half =
        (n2 * r2 << 8) + n2 * r1 + n1 * r2 + (n2 * r0 >> 8) + (n1 * r1 >> 8) + (n0 * r2 >> 8);
    return half >= uint32_t(1) << 23 ? 0xffffff : half << 1;
}

// The angle whose tangent is `ratio`, in the octant that is `steep` (beyond pi/4 from the x axis),
// `left` (x < 0) and `below` (y < 0).
constexpr int32_t angle_in_octant_q16_16(uint32_t ratio, bool steep, bool left, bool below) {
    constexpr uint32_t half_pi = 26353589, pi = 52707179, ulp = 256;
    // Half an ulp for rounding is in the table; a subtraction takes it off instead.
    const uint32_t first = interpolate_rising<ArctangentTable<>>(ratio);
    const uint32_t angle = steep ? (left ? half_pi + first : half_pi + ulp - first)
                                 : (left ? pi + ulp - first : first);
    const int32_t rounded = static_cast<int32_t>(angle >> 8);
    return below ? -rounded : rounded;
}

constexpr int32_t atan2_q16_16(int32_t y, int32_t x) {
    if (x == 0 && y == 0) return 0;
    const uint32_t height = magnitude(y), width = magnitude(x);
    const bool steep = height > width;
    return angle_in_octant_q16_16(steep ? ratio_q16_16(width, height) : ratio_q16_16(height, width),
                                  steep, x < 0, y < 0);
}

constexpr int32_t atan_q16_16(int32_t a) {
    constexpr uint32_t one = uint32_t(1) << 16;
    const uint32_t height = magnitude(a);
    return height < one ? angle_in_octant_q16_16(height << 8, false, false, a < 0)
                        : angle_in_octant_q16_16(ratio_q16_16(one, height), true, false, a < 0);
}

}  // namespace portable
}  // namespace fixedpoint
