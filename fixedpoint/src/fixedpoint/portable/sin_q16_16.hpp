// SPDX-License-Identifier: MIT
// Sine and cosine in Q16.16, bit for bit as avr/sin_q16_16.S computes them; within 0.67 ulp for
// every input, in [-1, 1].
#pragma once

#include <fixedpoint/portable/interpolation.hpp>
#include <fixedpoint/portable/quarter_turns_q16_16.hpp>
#include <fixedpoint/portable/sine_table.hpp>

namespace fixedpoint {
namespace portable {

FIXEDPOINT_CONSTEXPR int32_t sine_of_quarter_turns_q16_16(uint32_t turns) {
    const uint32_t position = fold_quarter_turns_q16_16(turns);
    const int32_t sine = static_cast<int32_t>(interpolate_rising<SineTable<>>(position) >> 7);
    return is_lower_half_turn_q16_16(turns) ? -sine : sine;
}

FIXEDPOINT_CONSTEXPR int32_t sin_q16_16(int32_t angle) {
    return sine_of_quarter_turns_q16_16(quarter_turns_q16_16(angle));
}

FIXEDPOINT_CONSTEXPR int32_t cos_q16_16(int32_t angle) {
    return sine_of_quarter_turns_q16_16(quarter_turns_q16_16(angle) + one_quarter_turn_q16_16);
}

}  // namespace portable
}  // namespace fixedpoint
