// SPDX-License-Identifier: MIT
// log: the natural logarithm, faithful (error below 0.75 ulp), saturated; the smallest number if a
// <= 0.
#pragma once

#include <fixedpoint/portable/convert.hpp>
#include <fixedpoint/portable/cordic.hpp>
#include <fixedpoint/portable/log2_q16_16.hpp>
#include <fixedpoint/portable/log_16.hpp>
#include <fixedpoint/portable/log_32.hpp>
#include <fixedpoint/portable/log_q16_16.hpp>
#include <fixedpoint/portable/log_q32_32.hpp>
#include <fixedpoint/portable/log_small_q16_16.hpp>
#include <fixedpoint/portable/pseudo_division.hpp>

namespace fixedpoint {
namespace portable {

// ln(mantissa) with Bits - 6 fraction bits, by pseudo-division (J. E. Meggitt, "Pseudo division and
// pseudo multiplication processes", 1962); mantissa from 1 to 2, with Bits - 3 fraction bits.
//
// A product of some 1 + 2^-i approaches the mantissa from below; step i is taken only if the
// product does not exceed the mantissa. Before step i, rest is 2^(i-1) (mantissa - product), which
// is less than 2^(i-1) times the largest remaining step, 2^-(i-1) of the product: twice that fits.
// Once a step changes the product too little to matter, 2^-2i < 2^-(F + 3), the steps become the
// long division of the rest by the product.
template <int F, class Word>
FIXEDPOINT_CONSTEXPR Word mantissa_logarithm(Word mantissa) {
    constexpr int bits = cordic_bits<Word>();
    constexpr int factors = (F + 5) / 2;
    constexpr int steps = F + 4;

    Word product = Word(1) << (bits - 3);
    Word rest = mantissa - product;
    // Half of the largest remaining step.
    Word logarithm = Word(1) << (bits - 6 - steps - 1);
    for (int i = 1; i <= steps; ++i) {
        rest = rest << 1;
        if (rest >= product) {
            rest = rest - product;
            if (i <= factors) {
                product = product + (product >> i);
                logarithm = logarithm + logarithm_of_factor<Word, factors>(i);
            } else {
                logarithm = logarithm + (Word(1) << (bits - 6 - i));
            }
        }
    }
    return logarithm;
}

// For every format except Q16.16. Small, since its only table is the few ln(1 + 2^-i) of the word.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw log_small(Raw a) {
    using Word = CordicWord<F>;
    constexpr int surplus = cordic_bits<Word>() - 6 - F;

    if (a <= 0) return RawLimits<Raw>::min;
    Unsigned<Raw> normalised = static_cast<Unsigned<Raw>>(a);
    int exponent = RawLimits<Raw>::width - 1 - F;
    while ((normalised >> (RawLimits<Raw>::width - 1)) == 0) {
        normalised = static_cast<Unsigned<Raw>>(normalised << 1);
        --exponent;
    }
    const Word fraction = mantissa_logarithm<F>(cordic_coordinate<Word>(normalised));
    const Word multiple =
        PseudoDivisionConstants<Word>::ln2() * magnitude(static_cast<int16_t>(exponent));
    // A number below 1 is at most 1 - 2^-F, so its logarithm stays negative.
    const Word result = exponent < 0 ? multiple - fraction : multiple + fraction;
    return saturated_with_sign<Raw>((result + (Word(1) << (surplus - 1))) >> surplus, exponent < 0);
}

template <>
FIXEDPOINT_CONSTEXPR int32_t log_small<int32_t, 16>(int32_t a) {
    return log_small_q16_16(a);
}

template <class Raw, int F, bool is_coarse = is_coarse_16<Raw, F>()>
struct Logarithm {
    static constexpr Raw apply(Raw a) { return log_small<Raw, F>(a); }
};
// The logarithm of Q16.16 rounded to nearest, like the table of the kernel.
template <>
struct Logarithm<int8_t, 4, false> {
    static FIXEDPOINT_CONSTEXPR int8_t apply(int8_t a) {
        return convert_saturated<int8_t, 4, int32_t, 16>(
                   log_q16_16(convert<int32_t, 16, int8_t, 4>(a)))
            .number;
    }
};
template <int F>
struct Logarithm<int16_t, F, true> {
    static FIXEDPOINT_CONSTEXPR int16_t apply(int16_t a) { return log_16<F>(a); }
};
template <int F>
struct Logarithm<int32_t, F, false> {
    static FIXEDPOINT_CONSTEXPR int32_t apply(int32_t a) { return log_32<F>(a); }
};
template <>
struct Logarithm<int32_t, 16, false> {
    static FIXEDPOINT_CONSTEXPR int32_t apply(int32_t a) { return log_q16_16(a); }
};
template <>
struct Logarithm<int64_t, 32> {
    static FIXEDPOINT_CONSTEXPR int64_t apply(int64_t a) { return log_q32_32(a); }
};

template <class Raw, int F>
constexpr Raw log(Raw a) {
    return Logarithm<Raw, F>::apply(a);
}

}  // namespace portable
}  // namespace fixedpoint
