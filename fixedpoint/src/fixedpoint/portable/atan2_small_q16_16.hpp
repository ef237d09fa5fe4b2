// SPDX-License-Identifier: MIT
// atan2 and atan in Q16.16 by a table of 16 angles, bit for bit like avr/atan2_q16_16_small.S;
// within 0.63 ulp.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/arctangent_small_table.hpp>

namespace fixedpoint {
namespace portable {

// The arc tangent of numerator / denominator with 24 fraction bits and half an ulp of Q16.16 for
// rounding. `numerator` must be at most `denominator`, which must not be 0.
FIXEDPOINT_CONSTEXPR uint32_t octant_angle_small_q16_16(uint32_t numerator, uint32_t denominator) {
    for (; denominator >> 16 == 0; denominator <<= 8) numerator <<= 8;
    for (; denominator >> 22 != 0; denominator >>= 1) numerator >>= 1;
    const uint32_t cell = numerator == denominator ? 15 : 16 * numerator / denominator;
    // The tangent of the angle beyond that of the table, in units of 2^-20.
    const uint32_t remainder = 16 * numerator - cell * denominator;
    const uint32_t tangent = static_cast<uint32_t>((static_cast<uint64_t>(remainder) << 16) /
                                                   (denominator + (cell * numerator >> 4)));
    const uint32_t upper = tangent >> 8;
    const uint32_t third = ((upper * upper >> 8) * upper >> 8) * 85 >> 8;
    return read_program_memory(ArctangentSmallTable<>::angle[cell]) + ((tangent - third) << 4);
}

FIXEDPOINT_CONSTEXPR int32_t atan2_small_q16_16(int32_t y, int32_t x) {
    if (x == 0 && y == 0) return 0;
    const uint32_t height = magnitude(y), width = magnitude(x);
    const bool steep = height > width, left = x < 0;
    const uint32_t first =
        steep ? octant_angle_small_q16_16(width, height) : octant_angle_small_q16_16(height, width);
    constexpr uint32_t half_pi = 26353589;
    const uint32_t axis = steep ? half_pi : left ? 2 * half_pi : 0;
    // If the angle is subtracted, so is its half ulp; adding an ulp minus a unit makes up for that.
    const uint32_t angle = steep != left ? axis + 255 - first : axis + first;
    const int32_t rounded = static_cast<int32_t>(angle >> 8);
    return y < 0 ? -rounded : rounded;
}

FIXEDPOINT_CONSTEXPR int32_t atan_small_q16_16(int32_t a) {
    return atan2_small_q16_16(a, int32_t(1) << 16);
}

}  // namespace portable
}  // namespace fixedpoint
