// SPDX-License-Identifier: MIT
// The two steps behind all decimal text: prepend a decimal digit to a binary fraction, and take its
// first decimal digit away. Both are exact in one word, without a wider one.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/converted.hpp>

namespace fixedpoint {
namespace portable {

// The word in which a Raw is converted from and to decimal digits: at least 32 bits, so that the
// narrow formats share their code and no operand is promoted to a signed int. It has more than F
// bits, since the bit after the last one rounds, and a value above every integer, which digits
// saturate to.
template <class Raw, int F>
using DecimalWord =
    UnsignedInteger<(RawLimits<Raw>::width > 32 || F == 32 ||
                     (RawLimits<Raw>::width == 32 && !RawLimits<Raw>::is_signed && F == 0))
                        ? 64
                        : 32>;

// A number in [0, 1): bits / 2^P, where P is the width of Word, plus less than one unit if
// `inexact`.
template <class Word>
struct DecimalFraction {
    Word bits;
    bool inexact;

    // Becomes (digit + *this) / 10. Called from the last digit to the first, it keeps in `bits` the
    // exact fraction of arbitrarily many digits, rounded down, since floor((d + x) / 10) = floor((d
    // + floor(x)) / 10) for integer d. `inexact` says whether anything was dropped.
    FIXEDPOINT_CONSTEXPR void prepend(uint8_t digit) {
        // 2^P = 10 tenth + 6 for P = 32 and 64, so that digit 2^P / 10 = digit tenth + 6 digit
        // / 10.
        constexpr Word tenth = static_cast<Word>(-1) / 10;
        const uint8_t rest = static_cast<uint8_t>(6 * digit + static_cast<uint8_t>(bits % 10));
        bits = digit * tenth + bits / 10 + rest / 10;
        inexact = inexact || rest % 10 != 0;
    }

    // Returns the first decimal digit d and becomes 10 *this - d.
    FIXEDPOINT_CONSTEXPR uint8_t take() {
        // With bits = 16 a + b, 10 bits / 2^P = (10 a + 10 b / 16) / 2^(P-4), which stays below
        // 2^P.
        const Word digit =
            ((bits >> 4) * 10 + (bits & 15) * 10 / 16) >> (RawLimits<Word>::width - 4);
        bits *= 10;
        return static_cast<uint8_t>(digit);
    }

    // Whether rounding to an integer, to nearest, half up, increases the magnitude.
    FIXEDPOINT_CONSTEXPR bool rounds_away(bool negative) const {
        constexpr Word half = Word(1) << (RawLimits<Word>::width - 1);
        return bits > half || (bits == half && (inexact || !negative));
    }
};

// The fraction of magnitude / 2^F, whose integer part is magnitude >> F.
template <class Word, int F>
constexpr DecimalFraction<Word> fraction_of(Word magnitude) {
    // Two shifts, since a single shift by P (F = 0) would be undefined.
    return {(magnitude << (RawLimits<Word>::width - 1 - F)) << 1, false};
}

// integer + fraction, negated if `negative`, as a raw number: rounded to nearest, half up, and
// saturated.
template <class Raw, int F, class Word>
FIXEDPOINT_CONSTEXPR Converted<Raw> assemble(Word integer, DecimalFraction<Word> fraction,
                                             bool negative) {
    const Word limit = largest_magnitude<Word, Raw>(negative);
    const Converted<Raw> saturated = {negative ? RawLimits<Raw>::min : RawLimits<Raw>::max, false};
    if (integer > (limit >> F)) return saturated;
    // The part below one ulp, as a fraction of an ulp.
    const DecimalFraction<Word> below = {fraction.bits << F, fraction.inexact};
    const Word magnitude =
        (integer << F) + ((fraction.bits >> (RawLimits<Word>::width - 1 - F)) >> 1);
    const Word up = below.rounds_away(negative) ? 1 : 0;
    const bool fits =
        RawLimits<Raw>::is_signed || !negative ? magnitude <= limit - up : magnitude + up == 0;
    if (!fits) return saturated;
    return {with_sign<Raw>(static_cast<Unsigned<Raw>>(magnitude + up), negative), true};
}

}  // namespace portable
}  // namespace fixedpoint
