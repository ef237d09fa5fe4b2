// SPDX-License-Identifier: MIT
// exp: e^a, faithful (error below 0.75 ulp), saturated to the largest number.
#pragma once

#include <fixedpoint/portable/double_word.hpp>
#include <fixedpoint/portable/exp_32.hpp>
#include <fixedpoint/portable/exp_q16_16.hpp>
#include <fixedpoint/portable/exp_q32_32.hpp>
#include <fixedpoint/portable/exp_q8_8.hpp>
#include <fixedpoint/portable/exp_small_q16_16.hpp>
#include <fixedpoint/portable/pseudo_division.hpp>

namespace fixedpoint {
namespace portable {

// Twice as wide as the result, and at least 32 bits: a large e^a has W - 1 significant bits, and
// the argument has six bits before the point.
template <class Raw>
using ExponentialWord =
    DoubleWord<Integer<(RawLimits<Raw>::width < 16 ? 16 : RawLimits<Raw>::width)>>;

// e^a 2^-k, from 1 to 2.1, with Bits - 3 fraction bits, by pseudo-multiplication (J. E. Meggitt,
// "Pseudo division and pseudo multiplication processes", 1962). `rest` is a - k ln 2, from 0 to
// 0.73, with Bits - 6 fraction bits. It is decomposed into a sum of some ln(1 + 2^-i), each of
// which multiplies the result by 1 + 2^-i, and a remainder below 2^-steps, whose factor differs
// from 1 + remainder by less than 2^-(W + 2).
template <int W, class Word>
FIXEDPOINT_CONSTEXPR Word exponential_mantissa(Word rest) {
    constexpr int bits = static_cast<int>(8 * sizeof(Word));
    constexpr int steps = (W + 2) / 2;
    constexpr int factor_bits = W + 5;

    Word result = Word(1) << (bits - 3);
    for (int i = 1; i <= steps; ++i) {
        const Word logarithm = logarithm_of_factor<Word, steps>(i);
        if (rest >= logarithm) {
            rest = rest - logarithm;
            result = result + (result >> i);
        }
    }

    // The result times the remainder, bit by bit from the lowest.
    Word factor = rest >> (bits - 6 - factor_bits);
    Word product(0);
    for (int i = steps; i < factor_bits; ++i) {
        if ((static_cast<uint8_t>(factor) & 1) != 0) product = product + result;
        product = product >> 1;
        factor = factor >> 1;
    }
    return result + (product >> steps);
}

// For every format except Q16.16. Small, since its only table is the few ln(1 + 2^-i) of the word.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw exp_small(Raw a) {
    using Word = ExponentialWord<Raw>;
    constexpr int bits = static_cast<int>(8 * sizeof(Word));
    constexpr int W = RawLimits<Raw>::width;

    // 2^63 and 2^-65 are the limits of any format.
    const Raw whole = static_cast<Raw>(a >> F);
    if (whole > 44) return RawLimits<Raw>::max;
    if (whole < -46) return 0;

    // k = floor(a / ln 2), or possibly one less if a is less than 0.04 above a multiple of ln 2.
    constexpr int down = F > 6 ? F - 6 : 0, up = F > 6 ? 0 : 6 - F;
    const int32_t sixty_fourths = static_cast<int32_t>(a >> down) * (int32_t(1) << up);
    const int k = static_cast<int>((sixty_fourths * 1477 - 1000) >> 16);

    const int exponent = k + F;
    if (exponent >= W - 1) return RawLimits<Raw>::max;
    if (exponent < -2) return 0;

    const Word position = Word(magnitude(a)) << (bits - 6 - F);
    const Word multiple = PseudoDivisionConstants<Word>::ln2() * magnitude(static_cast<int16_t>(k));
    const Word mantissa = exponential_mantissa<W>(a < 0   ? multiple - position
                                                  : k < 0 ? position + multiple
                                                          : position - multiple);
    const int surplus = bits - 3 - exponent;
    return saturated_with_sign<Raw>((mantissa + (Word(1) << (surplus - 1))) >> surplus, false);
}

template <>
FIXEDPOINT_CONSTEXPR int32_t exp_small<int32_t, 16>(int32_t a) {
    return exp_small_q16_16(a);
}

template <class Raw, int F>
struct Exponential {
    static constexpr Raw apply(Raw a) { return exp_small<Raw, F>(a); }
};
template <>
struct Exponential<int16_t, 8> {
    static FIXEDPOINT_CONSTEXPR int16_t apply(int16_t a) { return exp_q8_8(a); }
};
template <int F>
struct Exponential<int32_t, F> {
    static FIXEDPOINT_CONSTEXPR int32_t apply(int32_t a) { return exp_32<F>(a); }
};
template <>
struct Exponential<int32_t, 16> {
    static FIXEDPOINT_CONSTEXPR int32_t apply(int32_t a) { return exp_q16_16(a); }
};
template <int F>
struct Exponential<int64_t, F> {
    static FIXEDPOINT_CONSTEXPR int64_t apply(int64_t a) { return exp_64<int64_t, F>(a, F); }
};
template <>
struct Exponential<int64_t, 32> {
    static FIXEDPOINT_CONSTEXPR int64_t apply(int64_t a) { return exp_q32_32(a); }
};

template <>
FIXEDPOINT_CONSTEXPR int32_t exp2_unsaturated<int32_t, 16>(int32_t a) {
    return exp2_unsaturated_q16_16(a);
}

template <class Raw, int F>
constexpr Raw exp(Raw a) {
    return Exponential<Raw, F>::apply(a);
}

}  // namespace portable
}  // namespace fixedpoint
