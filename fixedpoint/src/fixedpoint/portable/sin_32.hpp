// SPDX-License-Identifier: MIT
// Sine and cosine of 32-bit numbers of F fraction bits, bit for bit as avr/sin_32.S computes them.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/cubic_32.hpp>
#include <fixedpoint/portable/round.hpp>
#include <fixedpoint/portable/sine_32_table.hpp>

namespace fixedpoint {
namespace portable {

// The angle in quarter turns, modulo 256, with 40 fraction bits; the lowest are zero if they do not
// matter.
template <int F>
FIXEDPOINT_CONSTEXPR uint64_t quarter_turns_32(int32_t angle) {
    // 2/pi 2^(72 - F) or, without the lowest byte, 2/pi 2^(64 - F).
    constexpr uint64_t two_over_pi = 0xa2f9836e4e441529;
    constexpr int lowest_byte = is_coarse_32<F>() ? 1 : 0;
    constexpr uint64_t multiplier = two_over_pi >> (F - 8 * (1 - lowest_byte));
    constexpr int first = F > 24 ? 0 : F > 15 ? 1 : F > 8 ? 2 : 3;

    uint64_t turns = uint64_t(2) << 8 * first;
    for (int i = 0; i < 4; ++i) {
        const uint32_t digit = static_cast<uint32_t>(angle) >> 8 * i & 0xff;
        for (int column = first - 1; column < 6; ++column) {
            const int j = column + 4 - lowest_byte - i;
            if (j < 0 || j > 7) continue;
            const uint64_t product = digit * static_cast<uint32_t>(multiplier >> 8 * j & 0xff);
            turns += column < first ? (product >> 8) << 8 * first : product << 8 * column;
        }
    }
    if (angle < 0) {
        const uint64_t whole = multiplier << 8 * lowest_byte;
        turns -= whole >> 8 * first << 8 * first;
    }
    return turns & 0xffffffffffff;
}

// The position in the table; odd quarters run backwards.
constexpr uint64_t position_of_quarter_turns(uint64_t turns) {
    return ((turns >> 40 & 1) != 0 ? ~turns : turns) & 0xffffffffff;
}

// The sine of quarter turns.
template <int F>
FIXEDPOINT_CONSTEXPR int32_t sine_of_quarter_turns_32(uint64_t turns) {
    constexpr bool is_coarse = is_coarse_32<F>();
    const uint64_t position = position_of_quarter_turns(turns);
    uint32_t sine = 0;
    if (is_coarse) {
        constexpr int surplus = is_coarse ? 31 - F : 1;
        const uint32_t core = cubic_32<Sine32Table<>>(static_cast<uint32_t>(position >> 8));
        sine = static_cast<uint32_t>(((core >> (surplus - 1)) + 1) >> 1);
    } else {
        constexpr int surplus = 39 - F;
        const Cubic40 core = cubic_40<Sine32Table<>>(static_cast<uint32_t>(position >> 8));
        const uint64_t value = core.value + (core.slope * (position & 0xff) >> 8);
        sine = static_cast<uint32_t>(((value >> (surplus - 1)) + 1) >> 1);
    }
    const bool negative = (turns >> 41 & 1) != 0;
    if (F > 30 && sine >> 31 != 0)
        return negative ? RawLimits<int32_t>::min : RawLimits<int32_t>::max;
    const int32_t result = static_cast<int32_t>(sine);
    return negative ? -result : result;
}

constexpr uint64_t one_quarter_turn_32 = uint64_t(1) << 40;

template <int F>
FIXEDPOINT_CONSTEXPR int32_t sin_32(int32_t angle) {
    return sine_of_quarter_turns_32<F>(quarter_turns_32<F>(angle));
}
template <int F>
FIXEDPOINT_CONSTEXPR int32_t cos_32(int32_t angle) {
    return sine_of_quarter_turns_32<F>(quarter_turns_32<F>(angle) + one_quarter_turn_32);
}

}  // namespace portable
}  // namespace fixedpoint
