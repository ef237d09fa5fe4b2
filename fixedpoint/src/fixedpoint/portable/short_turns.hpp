// SPDX-License-Identifier: MIT
// Angles against directions and sines to 61 bits. Turns whose tangents are short fractions bring an
// angle next to 0, and a vector of integers turned by them stays one: nothing is rounded before the
// last turn, by less than 2^-10.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/correct_rounding_table.hpp>
#include <fixedpoint/portable/multiply_words.hpp>

namespace fixedpoint {
namespace portable {

// The chip's compiler shifts 64 bits by a loop over bytes, even by four of them. Its calling
// convention has the upper word of this argument where the result belongs.
#ifdef __AVR__
__attribute__((naked, noinline)) inline uint32_t load_upper_word(uint64_t) { __asm__("ret"); }
constexpr uint32_t upper_word(uint64_t a) {
    return __builtin_constant_p(a) ? static_cast<uint32_t>(a >> 32) : load_upper_word(a);
}
#else
constexpr uint32_t upper_word(uint64_t a) { return static_cast<uint32_t>(a >> 32); }
#endif

// An angle as atan(coarse / 32) + atan(fine / 2048) + rest; tan(rest) in units of 2^-64.
struct ShortTurns {
    uint8_t coarse;
    uint8_t fine;
    uint64_t tangent;
};

// Of an angle in units of 2^-64, from 0 to 2^-14 above pi/4; the tangent within 4 units, and below
// 2^-10.9.
FIXEDPOINT_CONSTEXPR ShortTurns short_turns(uint64_t angle) {
    using Table = CorrectRoundingTable<>;
    // tan x >= x.
    uint8_t coarse = static_cast<uint8_t>(static_cast<uint8_t>(upper_word(angle) >> 24) >> 3);
    while (coarse < 32 && angle >= read_program_memory(Table::coarse[coarse + 1])) ++coarse;
    uint64_t rest = angle - read_program_memory(Table::coarse[coarse]);
    const uint8_t fine = static_cast<uint8_t>(static_cast<uint16_t>(upper_word(rest) >> 16) >> 5);
    rest -= read_program_memory(Table::fine[fine]);
    // t + t^3 (1/3 + 2/15 t^2): t in units of 2^-42, its square in units of 2^-52.
    const uint32_t t = static_cast<uint32_t>(rest >> 22);
    const uint32_t square = upper_word(multiply_words(t, t));
    const uint32_t cube = upper_word(multiply_words(t, square) << 2);
    const uint32_t factor = 0x55555555 + (static_cast<uint16_t>(square >> 16) * uint32_t(34) >> 12);
    return {coarse, fine, rest + upper_word(multiply_words(cube, factor))};
}

// a b / 2^64, at most 3 less.
FIXEDPOINT_CONSTEXPR uint64_t multiply_high(uint64_t a, uint64_t b) {
    const uint32_t a1 = upper_word(a), b1 = upper_word(b);
    return multiply_words(a1, b1) + upper_word(multiply_words(static_cast<uint32_t>(a), b1)) +
           upper_word(multiply_words(a1, static_cast<uint32_t>(b)));
}

// Whether the direction of (x, y) is `angle`, in units of 2^-64, or beyond, where they differ by
// 2^-31 at most. Needs x > 0, y <= x (1 + 2^-30) and an angle as short_turns has it. Errs by less
// than 2^-61.
FIXEDPOINT_CONSTEXPR bool direction_reaches(uint32_t y, uint32_t x, uint64_t angle) {
    while (((x | y) >> 31) == 0) {
        x <<= 1;
        y <<= 1;
    }
    const ShortTurns turns = short_turns(angle);
    const uint64_t x1 = (uint64_t(x) << 5) + multiply_words(y, turns.coarse);
    const int64_t y1 = static_cast<int64_t>((uint64_t(y) << 5) - multiply_words(x, turns.coarse));
    const uint64_t x2 = (x1 << 11) + static_cast<uint64_t>(y1 * turns.fine);
    const int64_t y2 = y1 * 2048 - static_cast<int64_t>(x1 * turns.fine);
    return y2 * (int32_t(1) << 23) >=
           static_cast<int64_t>(multiply_high(x2 << 13, turns.tangent << 10));
}

// Whether the sine or cosine of an angle as short_turns has it is `tie` 2^-17 or more, where they
// differ by less than 2^-32. Errs by less than 2^-60.
//
// The vector (65536 - coarse fine, 2048 coarse + 32 fine) is the direction of the angle less its
// rest, and of length K, whose square is an integer. The sine times K is s = (y + x tan t) cos t.
// Of s^2 and (tie K)^2 the difference is below 4: in units of 2^-60 their lowest 64 bits tell which
// is more.
FIXEDPOINT_CONSTEXPR bool sine_reaches(uint32_t tie, uint64_t angle, bool is_cosine) {
    const ShortTurns turns = short_turns(angle);
    const uint32_t x = (uint32_t(1) << 16) - static_cast<uint16_t>(turns.coarse * turns.fine);
    const uint32_t y = turns.coarse * uint32_t(2048) + turns.fine * uint32_t(32);
    const uint64_t tangent = turns.tangent << 9;
    const uint32_t tangent0 = static_cast<uint32_t>(tangent), tangent1 = upper_word(tangent);
    // In units of 2^-46.
    const uint32_t factor = (is_cosine ? y : x) << 5;
    const uint64_t part =
        multiply_words(factor, tangent1) + upper_word(multiply_words(factor, tangent0));
    const uint64_t whole = uint64_t((is_cosine ? x : y) << 14) << 32;
    const uint64_t slanted = is_cosine ? whole - part : whole + part;
    // 1 - cos t = q - 3/2 q^2 of q = tan^2 t / 2, in units of 2^-83 and the square in those of
    // 2^-64.
    const uint64_t q =
        multiply_words(tangent1, tangent1) + upper_word(multiply_words(tangent1, tangent0) << 1);
    const uint32_t short_q = upper_word(q) >> 3;
    const uint32_t square_of_q = upper_word(multiply_words(short_q, short_q));
    const uint64_t versine = q - (uint64_t(square_of_q + (square_of_q >> 1)) << 19);
    const uint64_t sine = slanted - (multiply_high(slanted, versine) >> 19);

    const uint32_t s0 = static_cast<uint32_t>(sine), s1 = upper_word(sine);
    const uint64_t square_of_sine = (uint64_t(s1 * s1) << 32) + (multiply_words(s1, s0) << 1) +
                                    upper_word(multiply_words(s0, s0));
    const uint64_t square_of_length = multiply_words(x, x) + multiply_words(y, y);
    const uint64_t square_of_tie = multiply_words(tie << 13, tie << 13) * square_of_length;
    return static_cast<int64_t>(square_of_sine - square_of_tie) >= 0;
}

}  // namespace portable
}  // namespace fixedpoint
