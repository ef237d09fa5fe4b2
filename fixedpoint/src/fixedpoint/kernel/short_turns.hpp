// SPDX-License-Identifier: MIT
// Compares angles with directions to 61 bits. Rotations whose tangents are short fractions reduce
// an angle to nearly 0, and they map vectors of integers to vectors of integers: nothing is rounded
// before the last rotation, by less than 2^-10.
#pragma once

#include <fixedpoint/kernel/dispatch.hpp>
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

// Requires an angle in [0, pi/4 + 2^-14], in units of 2^-64. The tangent is within 4 units, and
// below 2^-10.9.
FIXEDPOINT_IN_PLACE ShortTurns short_turns(uint64_t angle) {
    using Table = portable::CorrectRoundingTable<>;
    // tan x >= x + x^3 (1/3 + 2/15 x^2): for every x the rest is in 0..68.5 2^-11.
    const uint8_t x = static_cast<uint8_t>(upper_word(angle) >> 24);
    const uint8_t x2 = static_cast<uint8_t>(static_cast<uint16_t>(x) * x >> 8);
    const uint8_t x3 = static_cast<uint8_t>(x * x2 >> 8);
    const uint8_t coarse = static_cast<uint8_t>(
        static_cast<uint8_t>(x + (x3 * static_cast<uint8_t>(85 + (x2 * 34 >> 8)) >> 8)) >> 3);
    uint64_t rest = angle - read_program_memory(Table::coarse[coarse]);
    const uint8_t fine = static_cast<uint8_t>(static_cast<uint16_t>(upper_word(rest) >> 16) >> 5);
    rest -= read_program_memory(Table::fine[fine]);
    // t + t^3 (1/3 + 2/15 t^2): t in units of 2^-42, its square in units of 2^-52.
    const uint32_t rest0 = static_cast<uint32_t>(rest);
    const uint8_t next = static_cast<uint8_t>(rest0 >> 16);
    const uint32_t t =
        word_from_byte_3(upper_word(rest), rest0) << 2 | static_cast<uint8_t>(next >> 6);
    const uint32_t square = upper_product<uint32_t, 0>(t, t);
    const uint32_t cube = upper_product<uint32_t, 0>(t, square << 1);  // 2^-63
    const uint32_t factor =
        0xaaaaaaaa + upper_half(static_cast<uint32_t>(upper_half(square)) * 1088);
    return {coarse, fine, rest + upper_product<uint32_t, 0>(cube, factor)};
}

// The smaller operand in the upper word and the larger one in the lower word, both scaled until the
// larger one has 32 bits. They must not both be 0.
FIXEDPOINT_CONSTEXPR __attribute__((noinline)) uint64_t shorter_and_longer(uint32_t a, uint32_t b) {
    if (a > b) {
        const uint32_t longer = a;
        a = b;
        b = longer;
    }
    while (static_cast<uint8_t>(b >> 24) == 0) {
        b <<= 8;
        a <<= 8;
    }
    while (static_cast<int32_t>(b) >= 0) {
        b <<= 1;
        a <<= 1;
    }
    return join_words(a, b);
}

// Whether the direction of (x, y) is at least `angle`, in units of 2^-64, with an error below
// 2^-61. Requires x >= 2^31, y <= x, an angle that short_turns accepts, and that the two differ by
// at most 2^-26.
FIXEDPOINT_IN_PLACE bool direction_reaches(uint32_t y, uint32_t x, uint64_t angle) {
    // The direction of the angle without its rest, in units of 2^-28: (1 - c f / 2^16, c / 32 + f /
    // 2048).
    const ShortTurns turns = short_turns(angle);
    const uint32_t along =
        (uint32_t(1) << 28) -
        (static_cast<uint32_t>(static_cast<uint16_t>(turns.coarse * turns.fine << 4)) << 8);
    const uint32_t across =
        static_cast<uint32_t>(static_cast<uint16_t>((turns.coarse << 7) + (turns.fine << 1))) << 16;
    const uint64_t turned_x = multiply_words(x, along) + multiply_words(y, across);
    const uint64_t turned_y = multiply_words(y, along) - multiply_words(x, across);
    const uint32_t y1 = upper_word(turned_y), y0 = static_cast<uint32_t>(turned_y);
    const uint32_t tangent1 = upper_word(turns.tangent),
                   tangent0 = static_cast<uint32_t>(turns.tangent);
    // The upper half of the product of 2^8 times the tangent, below 2^61.1, and turned_x, below
    // 2^61.
    const uint32_t x1 = upper_word(turned_x), slope1 = word_from_byte_3(tangent1, tangent0);
    const uint32_t lower = upper_product<uint32_t, 0>(static_cast<uint32_t>(turned_x), slope1) +
                           upper_product<uint32_t, 0>(x1, tangent0 << 8);
    const uint64_t above =
        join_words(word_from_byte_3(y1, y0), y0 << 8) - (multiply_words(x1, slope1) + lower);
    return (upper_word(above) >> 31) == 0;
}

struct AngleSide {
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t tie, int32_t y, int32_t x) {
        const uint32_t low_word = static_cast<uint32_t>(tie);
        // The tie has the sign of y. Mirroring at the x axis swaps the sides.
        return is_reached(y < 0 ? 0 - low_word : low_word, y, x) != (y < 0);
    }
    // Whether the magnitude of the angle reaches that of the tie, which is given modulo 1.
    static FIXEDPOINT_IN_PLACE bool is_reached(uint32_t tie, int32_t y, int32_t x) {
        constexpr uint32_t pi[2] = {0x85a308d3, 0x243f6a88};  // modulo 1
        constexpr uint32_t half_pi[2] = {0x42d1846a, 0x921fb544};
        const uint32_t height = magnitude(y), width = magnitude(x);
        const bool left = x < 0;
        const bool steep = height > width;
        const uint64_t coordinates = shorter_and_longer(height, width);
        // tie, pi - tie, half_pi - tie or tie - half_pi.
        const uint32_t upper =
            steep ? (left ? tie + ~half_pi[1] : half_pi[1] - tie) : (left ? pi[1] - tie : tie);
        const uint32_t lower = steep ? (left ? 0 - half_pi[0] : half_pi[0]) : (left ? pi[0] : 0);
        const bool reached = direction_reaches(
            upper_word(coordinates), static_cast<uint32_t>(coordinates), join_words(upper, lower));
        // Measuring from the y axis or from the left swaps the sides.
        return (reached != steep) != left;
    }
};
struct ArcTangentSide {
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t tie, int32_t a) {
        return AngleSide::reaches(tie, a, int32_t(1) << 16);
    }
};

}  // namespace kernel
}  // namespace fixedpoint
