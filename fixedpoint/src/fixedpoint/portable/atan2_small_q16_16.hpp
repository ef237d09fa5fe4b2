// SPDX-License-Identifier: MIT
// atan2 and atan in Q16.16 without a table, bit for bit as avr/atan2_q16_16_small.S computes them;
// within 0.59 ulp.
#pragma once

#include <fixedpoint/portable/multiply_high_24.hpp>
#include <fixedpoint/portable/octants_q16_16.hpp>

namespace fixedpoint {
namespace portable {

// numerator / denominator with 24 fraction bits, below 1. Needs numerator <= denominator, not 0.
constexpr uint32_t exact_ratio_q16_16(uint32_t numerator, uint32_t denominator) {
    return numerator == denominator
               ? 0xffffff
               : static_cast<uint32_t>((static_cast<uint64_t>(numerator) << 24) / denominator);
}

// x (c0 - z (c1 - z (c2 - ... z c6))), z = x^2: the polynomial of least largest error, 2.5e-7,
// in fractions of 24 bits. With half an ulp and what the products cut in the mean.
FIXEDPOINT_CONSTEXPR uint32_t arctangent_polynomial_q16_16(uint32_t x) {
    constexpr uint32_t c0 = 16777151, c1 = 5589727, c2 = 3323200, c3 = 2220186, c4 = 1335864,
                       c5 = 563785, c6 = 114283;
    constexpr uint32_t rounding = 130;
    const uint32_t z = multiply_high_24(x, x);
    uint32_t factor = c5 - multiply_high_24(c6, z);
    factor = c4 - multiply_high_24(factor, z);
    factor = c3 - multiply_high_24(factor, z);
    factor = c2 - multiply_high_24(factor, z);
    factor = c1 - multiply_high_24(factor, z);
    factor = c0 - multiply_high_24(factor, z);
    return multiply_high_24(factor, x) + rounding;
}

FIXEDPOINT_CONSTEXPR int32_t atan2_small_q16_16(int32_t y, int32_t x) {
    if (x == 0 && y == 0) return 0;
    const uint32_t height = magnitude(y), width = magnitude(x);
    const bool steep = height > width;
    const uint32_t ratio =
        steep ? exact_ratio_q16_16(width, height) : exact_ratio_q16_16(height, width);
    return angle_in_octant_q16_16(arctangent_polynomial_q16_16(ratio), steep, x < 0, y < 0);
}

FIXEDPOINT_CONSTEXPR int32_t atan_small_q16_16(int32_t a) {
    return atan2_small_q16_16(a, int32_t(1) << 16);
}

}  // namespace portable
}  // namespace fixedpoint
