// SPDX-License-Identifier: MIT
// x^n for an integer n, by square and multiply over the binary digits of n from the first on, with
// a mantissa of 64 bits for numbers of up to 32 bits and of 128 for those of 64.
//
// Each product is truncated to the M bits of the mantissa, and squaring doubles the error: the
// relative error is below n 2^(1-M). A result in range has |ln x| n <= (I - 1) ln 2, or is below
// e^-n|ln x|, with |ln x| >= 2^-F. For M = 2 W bits that leaves 0.2 ulp, so results are faithful
// (error below 0.75 ulp).
#pragma once

#include <fixedpoint/portable/evaluation.hpp>
#include <fixedpoint/portable/integer_operand.hpp>

namespace fixedpoint {
namespace portable {

// The upper half of a product, and the next bit.
template <class Word>
struct UpperProduct {
    Word upper;
    uint8_t next;
};
FIXEDPOINT_CONSTEXPR UpperProduct<uint64_t> multiply_upper(uint64_t a, uint64_t b) {
    const Wide128 product = multiply_full(a, b);
    return {product.high, static_cast<uint8_t>(product.low >> 63)};
}
FIXEDPOINT_CONSTEXPR UpperProduct<Word128> multiply_upper(const Word128& a, const Word128& b) {
    const Wide128 low = multiply_full(a.low, b.low), high = multiply_full(a.high, b.high);
    const Wide128 first = multiply_full(a.high, b.low), second = multiply_full(a.low, b.high);
    const Word128 middle = Word128(low.high) + Word128(first.low) + Word128(second.low);
    return {Word128(high.high, high.low) + Word128(first.high) + Word128(second.high) +
                Word128(middle.high),
            static_cast<uint8_t>(middle.low >> 63)};
}

// mantissa 2^(exponent - bits); the leading bit of the mantissa is set.
template <class Word>
struct FloatingPower {
    Word mantissa;
    int16_t exponent;
};

// The steps of a power, for every format.
template <class Word>
struct PowerSteps {
    // noinline: once in a program, however many powers it computes.
    static FIXEDPOINT_CONSTEXPR __attribute__((noinline)) UpperProduct<Word> multiply(
        const Word& a, const Word& b) {
        return multiply_upper(a, b);
    }
    // 2^(2 M - 2) / a.
    static FIXEDPOINT_CONSTEXPR Word reciprocal(const Word& a) {
        constexpr int bits = static_cast<int>(8 * sizeof(Word));
        return long_division(Word(uint8_t(1)) << (bits - 2), a >> 1, bits - 1);
    }
};

template <class Steps, class Word>
FIXEDPOINT_CONSTEXPR void multiply_by(FloatingPower<Word>& a, const FloatingPower<Word>& b) {
    const UpperProduct<Word> product = Steps::multiply(a.mantissa, b.mantissa);
    const bool is_short = product.upper < Word(uint8_t(1))
                                              << static_cast<int>(8 * sizeof(Word) - 1);
    a.mantissa = is_short ? (product.upper << 1) + Word(product.next) : product.upper;
    a.exponent = static_cast<int16_t>(a.exponent + b.exponent - (is_short ? 1 : 0));
}

// The number type that powers of a format are computed for, and the word they are computed in.
template <class Raw>
using PowerNumber = Integer<(sizeof(Raw) < 4 ? 32 : RawLimits<Raw>::width)>;
template <class Number>
using PowerWord = DoubleWord<Number>;

// Outside 2^-70..2^70, a power and its reciprocal exceed every format or are below half an ulp of
// it.
constexpr int16_t beyond_every_format = 70;

// x^n or its reciprocal in ulps of a number of W bits, of x = magnitude 2^-F, rounded to nearest;
// 2^W
// - 1 where it is more. Needs magnitude and n that are not 0.
template <class Number, int F, class Steps, class Count>
FIXEDPOINT_CONSTEXPR __attribute__((noinline)) Unsigned<Number> power_in_ulps(
    Unsigned<Number> magnitude, Count n, bool reciprocal) {
    using Word = PowerWord<Number>;
    using Magnitude = Unsigned<Number>;
    constexpr int width = RawLimits<Number>::width, bits = 2 * width;
    constexpr Magnitude beyond = static_cast<Magnitude>(~Magnitude(0));
    // Not initialised from a constant pair, which the compiler would keep in RAM.
    FloatingPower<Word> power = {Word(), static_cast<int16_t>(width - F)};
    while (static_cast<Magnitude>(magnitude >> (width - 1)) == 0) {
        magnitude = static_cast<Magnitude>(magnitude << 1);
        --power.exponent;
    }
    power.mantissa = Word(magnitude) << width;
    const FloatingPower<Word> factor = power;
    constexpr int16_t limit = beyond_every_format;
    uint8_t digits = 0;
    for (Count rest = n; rest != 0; rest = static_cast<Count>(rest >> 1)) ++digits;
    // The powers of |x| are monotonic: once out of range, always out of range.
    while (--digits != 0 && (power.exponent < limit) && (power.exponent > -limit)) {
        multiply_by<Steps>(power, power);
        if ((static_cast<uint8_t>(n >> (digits - 1)) & 1) != 0) multiply_by<Steps>(power, factor);
    }
    // In ulps: word / 2^surplus, with 2^(bits-2) <= word <= 2^(bits-1).
    const Word word = reciprocal ? Steps::reciprocal(power.mantissa) : Word(power.mantissa >> 1);
    const int surplus = (reciprocal ? bits - 2 + power.exponent : bits - 1 - power.exponent) - F;
    if (surplus < width - 1) return beyond;
    if (surplus >= bits) return 0;
    const Word rounded = (word + (Word(uint8_t(1)) << (surplus - 1))) >> surplus;
    return rounded > Word(beyond) ? beyond : static_cast<Magnitude>(rounded);
}

}  // namespace portable
}  // namespace fixedpoint
