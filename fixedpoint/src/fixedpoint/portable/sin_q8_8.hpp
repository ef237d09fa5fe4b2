// SPDX-License-Identifier: MIT
// sin and cos in Q8.8, bit for bit as avr/sin_q8_8.S computes them; within 0.546 ulp.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/chords_of_bytes.hpp>
#include <fixedpoint/portable/sin_q8_8_table.hpp>

namespace fixedpoint {
namespace portable {

// 2^16 times the number of turns, cut; modulo 2^16.
constexpr uint16_t phase_q8_8(int16_t angle) {
    // 2^16 / 2 pi = 40.74 with 16 bits behind the point. The kernel leaves the lowest of the
    // products out.
    return static_cast<uint16_t>(
        (static_cast<uint32_t>(static_cast<uint16_t>(angle) & 0xff) * 0x28be00 +
         static_cast<uint32_t>(angle >> 8) * 0x28be6100) >>
        16);
}

FIXEDPOINT_CONSTEXPR int16_t sine_of_phase_q8_8(uint16_t phase) {
    const uint16_t forward = phase & 0x7fff;
    const uint16_t position =
        static_cast<uint16_t>((forward & 0x4000) != 0 ? 0x7fff - forward : forward);
    const int16_t sine = static_cast<int16_t>(chord_of_bytes<SinQ8_8Table<>>(position) >> 5);
    return (phase & 0x8000) != 0 ? static_cast<int16_t>(-sine) : sine;
}

FIXEDPOINT_CONSTEXPR int16_t sin_q8_8(int16_t angle) {
    return sine_of_phase_q8_8(phase_q8_8(angle));
}
FIXEDPOINT_CONSTEXPR int16_t cos_q8_8(int16_t angle) {
    return sine_of_phase_q8_8(static_cast<uint16_t>(phase_q8_8(angle) + 0x4000));
}

}  // namespace portable
}  // namespace fixedpoint
