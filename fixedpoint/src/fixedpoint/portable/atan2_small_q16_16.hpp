// SPDX-License-Identifier: MIT
// atan2 and atan in Q16.16 by 16 parabolas, bit for bit as avr/atan2_q16_16_small.S computes them;
// within 0.74 ulp.
#pragma once

#include <fixedpoint/portable/arctangent_small_table.hpp>
#include <fixedpoint/portable/octants_q16_16.hpp>
#include <fixedpoint/portable/parabola_small.hpp>

namespace fixedpoint {
namespace portable {

// numerator / denominator with 24 fraction bits, below 1. Needs numerator <= denominator, not 0.
constexpr uint32_t exact_ratio_q16_16(uint32_t numerator, uint32_t denominator) {
    return numerator == denominator
               ? 0xffffff
               : static_cast<uint32_t>((static_cast<uint64_t>(numerator) << 24) / denominator);
}

FIXEDPOINT_CONSTEXPR int32_t atan2_small_q16_16(int32_t y, int32_t x) {
    if (x == 0 && y == 0) return 0;
    const uint32_t height = magnitude(y), width = magnitude(x);
    const bool steep = height > width;
    const uint32_t ratio =
        steep ? exact_ratio_q16_16(width, height) : exact_ratio_q16_16(height, width);
    const uint32_t scaled = parabola_small<ArctangentSmallTable<>>(ratio);
    return angle_in_octant_q16_16(scaled + (scaled >> 8), steep, x < 0, y < 0);
}

FIXEDPOINT_CONSTEXPR int32_t atan_small_q16_16(int32_t a) {
    return atan2_small_q16_16(a, int32_t(1) << 16);
}

}  // namespace portable
}  // namespace fixedpoint
