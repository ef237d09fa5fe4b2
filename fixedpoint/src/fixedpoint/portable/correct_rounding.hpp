// SPDX-License-Identifier: MIT
// On which side of a tie an exact result lies, for numbers of Q16.16, and the rounding that depends
// on it.
//
// A result in units of 2^-32 with an error below one unit decides the rounding to 16 or fewer
// fraction bits, unless it is itself a tie: from one unit above the tie on, the exact result is
// above it; from one unit below, it is not. About once in 2^16 results it is a tie, and a `reaches`
// decides whether the exact result is at least the tie, given in units of 2^-32. Some are exact, by
// integers; the others evaluate the function with an error far below the smallest distance of any
// result from a tie.
#pragma once

#include <fixedpoint/portable/convert.hpp>
#include <fixedpoint/portable/elementary.hpp>
#include <fixedpoint/portable/sin.hpp>

namespace fixedpoint {
namespace portable {

// The exact result, from which `wide` 2^-32 must differ by less than 2^-32, rounded to F fraction
// bits, half up, and saturated.
template <class Raw, int F, class Side, class... Operands>
FIXEDPOINT_CONSTEXPR Raw correctly_rounded(int64_t wide, Operands... a) {
    static_assert(F <= 16 && RawLimits<Raw>::width - F <= 16,
                  "CorrectlyRounded needs a format whose numbers are all numbers of Q16.16.");
    constexpr uint32_t half = uint32_t(1) << (31 - F);
    const Converted<Raw> up = convert_saturated<Raw, F, int64_t, 32>(wide);
    const bool is_tie = (static_cast<uint32_t>(wide) & (2 * half - 1)) == half;
    // Results below the smallest number saturate, whichever side of the tie they are on.
    if (!is_tie || !up.fits || up.number == RawLimits<Raw>::min) return up.number;
    return Side::reaches(wide, convert<int32_t, 16, Raw, F>(a)...)
               ? up.number
               : static_cast<Raw>(up.number - 1);
}

// 2 r in Q16.16 for a tie r given in units of 2^-32.
constexpr int64_t twice_in_q16_16(int64_t tie) { return tie / (1 << 15); }

// a 2^35 >= (2 r)^3, decided by their small difference modulo 2^64.
struct CubeRootSide {
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t tie, int32_t a) {
        const uint64_t root = static_cast<uint64_t>(twice_in_q16_16(tie));
        const uint64_t above =
            (static_cast<uint64_t>(static_cast<int64_t>(a)) << 35) - root * root * root;
        return above >> 63 == 0;
    }
};
// v / sqrt(v^2 + a^2 + b^2) >= r if v^2 2^34 >= (2 r)^2 (v^2 + a^2 + b^2), for v and r of one sign.
struct UnitComponentSide {
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t tie, int32_t v, int32_t a, int32_t b) {
        const uint64_t component = static_cast<uint64_t>(twice_in_q16_16(v < 0 ? -tie : tie));
        const Word128 exact = Word128(square(v)) << 34;
        const Word128 at_tie = Word128(square(v) + square(a) + square(b)) * (component * component);
        return v < 0 ? !(exact > at_tie) : !(exact < at_tie);
    }
};

// The fraction bits to which the 128-bit cores are accurate.
constexpr int precise_fraction = 60;

// Cosine and sine of a, a number of Q16.16, with 126 fraction bits.
FIXEDPOINT_CONSTEXPR UnitVector<Word128> precise_unit_vector(int32_t a) {
    constexpr uint64_t two_over_pi = 683565276;  // 2^-30
    const uint64_t positive = magnitude(a);
    const uint64_t quarters = (positive * two_over_pi + (uint64_t(1) << 45)) >> 46;
    const UnitVector<Word128> unit = unit_vector<precise_fraction>(
        (Word128(positive) << 110) - CordicConstants<Word128>::half_pi() * quarters);
    const bool odd = (quarters & 1) != 0, beyond = (quarters & 2) != 0;
    const Word128 cosine = odd ? unit.sine : unit.cosine;
    const Word128 sine = odd ? unit.cosine : unit.sine;
    return {beyond != odd ? negated(cosine) : cosine, beyond != (a < 0) ? negated(sine) : sine};
}
constexpr bool is_at_least(const Word128& a, const Word128& b) { return !is_negative(a - b); }

// Compares the sine with the tie times the cosine, both with 94 fraction bits.
struct TangentSide {
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t tie, int32_t a) {
        const UnitVector<Word128> unit = precise_unit_vector(a);
        const bool left = is_negative(unit.cosine);
        const Word128 cosine = left ? negated(unit.cosine) : unit.cosine;
        const Word128 sine = left ? negated(unit.sine) : unit.sine;
        const Word128 product = Word128(cosine.high) * magnitude(tie);
        return is_at_least(shift_right_signed(sine, 32), tie < 0 ? negated(product) : product);
    }
};
// The logarithm of a 2^-16 as the logarithm of a mantissa in [1, 2) plus a multiple of that of 2,
// with 58 fraction bits.
template <class OfMantissa, int64_t of_two>
struct LogarithmSide {
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t tie, int32_t a) {
        constexpr uint64_t one = uint64_t(1) << 58;
        uint64_t mantissa = static_cast<uint64_t>(a) << 27;
        int exponent = 15;
        for (; mantissa < one; --exponent) mantissa <<= 1;
        return OfMantissa::apply(static_cast<int64_t>(mantissa)) + exponent * of_two >=
               tie * (int64_t(1) << 26);
    }
};
template <class Function>
struct OfMantissa58 {
    static FIXEDPOINT_CONSTEXPR int64_t apply(int64_t mantissa) {
        return Function::template apply<int64_t, 58>(mantissa).number;
    }
};
using Log2Side = LogarithmSide<OfMantissa58<Log2>, int64_t(1) << 58>;
using Log10Side = LogarithmSide<OfMantissa58<Log10>, 86765988883177455>;

// For functions with few operands whose results are in range: for each of those, the side was
// compared with an evaluation of 113 bits. Powers have too many pairs for that: they are correct
// unless one is closer to a tie than 2^-48. A power that is a tie, such as 1.5^17, evaluates to
// exactly the tie.
template <class Function>
struct WideSide {
    template <class... Operands>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t tie, Operands... a) {
        return Function::template apply<int64_t, 48>(convert<int64_t, 48, int32_t, 16>(a)...)
                   .number >= tie * (int64_t(1) << 16);
    }
};

}  // namespace portable
}  // namespace fixedpoint
