// SPDX-License-Identifier: MIT
// smoothstep: 3 t^2 - 2 t^3 for t in [0, 1], from exact integers, rounded once.
//
// t^2 times v = 3 - 2 t, which has F fraction bits as t has, is the result with 3F of them. Its
// half an ulp is 2^(2F-1); the digits below that do not matter to rounding half up.
#pragma once

#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/kernel/words.hpp>

namespace fixedpoint {
namespace kernel {

// In 64-bit words; if F > 32, the lowest one is below half an ulp.
template <int F, bool square_fits_half = (F <= 8), bool v_fits_word = (F <= 30)>
struct Smoothstep {
    using Word = uint64_t;
    static FIXEDPOINT_CONSTEXPR Word of(Word t) {
        constexpr int drop = F > 32 ? 64 : 0;
        const uint64_t half_v = (Word(1) << F) + ((Word(1) << F) >> 1) - t;
        const portable::Wide128 square = portable::multiply_full(t, t);
        const portable::Wide128 low = portable::multiply_full(square.low, half_v),
                                high = portable::multiply_full(square.high, half_v);
        const portable::Word128 upper =
            portable::Word128(high.high, high.low) + portable::Word128(low.high);
        const portable::Word128 product = F > 32 ? upper : portable::Word128(upper.low, low.low);
        const portable::Word128 rounded = product + (portable::Word128(1) << (2 * F - 2 - drop));
        return (rounded >> (2 * F - 1 - drop)).low;
    }
};
// With t^2 as a fraction of 32 bits, the upper word of the product with v has the F fraction bits
// of the result. If t^2 has more bits, its lower word contributes to the lower word of the product.
template <int F>
struct Smoothstep<F, false, true> {
    using Word = uint32_t;
    static FIXEDPOINT_CONSTEXPR Word of(Word t) {
        const uint32_t v = (uint32_t(3) << F) - (t << 1);
        const uint64_t product = times(t, v);
        return upper_word(product) + (static_cast<uint32_t>(product) >> 31);
    }

  private:
    static FIXEDPOINT_CONSTEXPR uint64_t times(uint32_t t, uint32_t v) {
        if (F <= 16) {
            const uint16_t half = static_cast<uint16_t>(t);
            return multiply_words(multiply_halves(half, half) << (F <= 16 ? 32 - 2 * F : 0), v);
        }
        const uint32_t fraction = t << (32 - F);
        const uint64_t square = multiply_words(fraction, fraction);
        return multiply_words(upper_word(square), v) +
               upper_product<uint32_t, 0>(static_cast<uint32_t>(square), v);
    }
};
template <int F>
struct Smoothstep<F, true, true> {
    using Word = uint16_t;
    static FIXEDPOINT_CONSTEXPR Word of(Word t) {
        const uint16_t v = static_cast<uint16_t>((uint16_t(3) << F) - 2 * t);
        const uint32_t product = multiply_halves(static_cast<uint16_t>(t * t), v);
        return static_cast<Word>((product + (uint32_t(1) << (2 * F - 1))) >> (2 * F));
    }
};
// t^2 (1 + (1/2 - t)) for t below 1, from 32-bit products.
template <>
struct Smoothstep<32, false, false> {
    using Word = uint64_t;
    static FIXEDPOINT_CONSTEXPR Word of(Word t) {
        constexpr uint32_t half = uint32_t(1) << 31;
        const uint32_t position = static_cast<uint32_t>(t);
        const bool rises = position < half;
        const uint32_t factor = rises ? half - position : position - half;
        const uint64_t square = multiply_words(position, position);
        const uint64_t high = multiply_words(upper_word(square), factor);
        const uint64_t low = multiply_words(static_cast<uint32_t>(square), factor);
        // In units of 2^-63, rounded downward: the digits below never decide a tie.
        const uint64_t product =
            rises ? square + high + upper_word(low) : square - high - upper_word(low + 0xffffffff);
        const uint64_t rounded = product + (half >> 1);
        return 2 * uint64_t(upper_word(rounded)) + (static_cast<uint32_t>(rounded) >> 31);
    }
};
template <>
struct Smoothstep<0, true, true> {
    using Word = uint16_t;
    static constexpr Word of(Word t) { return t; }
};

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw smoothstep(Raw t) {
    using Word = typename Smoothstep<F>::Word;
    // 2^F as an operand, which no number of a format with one integer bit reaches.
    constexpr Unsigned<Raw> one = static_cast<Unsigned<Raw>>(Unsigned<Raw>(1) << F);
    if (t <= 0) return 0;
    const Unsigned<Raw> position = static_cast<Unsigned<Raw>>(t);
    const Unsigned<Raw> result =
        position >= one
            ? one
            : static_cast<Unsigned<Raw>>(Smoothstep<F>::of(static_cast<Word>(position)));
    return result > static_cast<Unsigned<Raw>>(RawLimits<Raw>::max) ? RawLimits<Raw>::max
                                                                    : static_cast<Raw>(result);
}

}  // namespace kernel
}  // namespace fixedpoint
