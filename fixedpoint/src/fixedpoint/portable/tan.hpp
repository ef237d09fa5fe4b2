// SPDX-License-Identifier: MIT
// tan of any angle in radians, saturated: faithful (error below 0.75 ulp), except near a pole in
// formats with more than 48 integer bits, where the error is below 2^(integer bits - 53) ulp.
#pragma once

#include <fixedpoint/portable/evaluation.hpp>
#include <fixedpoint/portable/sin.hpp>

namespace fixedpoint {
namespace portable {

// An error e of the rotated vector changes a tangent t by t^2 e, at most 2^(2I - 2) e; a 64-bit
// word has e = 2^-56.
template <class Raw, int F, bool fine = (RawLimits<Raw>::width - F > 23)>
struct TangentWordOf {
    using Type = Word128;
    static constexpr int fraction_bits = 110;
};
template <int F>
struct TangentWordOf<int32_t, F, false> {
    using Type = uint64_t;
    static constexpr int fraction_bits = 53;
};

struct Tan {
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Evaluation<Raw> apply(Raw a) {
        using Word = typename TangentWordOf<Raw, F>::Type;
        constexpr int W = RawLimits<Raw>::width;
        constexpr int bits = cordic_bits<Word>();
        constexpr int reduction_bits = word_bits<Raw>();

        // The nearest number of quarter turns, or one whose remainder is still within reach of the
        // rotations.
        const Unsigned<Raw> positive = magnitude(a);
        const DoubleWord<Raw> product = CordicConstants<DoubleWord<Raw>>::two_over_pi() * positive;
        const uint64_t quarters = static_cast<Unsigned<Raw>>(
            (product + (DoubleWord<Raw>(uint8_t(1)) << (reduction_bits / 2 + F - 1))) >>
            (reduction_bits / 2 + F));
        Word128 remainder =
            (Word128(positive) << (126 - F)) - CordicConstants<Word128>::half_pi() * quarters;
        if (W == 64) remainder = remainder + ((Word128(half_pi_excess) * quarters) >> 64);

        const UnitVector<Word> unit = unit_vector<TangentWordOf<Raw, F>::fraction_bits>(
            static_cast<Word>(remainder >> (128 - bits)));
        const bool odd = (quarters & 1) != 0;
        const bool negative = is_negative(unit.sine);
        const Word sine = negative ? negated(unit.sine) : unit.sine;
        Word divisor = odd ? sine : unit.cosine;
        int bits_before_point = 0;
        while ((divisor >> (bits - 3)) < Word(uint8_t(1))) {
            if (bits_before_point > W - F) break;
            divisor = divisor << 1;
            ++bits_before_point;
        }
        const bool below_zero = a < 0 ? negative == odd : negative != odd;
        if (bits_before_point > W - F) {
            return {below_zero ? RawLimits<Raw>::min : RawLimits<Raw>::max, Outcome::overflow};
        }
        return evaluation<Raw>(
            long_division(odd ? unit.cosine : sine, divisor, F + 2 + bits_before_point), 2,
            below_zero);
    }
};

}  // namespace portable
}  // namespace fixedpoint
