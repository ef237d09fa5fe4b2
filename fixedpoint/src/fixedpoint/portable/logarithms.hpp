// SPDX-License-Identifier: MIT
// log2, log10, log1p: logarithms, faithful (error below 0.75 ulp), saturated; the smallest number
// if there is no logarithm.
#pragma once

#include <fixedpoint/portable/elementary_table.hpp>
#include <fixedpoint/portable/evaluation.hpp>
#include <fixedpoint/portable/log.hpp>

namespace fixedpoint {
namespace portable {

// ln(a) = exponent ln 2 + fraction; the fraction has Bits - 6 fraction bits.
template <class Word>
struct SplitLogarithm {
    Word fraction;
    int exponent;
};

// The logarithm of a 2^-F, its fraction within 2^-(P + 4). a must not be 0.
template <class Raw, int F, int P = F>
FIXEDPOINT_CONSTEXPR SplitLogarithm<DoubleWord<Raw>> natural_logarithm(Unsigned<Raw> a) {
    using Word = DoubleWord<Raw>;
    constexpr int W = RawLimits<Raw>::width;
    int exponent = W - 1 - F;
    while ((a >> (W - 1)) == 0) {
        a = static_cast<Unsigned<Raw>>(a << 1);
        --exponent;
    }
    return {mantissa_logarithm<P>(Word(a) << (W - 2)), exponent};
}

// exponent log_b(2) + fraction / ln(b) with F fraction bits; both terms have Bits - 6.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Evaluation<Raw> logarithm_sum(int exponent, const DoubleWord<Raw>& log_b_of_2,
                                                   const DoubleWord<Raw>& fraction) {
    using Word = DoubleWord<Raw>;
    const Word multiple = log_b_of_2 * magnitude(static_cast<int16_t>(exponent));
    // A number below 1 is at most 1 - 2^-F: its logarithm stays negative.
    return evaluation<Raw>(exponent < 0 ? multiple - fraction : multiple + fraction,
                           word_bits<Raw>() - 6 - F, exponent < 0);
}

template <class Raw>
constexpr Evaluation<Raw> no_logarithm() {
    return {RawLimits<Raw>::min, Outcome::domain_error};
}

// The logarithm to base b, given log_b(2) with Bits - 6 fraction bits and 1 / ln(b) with Bits - 1.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Evaluation<Raw> logarithm(Raw a, const DoubleWord<Raw>& log_b_of_2,
                                               const DoubleWord<Raw>& per_ln_b) {
    if (a <= 0) return no_logarithm<Raw>();
    const SplitLogarithm<DoubleWord<Raw>> natural =
        natural_logarithm<Raw, F>(static_cast<Unsigned<Raw>>(a));
    return logarithm_sum<Raw, F>(natural.exponent, log_b_of_2,
                                 multiply_high<Raw>(natural.fraction, per_ln_b) << 1);
}

struct Log2 {
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Evaluation<Raw> apply(Raw a) {
        using Word = DoubleWord<Raw>;
        return logarithm<Raw, F>(a, Word(uint8_t(1)) << (word_bits<Raw>() - 6),
                                 ElementaryConstants<Word>::per_ln2());
    }
};
struct Log10 {
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Evaluation<Raw> apply(Raw a) {
        using Constants = ElementaryConstants<DoubleWord<Raw>>;
        return logarithm<Raw, F>(a, Constants::log10_of_2(), Constants::per_ln10());
    }
};
// ln(1 + a), with all its digits near 0. As an unsigned number, 1 + a always fits.
struct Log1p {
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Evaluation<Raw> apply(Raw a) {
        using Word = DoubleWord<Raw>;
        constexpr Unsigned<Raw> one = static_cast<Unsigned<Raw>>(Unsigned<Raw>(1) << F);
        if (a < 0 && magnitude(a) >= one) return no_logarithm<Raw>();
        const SplitLogarithm<Word> natural = natural_logarithm<Raw, F>(
            static_cast<Unsigned<Raw>>(one + static_cast<Unsigned<Raw>>(a)));
        return logarithm_sum<Raw, F>(natural.exponent, PseudoDivisionConstants<Word>::ln2(),
                                     natural.fraction);
    }
};

}  // namespace portable
}  // namespace fixedpoint
