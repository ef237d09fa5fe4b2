// SPDX-License-Identifier: MIT
// What the elementary functions without a kernel have in common: they compute in a word of twice
// the width of a 32- or 64-bit number, far finer than an ulp, and round once. Narrower numbers go
// through Q16.16 (through_q16_16.hpp), as they do with kernels, or else through 32 bits with as
// many fraction bits, rounded once.
#pragma once

#include <fixedpoint/portable/convert.hpp>
#include <fixedpoint/portable/double_word.hpp>
#include <fixedpoint/portable/through_q16_16.hpp>

namespace fixedpoint {
namespace portable {

// Whether a function has a value at its operands, and that value is in range.
enum class Outcome : unsigned char { in_range, overflow, division_by_zero, domain_error };

template <class Raw>
struct Evaluation {
    Raw number;
    Outcome outcome;
};

template <class Raw>
constexpr int word_bits() {
    return 2 * RawLimits<Raw>::width;
}

// magnitude / 2^surplus with its sign, rounded to nearest and saturated. Requires
// 0 < surplus < Bits.
template <class Raw, class Word>
FIXEDPOINT_CONSTEXPR Evaluation<Raw> evaluation(const Word& magnitude, int surplus, bool negative) {
    const Word rounded = (magnitude + (Word(uint8_t(1)) << (surplus - 1))) >> surplus;
    const Unsigned<Raw> limit =
        static_cast<Unsigned<Raw>>(Unsigned<Raw>(RawLimits<Raw>::max) + (negative ? 1 : 0));
    if (sizeof(Word) >= sizeof(Raw) && rounded > Word(limit)) {
        return {negative ? RawLimits<Raw>::min : RawLimits<Raw>::max, Outcome::overflow};
    }
    return {with_sign<Raw>(static_cast<Unsigned<Raw>>(rounded), negative), Outcome::in_range};
}

// floor(a b / 2^W), which always fits.
template <class Raw>
FIXEDPOINT_CONSTEXPR DoubleWord<Raw> multiply_by_half_word(const DoubleWord<Raw>& a,
                                                           Unsigned<Raw> b) {
    using Parts = DoubleWordOf<Raw>;
    const DoubleWord<Raw> low = Parts::multiply(Parts::low(a), b);
    return Parts::multiply(Parts::high(a), b) + DoubleWord<Raw>(Parts::high(low));
}

// floor(a b / 2^(2W)), or one or two less.
template <class Raw>
FIXEDPOINT_CONSTEXPR DoubleWord<Raw> multiply_high(const DoubleWord<Raw>& a,
                                                   const DoubleWord<Raw>& b) {
    using Parts = DoubleWordOf<Raw>;
    const DoubleWord<Raw> low = multiply_by_half_word<Raw>(a, Parts::low(b));
    const DoubleWord<Raw> high = multiply_by_half_word<Raw>(a, Parts::high(b));
    return high + (low >> RawLimits<Raw>::width);
}

// floor(numerator 2^bits / denominator). Requires numerator < 2 denominator and denominator <
// 2^(Bits-1).
template <class Word>
FIXEDPOINT_CONSTEXPR Word long_division(Word numerator, const Word& denominator, int bits) {
    Word quotient(uint8_t(0));
    for (int i = 0; i <= bits; ++i) {
        quotient = quotient << 1;
        if (numerator >= denominator) {
            numerator = numerator - denominator;
            quotient = quotient + Word(uint8_t(1));
        }
        numerator = numerator << 1;
    }
    return quotient;
}

// Function must be a class whose apply<Raw, F> returns the Evaluation for 32- and 64-bit numbers.
template <class Function, class Raw, int F, bool narrow = (sizeof(Raw) < 4)>
struct Evaluated {
    template <class... Operands>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Operands... a) {
        return Function::template apply<Raw, F>(a...);
    }
};
template <class Function, class Raw, int F>
struct Evaluated<Function, Raw, F, true> {
    static constexpr int wide_fraction = through_q16_16<Raw, F>() ? 16 : F;
    template <class... Operands>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Operands... a) {
        const Evaluation<int32_t> wide = Function::template apply<int32_t, wide_fraction>(
            convert<int32_t, wide_fraction, Raw, F>(a)...);
        const Converted<Raw> narrow =
            convert_saturated<Raw, F, int32_t, wide_fraction>(wide.number);
        return {narrow.number, wide.outcome == Outcome::in_range && !narrow.fits ? Outcome::overflow
                                                                                 : wide.outcome};
    }
};

}  // namespace portable
}  // namespace fixedpoint
