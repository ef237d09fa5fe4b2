// SPDX-License-Identifier: MIT
// atan2 in Q8.8, bit for bit as avr/atan2_q8_8.S computes it; within 0.5494 ulp.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/atan2_q8_8_table.hpp>

namespace fixedpoint {
namespace portable {

// 2^16 atan(numerator / denominator). Requires numerator <= denominator and denominator > 0.
// Reciprocal and arc tangent are interpolated linearly; the ratio has 15 bits and is below 1.
FIXEDPOINT_CONSTEXPR uint16_t arctangent_q8_8(uint16_t numerator, uint16_t denominator) {
    using Table = Atan2Q8_8Table<>;
    while ((denominator >> 15) == 0) {
        denominator = static_cast<uint16_t>(denominator << 1);
        numerator = static_cast<uint16_t>(numerator << 1);
    }
    const uint8_t row = static_cast<uint8_t>(denominator >> 8 & 0x7f);
    const uint16_t reciprocal = static_cast<uint16_t>(
        read_program_memory(Table::reciprocal[row]) -
        (read_program_memory(Table::reciprocal_slope[row]) * (denominator & 0xffu) >> 8));
    const uint16_t n1 = numerator >> 8, n0 = numerator & 0xff;
    const uint16_t r1 = reciprocal >> 8, r0 = reciprocal & 0xff;
    const uint16_t ratio = static_cast<uint16_t>((n1 * r1 + (n1 * r0 >> 8) + (n0 * r1 >> 8)) << 1);
    const uint8_t interval = static_cast<uint8_t>(ratio >> 8);
    return static_cast<uint16_t>(
        read_program_memory(Table::angle[interval]) + ratio +
        (read_program_memory(Table::angle_slope[interval]) * (ratio & 0xffu) >> 8));
}

FIXEDPOINT_CONSTEXPR int16_t atan2_q8_8(int16_t y, int16_t x) {
    if (x == 0 && y == 0) return 0;
    // Includes half an ulp, so that truncating 8 bits rounds.
    constexpr uint32_t half_pi = 103072, pi = 206015, half_ulp = 128;
    const uint16_t height = magnitude(y), width = magnitude(x);
    uint32_t angle = 0;
    if (height > width) {
        const uint32_t first = arctangent_q8_8(width, height);
        angle = x < 0 ? half_pi + first : half_pi - first;
    } else {
        const uint32_t first = arctangent_q8_8(height, width);
        angle = x < 0 ? pi - first : half_ulp + first;
    }
    const int16_t rounded = static_cast<int16_t>(angle >> 8);
    return y < 0 ? static_cast<int16_t>(-rounded) : rounded;
}

}  // namespace portable
}  // namespace fixedpoint
