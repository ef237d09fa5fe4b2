// SPDX-License-Identifier: MIT
// pow and cbrt: e^(y ln x), faithful (error below 0.75 ulp), saturated.
#pragma once

#include <fixedpoint/portable/exponentials.hpp>
#include <fixedpoint/portable/logarithms.hpp>

namespace fixedpoint {
namespace portable {

// x^y: 1 where y is 0; where x is 0, 0, or where y < 0 the largest number; where x < 0, |x|^y with
// the sign of (-1)^y, and 0 where y is not an integer. PowerOfMagnitude evaluates |x|^y and gives
// it a sign; |x| and y are not 0.
template <class PowerOfMagnitude>
struct SignedPower {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw x, Raw y) {
        constexpr Unsigned<Raw> one = static_cast<Unsigned<Raw>>(Unsigned<Raw>(1) << F);
        if (y == 0) {
            return F < RawLimits<Raw>::width - 1
                       ? Evaluation<Raw>{static_cast<Raw>(one), Outcome::in_range}
                       : Evaluation<Raw>{RawLimits<Raw>::max, Outcome::overflow};
        }
        if (x == 0) {
            return y > 0 ? Evaluation<Raw>{0, Outcome::in_range}
                         : Evaluation<Raw>{RawLimits<Raw>::max, Outcome::division_by_zero};
        }
        if (x < 0 && (static_cast<Unsigned<Raw>>(y) & (one - 1)) != 0) {
            return {0, Outcome::domain_error};
        }
        const bool negative = x < 0 && (magnitude(y) >> F & 1) != 0;
        return PowerOfMagnitude::template apply<Raw, F>(magnitude(x), y, negative);
    }
};

// Beside 1 the logarithm of x is at least about 2^-F, so that a power in the range has a y below
// both 2^(I-1) and 2^F times the range of the logarithm: below 2^(W/2 + 4). The logarithm is that
// much finer than a result of W digits asks for.
struct PowerOfMagnitude {
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Evaluation<Raw> apply(Unsigned<Raw> x, Raw y, bool negative) {
        using Word = DoubleWord<Raw>;
        using Parts = DoubleWordOf<Raw>;
        constexpr int W = RawLimits<Raw>::width;
        constexpr int bits = word_bits<Raw>();
        const SplitLogarithm<Word> logarithm = natural_logarithm < Raw, F, W == 32 ? 50 : 102 > (x);
        const Word multiple = PseudoDivisionConstants<Word>::ln2() *
                              magnitude(static_cast<int16_t>(logarithm.exponent));
        const Word distance =
            logarithm.exponent < 0 ? multiple - logarithm.fraction : multiple + logarithm.fraction;
        const bool beyond_1 = (logarithm.exponent < 0) == (y < 0);
        // distance |y|, whose point stands behind F more bits, saturated.
        const Unsigned<Raw> factor = magnitude(y);
        const Word upper = multiply_by_half_word<Raw>(distance, factor);
        const Word lower = Word(Parts::low(Parts::multiply(Parts::low(distance), factor)));
        const Word product = upper < Word(uint8_t(1)) << (W + F)
                                 ? (upper << (W - F)) + (lower >> F)
                                 : Word(uint8_t(largest_exponent)) << (bits - 6);
        const Power<Word> power = exponential<Raw>(product, !beyond_1);
        return evaluation<Raw>(in_units<power_limit<Raw>()>(power, F + power_guard), power_guard,
                               negative);
    }
};
struct Pow : SignedPower<PowerOfMagnitude> {};

// The cube root, negative where a is.
struct Cbrt {
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Evaluation<Raw> apply(Raw a) {
        using Word = DoubleWord<Raw>;
        constexpr int W = RawLimits<Raw>::width;
        if (a == 0) return {0, Outcome::in_range};
        // e^(fraction / 3) 2^(remainder / 3) 2^quotient, the remainder from 0 to 2.
        const SplitLogarithm<Word> logarithm = natural_logarithm<Raw, F, W + 4>(magnitude(a));
        const int quotient = (logarithm.exponent + 66) / 3 - 22;
        const int remainder = logarithm.exponent - 3 * quotient;
        const Word sum = PseudoDivisionConstants<Word>::ln2() * static_cast<uint8_t>(remainder) +
                         logarithm.fraction;
        const Word third = ElementaryConstants<Word>::third();
        const Power<Word> root = {exponential_mantissa<W + 2>(multiply_high<Raw>(sum, third)),
                                  quotient};
        return evaluation<Raw>(in_units<power_limit<Raw>()>(root, F + power_guard), power_guard,
                               a < 0);
    }
};

}  // namespace portable
}  // namespace fixedpoint
