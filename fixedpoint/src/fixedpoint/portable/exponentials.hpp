// SPDX-License-Identifier: MIT
// exp2, expm1, sinh, cosh, tanh: functions of e^x, faithful (error below 0.75 ulp), saturated.
#pragma once

#include <fixedpoint/portable/evaluation.hpp>
#include <fixedpoint/portable/exp.hpp>

namespace fixedpoint {
namespace portable {

// mantissa 2^exponent, the mantissa from 1 to 2.1 with Bits - 3 fraction bits.
template <class Word>
struct Power {
    Word mantissa;
    int exponent;
};

// From here on e^x exceeds every 64-bit format and e^-x is 0 in all of them: above 2^66, and below
// 2^-66.
constexpr int largest_exponent = 46;

// e^x or e^-x with a relative error of 2^-(P + 1). x has Bits - 6 fraction bits; above 46 it counts
// as 46.
template <class Raw, int P = RawLimits<Raw>::width + 2>
FIXEDPOINT_CONSTEXPR Power<DoubleWord<Raw>> exponential(DoubleWord<Raw> x, bool negative) {
    using Word = DoubleWord<Raw>;
    constexpr int bits = word_bits<Raw>();
    constexpr Word largest = Word(uint8_t(largest_exponent)) << (bits - 6);
    const Word ln2 = PseudoDivisionConstants<Word>::ln2();
    if (x > largest) x = largest;
    // k = floor(x / ln 2), or possibly one less if x is less than 0.04 above a multiple of ln 2.
    const int32_t sixty_fourths = static_cast<int32_t>(static_cast<uint16_t>(x >> (bits - 12)));
    const int32_t floored = negative ? -sixty_fourths - 1 : sixty_fourths;
    const int k = static_cast<int>((floored * 1477 - 1000) >> 16);
    const Word multiple = ln2 * magnitude(static_cast<int16_t>(k));
    const Word rest = negative ? multiple - x : k < 0 ? x + multiple : x - multiple;
    return {exponential_mantissa<P>(rest), k};
}

// The power in units of 2^-unit, saturated to 2^limit of them. Requires limit < Bits - 3.
template <int limit, class Word>
FIXEDPOINT_CONSTEXPR Word in_units(const Power<Word>& power, int unit) {
    constexpr int bits = static_cast<int>(8 * sizeof(Word));
    const int surplus = bits - 3 - unit - power.exponent;
    return surplus < bits - 3 - limit ? Word(uint8_t(1)) << limit
           : surplus >= bits          ? Word(uint8_t(0))
                                      : power.mantissa >> surplus;
}

// The guard bits with which powers are added and subtracted, and a limit that exceeds every format
// even when halved.
constexpr int power_guard = 8;
template <class Raw>
constexpr int power_limit() {
    return RawLimits<Raw>::width + 2 + power_guard;
}

// e^a or e^-|a| in units of 2^-(F + power_guard).
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR DoubleWord<Raw> guarded_exponential(Raw a, bool negative) {
    constexpr int up = word_bits<Raw>() - 6 - F;
    const Unsigned<Raw> positive = magnitude(a);
    // Above the largest exponent the result no longer changes, and x must not overflow its word.
    const bool beyond = F < RawLimits<Raw>::width - 6 &&
                        (positive >> (F < RawLimits<Raw>::width - 6 ? F : 0)) >= largest_exponent;
    const DoubleWord<Raw> x = beyond ? DoubleWord<Raw>(uint8_t(largest_exponent))
                                           << (word_bits<Raw>() - 6)
                                     : DoubleWord<Raw>(positive) << up;
    return in_units<power_limit<Raw>()>(exponential<Raw>(x, negative), F + power_guard);
}

// 2^a.
struct Exp2 {
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Evaluation<Raw> apply(Raw a) {
        using Word = DoubleWord<Raw>;
        const Raw whole = static_cast<Raw>(a >> F);
        if (whole > 66) return {RawLimits<Raw>::max, Outcome::overflow};
        if (whole < -66) return {0, Outcome::in_range};
        // The fraction in units of 2^-W, times ln 2.
        const Unsigned<Raw> fraction =
            F == 0 ? Unsigned<Raw>(0)
                   : static_cast<Unsigned<Raw>>(static_cast<Unsigned<Raw>>(a)
                                                << (RawLimits<Raw>::width - F) %
                                                       RawLimits<Raw>::width);
        const Word rest =
            multiply_by_half_word<Raw>(PseudoDivisionConstants<Word>::ln2(), fraction);
        const Power<Word> power = {exponential_mantissa<RawLimits<Raw>::width + 2>(rest),
                                   static_cast<int>(whole)};
        return evaluation<Raw>(in_units<power_limit<Raw>()>(power, F + power_guard), power_guard,
                               false);
    }
};

// e^a - 1, with all its digits near 0.
struct Expm1 {
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Evaluation<Raw> apply(Raw a) {
        using Word = DoubleWord<Raw>;
        const Word one = Word(uint8_t(1)) << (F + power_guard);
        const Word power = guarded_exponential<Raw, F>(a, a < 0);
        // The error of a power close to 1 must not change the sign.
        const bool negative = power < one;
        return evaluation<Raw>(negative ? one - power : power - one, power_guard, negative);
    }
};

struct Sinh {
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Evaluation<Raw> apply(Raw a) {
        if (a == 0) return {0, Outcome::in_range};
        return evaluation<Raw>(
            guarded_exponential<Raw, F>(a, false) - guarded_exponential<Raw, F>(a, true),
            power_guard + 1, a < 0);
    }
};
struct Cosh {
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Evaluation<Raw> apply(Raw a) {
        return evaluation<Raw>(
            guarded_exponential<Raw, F>(a, false) + guarded_exponential<Raw, F>(a, true),
            power_guard + 1, false);
    }
};
// (1 - e^-2|a|) / (1 + e^-2|a|), with the sign of a.
struct Tanh {
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Evaluation<Raw> apply(Raw a) {
        using Word = DoubleWord<Raw>;
        constexpr int bits = word_bits<Raw>();
        constexpr int unit = bits - 3;
        const Unsigned<Raw> positive = magnitude(a);
        // From the largest exponent on e^-2|a| vanishes: the result is 1 to all digits of any
        // format.
        const bool beyond =
            F < RawLimits<Raw>::width - 5 &&
            (positive >> (F < RawLimits<Raw>::width - 5 ? F : 0)) >= largest_exponent / 2;
        const Word twice = beyond ? Word(uint8_t(largest_exponent)) << (bits - 6)
                                  : Word(positive) << (bits - 5 - F);
        const Word one = Word(uint8_t(1)) << unit;
        const Word power = in_units<unit - 1>(exponential<Raw>(twice, true), unit);
        const Word difference = power < one ? one - power : Word(uint8_t(0));
        return evaluation<Raw>(long_division(difference, one + power, F + 2), 2, a < 0);
    }
};

}  // namespace portable
}  // namespace fixedpoint
