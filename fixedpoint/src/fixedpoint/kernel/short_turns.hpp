// SPDX-License-Identifier: MIT
// Compares angles with directions to 83 bits. No direction of Q16.16 is closer to a tie than
// 2^-79.6, unless it is one. Rotations whose tangents are short fractions reduce an angle to nearly
// 0, and they map vectors of integers to vectors of integers: nothing is rounded before the last
// rotation, by less than 2^-10.
#pragma once

#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/kernel/words.hpp>
#include <fixedpoint/portable/correct_rounding_table.hpp>

namespace fixedpoint {
namespace kernel {

// In units of 2^-64 and 2^-96.
struct WideAngle {
    uint64_t upper;
    uint32_t lower;
};

// An angle is atan(coarse / 32) + atan(fine / 2048) + rest; `tangent` is that of the rest.
struct ShortTurns {
    uint8_t coarse;
    uint8_t fine;
    WideAngle tangent;
};

// floor(a b / 2^64).
FIXEDPOINT_CONSTEXPR __attribute__((noinline)) uint64_t exact_upper_product(uint64_t a,
                                                                            uint64_t b) {
    const uint32_t a1 = upper_word(a), a0 = static_cast<uint32_t>(a);
    const uint32_t b1 = upper_word(b), b0 = static_cast<uint32_t>(b);
    const uint64_t one = multiply_words(a1, b0) + upper_product<uint32_t, 0>(a0, b0);
    const uint64_t other = multiply_words(a0, b1) + static_cast<uint32_t>(one);
    return multiply_words(a1, b1) + upper_word(one) + upper_word(other);
}

FIXEDPOINT_IN_PLACE void reduce(WideAngle* angle, const uint64_t* upper, const uint32_t* lower) {
    const uint32_t part = read_program_memory(lower[0]);
    angle->upper -= read_program_memory(upper[0]);
    if (angle->lower < part) --angle->upper;
    angle->lower -= part;
}

// Requires an angle in [0, pi/4 + 2^-14]. The tangent is within 2^-83, and below 2^-10.9.
FIXEDPOINT_IN_PLACE ShortTurns short_turns(WideAngle angle) {
    using Table = portable::CorrectRoundingTable<>;
    // tan x >= x + x^3 (1/3 + 2/15 x^2): for every x the rest is in 0..68.5 2^-11.
    const uint8_t x = static_cast<uint8_t>(upper_word(angle.upper) >> 24);
    const uint8_t x2 = static_cast<uint8_t>(static_cast<uint16_t>(x) * x >> 8);
    const uint8_t x3 = static_cast<uint8_t>(x * x2 >> 8);
    const uint8_t coarse = static_cast<uint8_t>(
        static_cast<uint8_t>(x + (x3 * static_cast<uint8_t>(85 + (x2 * 34 >> 8)) >> 8)) >> 3);
    reduce(&angle, &Table::coarse[coarse], &Table::coarse_below[coarse]);
    const uint8_t fine = static_cast<uint8_t>(upper_half(upper_word(angle.upper)) >> 5);
    reduce(&angle, &Table::fine[fine], &Table::fine_below[fine]);
    // t + t^3 (1/3 + t^2 (2/15 + 17/315 t^2)): t in units of 2^-72, its square in units of 2^-80
    // and its cube in units of 2^-88.
    const uint32_t rest1 = upper_word(angle.upper), rest0 = static_cast<uint32_t>(angle.upper);
    const uint64_t t =
        join_words(word_from_byte_3(rest1, rest0), word_from_byte_3(rest0, angle.lower));
    const uint64_t square = exact_upper_product(t, t);
    const uint32_t square1 = upper_word(square);
    const uint64_t bend = multiply_words(
        square1, 0x22222222 + (static_cast<uint16_t>(upper_half(square1) * 14) >> 8));
    const uint32_t bend1 = upper_word(bend);
    const uint64_t factor =
        0x5555555555555555u +
        join_words(upper_half(bend1), bend1 << 16 | upper_half(static_cast<uint32_t>(bend)));
    const uint64_t rise = exact_upper_product(exact_upper_product(t, square), factor);
    const uint32_t rise0 = static_cast<uint32_t>(rise);
    const uint32_t lower = angle.lower + (rise0 << 8);
    angle.upper += word_from_byte_3(upper_word(rise), rise0);
    if (lower < angle.lower) ++angle.upper;
    angle.lower = lower;
    return {coarse, fine, angle};
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

// Whether the direction of (x, y) is above `angle`, with an error below 2^-83. Requires x >= 2^31,
// y <= x, an angle that short_turns accepts, and that the two differ by at most 2^-26. The
// direction is compared exactly with one that depends only on the angle: the results are right for
// all directions if they are right for the two next to the angle, of all that there are.
FIXEDPOINT_IN_PLACE bool direction_exceeds(uint32_t y, uint32_t x, const WideAngle& angle) {
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
    // floor(turned_x tangent / 2^96). As turned_x is below 2^61 and the tangent below 2^85.1, no
    // sum exceeds 64 bits.
    const uint32_t slope = upper_word(turns.tangent.upper);
    const uint64_t at_angle =
        multiply_words(upper_word(turned_x), slope) +
        upper_word(
            multiply_words(static_cast<uint32_t>(turned_x), slope) +
            exact_upper_product(turned_x, join_words(static_cast<uint32_t>(turns.tangent.upper),
                                                     turns.tangent.lower)));
    // turned_y > at_angle.
    return (upper_word(at_angle - turned_y) >> 31) != 0;
}

}  // namespace kernel

namespace portable {
// Whether the magnitude of the angle of (x, y) reaches a tie, which is given in units of 2^-32,
// modulo 1. Requires that the two differ by at most 2^-26.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR __attribute__((noinline)) bool angle_reaches(Raw y, Raw x, uint32_t tie) {
    using kernel::join_words;
    // Modulo 1, in words.
    constexpr uint32_t pi[3] = {0x13198a2e, 0x85a308d3, 0x243f6a88};
    constexpr uint32_t half_pi[3] = {0x898cc517, 0x42d18469, 0x921fb544};
    const uint32_t height = magnitude(y), width = magnitude(x);
    const bool left = x < 0;
    const bool steep = height > width;
    const uint64_t coordinates = kernel::shorter_and_longer(height, width);
    // tie, pi - tie, half_pi - tie or tie - half_pi: -half_pi is the complement of the upper words,
    // as the lowest one is not 0.
    const uint32_t upper =
        steep ? (left ? tie + ~half_pi[2] : half_pi[2] - tie) : (left ? pi[2] - tie : tie);
    const uint32_t middle = steep ? (left ? ~half_pi[1] : half_pi[1]) : (left ? pi[1] : 0);
    const uint32_t lower = steep ? (left ? 0 - half_pi[0] : half_pi[0]) : (left ? pi[0] : 0);
    const bool exceeded = kernel::direction_exceeds(kernel::upper_word(coordinates),
                                                    static_cast<uint32_t>(coordinates),
                                                    {join_words(upper, middle), lower});
    // Measuring from the y axis or from the left swaps the sides.
    return (exceeded != steep) != left;
}
}  // namespace portable

namespace kernel {
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR bool angle_reaches(Raw y, Raw x, uint32_t tie) {
    return portable::angle_reaches<Raw, F>(y, x, tie);
}
}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_SIDE_KERNELS(FIXEDPOINT_DISPATCH)

namespace fixedpoint {
namespace kernel {

struct AngleSide {
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t tie, int32_t y, int32_t x) {
        const uint32_t low_word = static_cast<uint32_t>(tie);
        // The tie has the sign of y. Mirroring at the x axis swaps the sides.
        return angle_reaches<int32_t, 16>(y, x, y < 0 ? 0 - low_word : low_word) != (y < 0);
    }
};
struct ArcTangentSide {
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t tie, int32_t a) {
        return AngleSide::reaches(tie, a, int32_t(1) << 16);
    }
};

}  // namespace kernel
}  // namespace fixedpoint
