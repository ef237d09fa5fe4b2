// SPDX-License-Identifier: MIT
// Sine and cosine of Q32.32, bit for bit as avr/sin_q32_32.S computes them.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/cubic_64.hpp>
#include <fixedpoint/portable/sine_64_table.hpp>

namespace fixedpoint {
namespace portable {

// The angle in quarter turns, modulo 256, with 40 fraction bits. Only five bytes of an angle below
// 128 rad are significant.
FIXEDPOINT_CONSTEXPR uint64_t quarter_turns_q32_32(int64_t angle) {
    // The bytes of 2/pi after the point.
    constexpr uint8_t two_over_pi[9] = {0xa2, 0xf9, 0x83, 0x6e, 0x4e, 0x44, 0x15, 0x29, 0xfc};
    const int bytes = (angle >> 39) == (angle >> 63) ? 5 : 8;
    uint64_t turns = bytes == 5 ? 4 : 6;
    for (int i = 0; i < bytes; ++i) {
        const uint32_t digit = static_cast<uint8_t>(angle >> 8 * i);
        for (int column = -1; column < 6 && column <= i; ++column) {
            const uint32_t product = digit * two_over_pi[i - column];
            turns += column < 0 ? product >> 8 : static_cast<uint64_t>(product) << 8 * column;
        }
    }
    if (angle < 0) {
        for (int column = 0; column < 6; ++column)
            turns -= static_cast<uint64_t>(two_over_pi[bytes - column]) << 8 * column;
    }
    return turns & 0xffffffffffff;
}

FIXEDPOINT_CONSTEXPR int64_t sine_of_quarter_turns_q32_32(uint64_t turns) {
    const uint64_t position = ((turns >> 40 & 1) != 0 ? ~turns : turns) & 0xffffffffff;
    const int64_t sine = static_cast<int64_t>(cubic_64<Sine64Table<>>(position) >> 7);
    return (turns >> 41 & 1) != 0 ? -sine : sine;
}

constexpr uint64_t one_quarter_turn_q32_32 = uint64_t(1) << 40;

FIXEDPOINT_CONSTEXPR int64_t sin_q32_32(int64_t angle) {
    return sine_of_quarter_turns_q32_32(quarter_turns_q32_32(angle));
}
FIXEDPOINT_CONSTEXPR int64_t cos_q32_32(int64_t angle) {
    return sine_of_quarter_turns_q32_32(quarter_turns_q32_32(angle) + one_quarter_turn_q32_32);
}

}  // namespace portable
}  // namespace fixedpoint
