// SPDX-License-Identifier: MIT
// atan2 and atan in Q16.16 by 16 parabolas, bit for bit as avr/atan2_q16_16_small.S computes them;
// within 0.74 ulp.
#pragma once

#include <fixedpoint/portable/arctangent_small_table.hpp>
#include <fixedpoint/portable/octants_q16_16.hpp>
#include <fixedpoint/portable/parabola_small.hpp>

namespace fixedpoint {
namespace portable {

// numerator / denominator as a fraction of 24 bits, of which the kernel computes 20; with 6 for the
// others, errors are balanced. Needs numerator <= denominator, not 0.
FIXEDPOINT_CONSTEXPR uint32_t ratio_small_q16_16(uint32_t numerator, uint32_t denominator) {
    for (; denominator >> 23 != 0; denominator >>= 1) numerator >>= 1;
    const uint32_t bits =
        numerator == denominator
            ? 0xfffff
            : static_cast<uint32_t>((static_cast<uint64_t>(numerator) << 20) / denominator);
    return bits << 4 | 6;
}

FIXEDPOINT_CONSTEXPR int32_t atan2_small_q16_16(int32_t y, int32_t x) {
    if (x == 0 && y == 0) return 0;
    const uint32_t height = magnitude(y), width = magnitude(x);
    const bool steep = height > width;
    const uint32_t ratio =
        steep ? ratio_small_q16_16(width, height) : ratio_small_q16_16(height, width);
    const uint32_t scaled = parabola_small<ArctangentSmallTable<>>(ratio);
    return angle_in_octant_q16_16(scaled + (scaled >> 8), steep, x < 0, y < 0);
}

FIXEDPOINT_CONSTEXPR int32_t atan_small_q16_16(int32_t a) {
    return atan2_small_q16_16(a, int32_t(1) << 16);
}

}  // namespace portable
}  // namespace fixedpoint
