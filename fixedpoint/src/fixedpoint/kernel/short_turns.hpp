// SPDX-License-Identifier: MIT
// Angles against directions to 61 bits. Turns whose tangents are short fractions bring an
// angle next to 0, and a vector of integers turned by them stays one: nothing is rounded before the
// last turn, by less than 2^-10.
#pragma once

#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/kernel/multiply_high.hpp>
#include <fixedpoint/kernel/words.hpp>
#include <fixedpoint/portable/correct_rounding_table.hpp>

namespace fixedpoint {
namespace kernel {

// An angle as atan(coarse / 32) + atan(fine / 2048) + rest; tan(rest) in units of 2^-64.
struct ShortTurns {
    uint8_t coarse;
    uint8_t fine;
    uint64_t tangent;
};

// Of an angle in units of 2^-64, from 0 to 2^-14 above pi/4; the tangent within 4 units, and below
// 2^-10.9.
FIXEDPOINT_CONSTEXPR ShortTurns short_turns(uint64_t angle) {
    using Table = portable::CorrectRoundingTable<>;
    // tan x >= x + x^3 (1/3 + 2/15 x^2).
    const uint8_t x = static_cast<uint8_t>(upper_word(angle) >> 24);
    const uint8_t x2 = static_cast<uint8_t>(x * x >> 8), x3 = static_cast<uint8_t>(x * x2 >> 8);
    uint8_t coarse = static_cast<uint8_t>(
        static_cast<uint8_t>(x + (x3 * static_cast<uint8_t>(85 + (x2 * 34 >> 8)) >> 8)) >> 3);
    while (coarse < 32 && angle >= read_program_memory(Table::coarse[coarse + 1])) ++coarse;
    uint64_t rest = angle - read_program_memory(Table::coarse[coarse]);
    const uint8_t fine = static_cast<uint8_t>(static_cast<uint16_t>(upper_word(rest) >> 16) >> 5);
    rest -= read_program_memory(Table::fine[fine]);
    // t + t^3 (1/3 + 2/15 t^2): t in units of 2^-42, its square in units of 2^-52.
    uint64_t fourfold = rest + rest;
    fourfold += fourfold;
    const uint32_t t = word_from_byte_3(upper_word(fourfold), static_cast<uint32_t>(fourfold));
    const uint32_t square = upper_product<uint32_t, 0>(t, t);
    uint64_t cube = multiply_words(t, square);
    cube += cube;
    cube += cube;
    const uint32_t factor =
        0x55555555 + upper_half(static_cast<uint32_t>(upper_half(square)) * 544);
    return {coarse, fine, rest + upper_product<uint32_t, 0>(upper_word(cube), factor)};
}

// Whether the direction of (x, y) is `angle`, in units of 2^-64, or beyond, where they differ by
// 2^-31 at most. Needs x > 0, y <= x (1 + 2^-30) and an angle as short_turns has it. Errs by less
// than 2^-61.
FIXEDPOINT_CONSTEXPR bool direction_reaches(uint32_t y, uint32_t x, uint64_t angle) {
    while (static_cast<uint8_t>((x | y) >> 24) == 0) {
        x <<= 8;
        y <<= 8;
    }
    while (((x | y) >> 31) == 0) {
        x <<= 1;
        y <<= 1;
    }
    // The direction of the angle less its rest, in units of 2^-13.
    const ShortTurns turns = short_turns(angle);
    const uint32_t along =
        (uint32_t(1) << 29) - (static_cast<uint32_t>(turns.coarse * turns.fine) << 13);
    const uint32_t across =
        (static_cast<uint32_t>(turns.coarse) << 24) + (static_cast<uint32_t>(turns.fine) << 18);
    const uint64_t turned_x = multiply_words(x, along) + multiply_words(y, across);
    const uint64_t turned_y = multiply_words(y, along) - multiply_words(x, across);
    const uint32_t y1 = upper_word(turned_y), y0 = static_cast<uint32_t>(turned_y);
    const uint32_t tangent1 = upper_word(turns.tangent),
                   tangent0 = static_cast<uint32_t>(turns.tangent);
    const int64_t above = static_cast<int64_t>(
        join_words(word_from_byte_3(y1, y0), y0 << 8) -
        multiply_high(turned_x, join_words(word_from_byte_3(tangent1, tangent0), tangent0 << 8)));
    return above >= 0;
}

struct AngleSide {
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t tie, int32_t y, int32_t x) {
        constexpr uint64_t pi = 0x243f6a8885a308d3, half_pi = 0x921fb54442d1846a;  // modulo 1
        const uint32_t height = magnitude(y), width = magnitude(x);
        const bool left = x < 0;
        const bool steep = height > width;
        const uint32_t low_word = static_cast<uint32_t>(tie);
        // The tie has the sign of y.
        const uint64_t angle = join_words(y < 0 ? 0 - low_word : low_word, 0);
        // Modulo 1.
        const uint64_t acute =
            steep ? (left ? angle - half_pi : half_pi - angle) : (left ? pi - angle : angle);
        const bool reached = steep ? direction_reaches(width, height, acute)
                                   : direction_reaches(height, width, acute);
        // Seen from the y axis, from the left and from below, it is the other side.
        return ((reached != steep) != left) != (y < 0);
    }
};
struct ArcTangentSide {
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t tie, int32_t a) {
        return AngleSide::reaches(tie, a, int32_t(1) << 16);
    }
};

}  // namespace kernel
}  // namespace fixedpoint
