// SPDX-License-Identifier: MIT
// Sine and cosine of numbers of Q16.16 within 2^-51. Over all inputs, the result closest to a tie
// of Q16.16 is 2^-47.8 away from it.
#pragma once

#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/kernel/words.hpp>
#include <fixedpoint/portable/correct_rounding_table.hpp>

namespace fixedpoint {
namespace kernel {

// The magnitude of an angle as quarter turns and a rest of at most pi/4 + 2^-14 in either
// direction. The magnitude of the rest is in units of 2^-63, within 2 units.
struct QuarterTurns {
    uint16_t quarters;
    bool is_beyond;
    uint64_t rest;
};
FIXEDPOINT_IN_PLACE QuarterTurns nearest_quarter_turns(uint32_t positive) {
    constexpr uint32_t two_over_pi = 0xa2f9836e;  // 2^-32
    const uint16_t quarters =
        upper_half(upper_product<uint32_t, 0>(positive, two_over_pi) + (uint32_t(1) << 15));
    // The quarters in units of 2^-63, modulo 2, by five digits of pi/2; the lowest only carries.
    const uint32_t sum0 =
        multiply_halves(quarters, 0xc234) + upper_half(multiply_halves(quarters, 0xc4c6));
    const uint32_t sum1 = multiply_halves(quarters, 0x2168) + upper_half(sum0);
    const uint32_t sum2 = multiply_halves(quarters, 0xdaa2) + upper_half(sum1);
    const uint16_t sum3 = static_cast<uint16_t>(quarters * uint16_t(0xc90f) + upper_half(sum2));
    const uint32_t upper = join_halves(sum3, static_cast<uint16_t>(sum2));
    const uint32_t lower = join_halves(static_cast<uint16_t>(sum1), static_cast<uint16_t>(sum0));
    // The angle modulo 2, of which the lower word is 0: a shift by 15 would be a loop on the chip.
    const uint32_t scaled =
        (positive << 16 >> 1) | ((positive & 0x10000) != 0 ? uint32_t(1) << 31 : 0);
    const uint32_t beyond = scaled - upper - (lower != 0 ? 1 : 0);
    if (beyond >> 31 != 0) {
        return {quarters, false, join_words(upper - scaled, lower)};
    }
    return {quarters, true, join_words(beyond, 0 - lower)};
}

// The magnitude of the sine or cosine of `rest` 2^-63 in units of 2^-64; 1 is represented by one
// unit less.
//
// From the sine and the cosine of the nearest multiple A of 2^-6 and those of the difference t:
//     sin(A + t) = sin A + cos A sin t - sin A (1 - cos t).
FIXEDPOINT_IN_PLACE uint64_t precise_sine_of_rest(uint64_t rest, bool is_cosine) {
    const uint32_t rest1 = upper_word(rest), rest0 = static_cast<uint32_t>(rest);
    const uint8_t index =
        static_cast<uint8_t>(static_cast<uint16_t>(upper_half(rest1) + (uint16_t(1) << 8)) >> 9);
    const uint32_t difference1 =
        rest1 - (static_cast<uint32_t>(static_cast<uint16_t>(index << 9)) << 16);
    const bool is_below = difference1 >> 31 != 0;
    const uint32_t distance1 = is_below ? ~difference1 : difference1;
    const uint32_t distance0 = is_below ? ~rest0 : rest0;
    // |t| in units of 2^-71, its square in those of 2^-78.
    const uint32_t t1 = word_from_byte_3(distance1, distance0);
    const uint64_t t = join_words(t1, distance0 << 8);
    const uint64_t square = multiply_upper_halves<uint64_t, 0>(t, t);
    const uint32_t square1 = upper_word(square);
    // 4 (1/6 - t^2/120) in units of 2^-32, and t^3 (1/6 - t^2/120) in units of 2^-55.
    const uint32_t sixth =
        2863311531u - upper_half(static_cast<uint32_t>(upper_half(square1)) * 8738);
    const uint32_t cube =
        upper_product<uint32_t, 0>(t1, upper_product<uint32_t, 0>(square1, sixth));
    const uint64_t sine = t - join_words(upper_half(cube), cube << 16);
    // 8 (1/24 - t^2/720) in units of 2^-32, and t^4 (1/24 - t^2/720) in units of 2^-63.
    const uint32_t twelfth =
        1431655765u - upper_half(static_cast<uint32_t>(upper_half(square1)) * 2913);
    const uint32_t fourth =
        upper_product<uint32_t, 0>(upper_product<uint32_t, 0>(square1, square1), twelfth);
    // 2 (1 - cos t) in units of 2^-78.
    const uint64_t versine = square - join_words(upper_half(fourth), fourth << 16);

    // In units of 2^-64; 1 is represented by one unit less.
    const uint64_t* const entry = &portable::CorrectRoundingTable<>::unit[2 * index];
    const uint64_t base = read_program_memory(entry[is_cosine ? 1 : 0]);
    const uint64_t slope = read_program_memory(entry[is_cosine ? 0 : 1]);
    const uint64_t along = multiply_upper_halves<uint64_t, 0>(slope, sine);   // 2^-71
    const uint64_t bend = multiply_upper_halves<uint64_t, 0>(base, versine);  // 2^-79
    const uint32_t along1 = upper_word(along), bend1 = upper_word(bend);
    const uint64_t step = join_words(along1 >> 8, along1 << 24 | static_cast<uint32_t>(along) >> 8);
    const uint64_t fall =
        join_words(upper_half(bend1), bend1 << 16 | upper_half(static_cast<uint32_t>(bend)));
    // In units of 2^-63.
    const uint64_t change = is_below != is_cosine ? 0 - fall - step : step - fall;
    return base + change + change;
}

// The sine of an angle of Q16.16 plus `turned` quarter turns, 0 or 1. Its magnitude is in units of
// 2^-32, rounded downward to an even number; bit 0 is set if the sine is negative.
FIXEDPOINT_CONSTEXPR __attribute__((noinline)) uint32_t precise_sine(int32_t a, uint8_t turned) {
    const QuarterTurns angle = nearest_quarter_turns(magnitude(a));
    const uint8_t quadrant = static_cast<uint8_t>(angle.quarters + turned);
    const bool is_cosine = (quadrant & 1) != 0;
    // The cosine is even: neither the sign of the rest nor that of the angle matters.
    const bool is_below = (!is_cosine && !angle.is_beyond) != (turned == 0 && a < 0);
    const uint32_t sine = upper_word(precise_sine_of_rest(angle.rest, is_cosine));
    return is_below != ((quadrant & 2) != 0) ? sine | 1 : sine & ~uint32_t(1);
}

// The same, rounded to Q16.16. No exact result is a tie: only 0, 1 and -1 have that few digits.
FIXEDPOINT_CONSTEXPR int32_t nearest_sine(int32_t a, uint8_t turned) {
    const uint32_t sine = precise_sine(a, turned);
    const uint32_t rounded =
        static_cast<uint32_t>(upper_half(sine)) + (static_cast<uint16_t>(sine) >> 15);
    return with_sign<int32_t>(rounded, (sine & 1) != 0);
}

}  // namespace kernel
}  // namespace fixedpoint
