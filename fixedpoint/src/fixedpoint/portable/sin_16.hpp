// SPDX-License-Identifier: MIT
// sin and cos in 16-bit formats with up to 8 fraction bits, bit for bit as avr/sin_q8_8.inc
// computes them; within 0.548 ulp.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/chords_of_bytes.hpp>
#include <fixedpoint/portable/sin_q8_8_table.hpp>

namespace fixedpoint {
namespace portable {

// 2^16 times the number of turns, modulo 2^16. Products below the unit are truncated one by one.
template <int F>
FIXEDPOINT_CONSTEXPR uint16_t phase_16(int16_t angle) {
    // The turns in an ulp, 2^-F / (2 pi), in units of 2^-32: two signed bytes and the rest.
    constexpr int32_t turns = (683565276 + (int32_t(1) << F >> 1)) >> F;
    constexpr int8_t digit0 = static_cast<int8_t>(static_cast<uint8_t>(turns));
    constexpr int32_t above0 = (turns - digit0) >> 8;
    constexpr int8_t digit1 = static_cast<int8_t>(static_cast<uint8_t>(above0));
    constexpr int32_t above1 = (above0 - digit1) >> 8;
    const int32_t low = angle & 0xff, high = angle >> 8;
    const int32_t lower = (low * (digit1 < 0 ? -digit1 : digit1)) >> 8;
    return static_cast<uint16_t>(low * above1 + high * (256 * above1 + digit1) +
                                 (digit1 < 0 ? -lower : lower) + ((high * digit0) >> 8));
}

// The table includes half a unit of 2^-8.
template <int F>
FIXEDPOINT_CONSTEXPR int16_t sine_of_phase_16(uint16_t phase) {
    constexpr uint16_t more_than_half = 8 * ((1 << (8 - F)) - 1);
    const uint16_t forward = phase & 0x7fff;
    const uint16_t position =
        static_cast<uint16_t>((forward & 0x4000) != 0 ? 0x7fff - forward : forward);
    const int16_t sine = static_cast<int16_t>(
        (chord_of_bytes<SinQ8_8Table<>>(position) + more_than_half) >> (12 - F));
    return (phase & 0x8000) != 0 ? static_cast<int16_t>(-sine) : sine;
}

template <int F>
FIXEDPOINT_CONSTEXPR int16_t sin_16(int16_t angle) {
    return sine_of_phase_16<F>(phase_16<F>(angle));
}
template <int F>
FIXEDPOINT_CONSTEXPR int16_t cos_16(int16_t angle) {
    return sine_of_phase_16<F>(static_cast<uint16_t>(phase_16<F>(angle) + 0x4000));
}

}  // namespace portable
}  // namespace fixedpoint
