// SPDX-License-Identifier: MIT
// Sine and cosine in Q16.16 without a table, bit for bit as avr/sin_q16_16_small.S computes them;
// within 0.58 ulp for every input, in [-1, 1].
#pragma once

#include <fixedpoint/portable/multiply_high_24.hpp>
#include <fixedpoint/portable/quarter_turns_q16_16.hpp>

namespace fixedpoint {
namespace portable {

// sin(pi/2 x) / 2 = x (c0 + y (c1 + y (c2 + y c3))), y = 1 - x^2: the polynomial of least largest
// error, 5.9e-7; fractions of 24 bits, c3 of 16.
FIXEDPOINT_CONSTEXPR int32_t sine_of_quarter_turns_small_q16_16(uint32_t turns) {
    constexpr uint32_t c0 = 8388600, c1 = 4194510, c2 = 557288, c3 = 142;
    // Half an ulp in units of 2^-7 and four units for what the products cut.
    constexpr uint32_t rounding = 68;
    const uint32_t x = fold_quarter_turns_q16_16(turns);
    const uint32_t y = 0xffffff - multiply_high_24(x, x);
    const uint32_t inner = c2 + multiply_high_24(c3 << 8, y);
    const uint32_t outer = c1 + multiply_high_24(inner, y);
    const uint32_t half = multiply_high_24(c0 + multiply_high_24(outer, y), x);
    const int32_t sine = static_cast<int32_t>((half + rounding) >> 7);
    return is_lower_half_turn_q16_16(turns) ? -sine : sine;
}

FIXEDPOINT_CONSTEXPR int32_t sin_small_q16_16(int32_t angle) {
    return sine_of_quarter_turns_small_q16_16(quarter_turns_q16_16(angle));
}

FIXEDPOINT_CONSTEXPR int32_t cos_small_q16_16(int32_t angle) {
    return sine_of_quarter_turns_small_q16_16(quarter_turns_q16_16(angle) +
                                              one_quarter_turn_q16_16);
}

}  // namespace portable
}  // namespace fixedpoint
