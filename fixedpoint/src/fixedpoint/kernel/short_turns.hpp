// SPDX-License-Identifier: MIT
// Compares angles with directions to 82 bits. No direction of Q16.16 is closer to a tie than
// 2^-79.6, unless it is one. Rotations whose tangents are short fractions reduce an angle to nearly
// 0, and they map vectors of integers to vectors of integers: nothing is rounded before the last
// rotation, by less than 2^-10.
#pragma once

#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/portable/short_turns_table.hpp>
#include <fixedpoint/portable/word128.hpp>

namespace fixedpoint {
namespace portable {

// An angle of ShortTurnsTable.
FIXEDPOINT_CONSTEXPR Word128 short_turn(uint8_t entry) {
    using Table = ShortTurnsTable<>;
    return (Word128(read_program_memory(Table::upper[entry])) << 24) +
           Word128(read_program_memory(Table::lower[entry]));
}
// floor(a b / 2^40).
FIXEDPOINT_CONSTEXPR uint64_t fraction_product(uint64_t a, uint64_t b) {
    return static_cast<uint64_t>((Word128(a) * b) >> 40);
}

// A vector in units of 2^-80.
struct Direction {
    Word128 along;
    Word128 across;
};
// Turned by the angle whose tangent is digit / 2^bits, and scaled. `across` may be negative if the
// digit is 0.
FIXEDPOINT_CONSTEXPR Direction turned_back(const Direction& v, uint8_t digit, int bits) {
    return {v.along + ((v.across * digit) >> bits), v.across - ((v.along * digit) >> bits)};
}

// Whether the direction of (x, y) is above an angle in units of 2^-88, with an error below 2^-82.
// Requires x >= 2^31, y <= x, an angle in [0, pi/4 + 2^-14], and that the two differ by at most
// 2^-26. The direction is compared exactly with one that depends only on the angle.
FIXEDPOINT_CONSTEXPR bool direction_exceeds(uint32_t y, uint32_t x, const Word128& angle) {
    Word128 rest = angle;
    // Half of the coordinates, as a coordinate reaches the sum of the two.
    Direction v = {Word128(x) << 47, Word128(y) << 47};
    uint8_t entry = 0;
    for (uint8_t stage = 0; stage < 4; ++stage) {
        using Table = ShortTurnsTable<>;
        const uint8_t upper = static_cast<uint8_t>(rest.high >> 16);
        const uint8_t lower = static_cast<uint8_t>(rest.high >> 8);
        uint8_t digit = stage == 1 ? upper : lower;
        if (stage == 0) {
            // tan t >= t + t^3 / 3
            const uint8_t square = static_cast<uint8_t>(static_cast<uint16_t>(upper) * upper >> 8);
            const uint8_t cube = static_cast<uint8_t>(static_cast<uint16_t>(square) * upper >> 8);
            digit = static_cast<uint8_t>(upper + (static_cast<uint16_t>(cube) * 85 >> 8)) & 0xf0;
        } else if (stage == 2) {
            digit = upper != 0 ? 0xf0 : digit & 0xf0;
        }
        v = turned_back(v, digit, stage < 2 ? 8 : 16);
        const uint8_t step = static_cast<uint8_t>((stage & 1) == 0 ? digit >> 4 : digit);
        rest = rest - short_turn(static_cast<uint8_t>(entry + step));
        entry = static_cast<uint8_t>(entry + read_program_memory(Table::entries[stage]));
    }
    // The tangent is t + t^3 / 3: the upper 40 bits of t in units of 2^-56.
    const uint64_t t = static_cast<uint64_t>(rest >> 32);
    const uint64_t cube = fraction_product(fraction_product(t, t), t);
    const Word128 tangent = rest + Word128(fraction_product(cube, 0x5555555555u));
    // v.across >= v.along tangent / 2^88, to 2^-136; v.across is below 2^65, or negative.
    const Word128 at_angle = v.along * static_cast<uint64_t>(tangent >> 32) +
                             ((v.along * static_cast<uint32_t>(tangent.low)) >> 32);
    return v.across.high >> 63 == 0 && (v.across << 56) >= at_angle;
}

// Whether the magnitude of the angle of (x, y) reaches a tie, which is given in units of 2^-32,
// modulo 1. Requires that the two differ by at most 2^-26.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR __attribute__((noinline)) bool angle_reaches(Raw y, Raw x, uint32_t tie) {
    using Table = ShortTurnsTable<>;
    const uint32_t height = magnitude(y), width = magnitude(x);
    const bool left = x < 0;
    const bool steep = height > width;
    uint32_t shorter = steep ? width : height, longer = steep ? height : width;
    while (static_cast<int32_t>(longer) >= 0) {
        longer <<= 1;
        shorter <<= 1;
    }
    // tie, pi - tie, pi/2 - tie or tie - pi/2, modulo 1.
    constexpr uint8_t pi = sizeof(Table::upper) / sizeof(Table::upper[0]) - 1, half_pi = pi - 1;
    const Word128 constant = short_turn(steep ? half_pi : left ? pi : 0);
    const Word128 whole = Word128(tie) << 56;
    const Word128 angle = steep != left ? constant - whole : whole - constant;
    const bool exceeded =
        direction_exceeds(shorter, longer, Word128(angle.high & 0xffffff, angle.low));
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
