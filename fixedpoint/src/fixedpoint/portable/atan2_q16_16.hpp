// SPDX-License-Identifier: MIT
// atan2 and atan in Q16.16, bit for bit as avr/atan2_q16_16.S computes them; within 0.68
// and 0.59 ulp.
#pragma once

#include <fixedpoint/portable/arctangent_table.hpp>
#include <fixedpoint/portable/interpolation.hpp>
#include <fixedpoint/portable/multiply_high_24.hpp>
#include <fixedpoint/portable/octants_q16_16.hpp>
#include <fixedpoint/portable/ratio_table.hpp>

namespace fixedpoint {
namespace portable {

// numerator / denominator with 24 fraction bits, below 1. Requires numerator <= denominator and
// denominator > 0.
FIXEDPOINT_CONSTEXPR uint32_t ratio_q16_16(uint32_t numerator, uint32_t denominator) {
    while ((denominator >> 31) == 0) {
        denominator <<= 1;
        numerator <<= 1;
    }
    // The denominator's leading one is not part of the position.
    const uint32_t reciprocal = interpolate_falling<RatioTable<>>(denominator >> 8 << 1 & 0xffffff);
    const uint32_t half = multiply_high_24(numerator >> 8, reciprocal);
    return half >= uint32_t(1) << 23 ? 0xffffff : half << 1;
}

FIXEDPOINT_CONSTEXPR int32_t atan2_q16_16(int32_t y, int32_t x) {
    if (x == 0 && y == 0) return 0;
    const uint32_t height = magnitude(y), width = magnitude(x);
    const bool steep = height > width;
    const uint32_t ratio = steep ? ratio_q16_16(width, height) : ratio_q16_16(height, width);
    return angle_in_octant_q16_16(interpolate_rising<ArctangentTable<>>(ratio), steep, x < 0,
                                  y < 0);
}

FIXEDPOINT_CONSTEXPR int32_t atan_q16_16(int32_t a) {
    constexpr uint32_t one = uint32_t(1) << 16;
    const uint32_t height = magnitude(a);
    const bool steep = height >= one;
    const uint32_t ratio = steep ? ratio_q16_16(one, height) : height << 8;
    return angle_in_octant_q16_16(interpolate_rising<ArctangentTable<>>(ratio), steep, false,
                                  a < 0);
}

}  // namespace portable
}  // namespace fixedpoint
