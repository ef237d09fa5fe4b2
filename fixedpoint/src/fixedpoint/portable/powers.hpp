// SPDX-License-Identifier: MIT
// pow and cbrt: e^(y ln x), faithful (error below 0.75 ulp), saturated.
#pragma once

#include <fixedpoint/portable/exponentials.hpp>
#include <fixedpoint/portable/logarithms.hpp>

namespace fixedpoint {
namespace portable {

// x^y: 1 if y is 0. Otherwise, if x is 0: 0, or the largest number if y < 0. If x < 0: |x|^y with
// the sign of (-1)^y, and 0 if y is not an integer. PowerOfMagnitude evaluates |x|^y, where neither
// is 0, and gives it a sign.
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

// Near 1 the logarithm of x is at least about 2^-F, so for a power in range y is below both 2^(I-1)
// and 2^F times the range of the logarithm: below 2^(W/2 + 4). The logarithm has that many guard
// bits beyond what a result of W digits needs.
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
        // distance |y|, which has F more fraction bits, saturated.
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

// The cube root, negative if a is.
struct Cbrt {
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Evaluation<Raw> apply(Raw a) {
        using Word = DoubleWord<Raw>;
        constexpr int W = RawLimits<Raw>::width;
        if (a == 0) return {0, Outcome::in_range};
        // e^(fraction / 3) 2^(remainder / 3) 2^quotient, with the remainder in 0..2.
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
