// SPDX-License-Identifier: MIT
// lerp: a + t (b - a) from the exact product, rounded once. smoothstep: 3 t^2 - 2 t^3 for t in [0,
// 1], from exact integers, rounded once.
#pragma once

#include <fixedpoint/portable/double_word.hpp>
#include <fixedpoint/portable/multiply_words.hpp>

namespace fixedpoint {
namespace portable {

// The result modulo 2^W, whether it is the exact one, rounded, and if not, whether that is above
// the range.
template <class Raw>
struct Settled {
    Raw wrapped;
    bool fits;
    bool is_above;
};

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Settled<Raw> lerp(Raw a, Raw b, Raw t) {
    using Word = Unsigned<Raw>;
    using Parts = DoubleWordOf<Raw>;
    using Product = DoubleWord<Raw>;
    const bool negative = (b < a) != (t < 0);
    const Word distance = static_cast<Word>(b < a ? static_cast<Word>(a) - static_cast<Word>(b)
                                                  : static_cast<Word>(b) - static_cast<Word>(a));
    // At most 2^(W-1) (2^W - 1); half an ulp more is still below 2^(2W).
    const uint8_t tie_is_lower = negative && F > 0;
    const Product half = static_cast<Product>(Product(uint8_t(F != 0)) << (F == 0 ? 0 : F - 1));
    const Product product =
        static_cast<Product>(static_cast<Product>(Parts::multiply(magnitude(t), distance) + half) -
                             Product(tie_is_lower));
    const Product ulps = static_cast<Product>(product >> F);
    const Word step = Parts::low(ulps);
    // The distance from a to the limit in the direction of the step.
    const Word room =
        static_cast<Word>(negative ? static_cast<Word>(a) - static_cast<Word>(RawLimits<Raw>::min)
                                   : static_cast<Word>(RawLimits<Raw>::max) - static_cast<Word>(a));
    const Raw signed_step = static_cast<Raw>(step);
    return {negative ? wrapping_subtract(a, signed_step) : wrapping_add(a, signed_step),
            Parts::high(ulps) == 0 && step <= room, !negative};
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw wrapping_lerp(Raw a, Raw b, Raw t) {
    return lerp<Raw, F>(a, b, t).wrapped;
}

// t^2 (3/2 - t) 2^(3F) = t^2 c for t and c with F fraction bits each is at most 2^(3F-1), its half
// an ulp 2^(2F-2).
template <int F, class Word>
FIXEDPOINT_CONSTEXPR Word smoothstep_in(Word t, Word c) {
    return static_cast<Word>((t * t * c + (Word(1) << (2 * F - 2))) >> (2 * F - 1));
}
// In 64-bit words; if F > 32, the lowest one is below half an ulp.
template <int F>
FIXEDPOINT_CONSTEXPR uint64_t smoothstep_in_words(uint64_t t, uint64_t c) {
    constexpr int drop = F > 32 ? 64 : 0;
    const Wide128 square = multiply_full(t, t);
    const Wide128 low = multiply_full(square.low, c), high = multiply_full(square.high, c);
    const Word128 upper = Word128(high.high, high.low) + Word128(low.high);
    const Word128 product = F > 32 ? upper : Word128(upper.low, low.low);
    const Word128 rounded = product + (Word128(1) << (2 * F - 2 - drop));
    return (rounded >> (2 * F - 1 - drop)).low;
}
// t and c as fractions of 32 and 31 bits, so that the words of products need not be shifted. What
// the lower word of the square contributes below the upper word of the product does not reach half
// an ulp.
template <int F>
FIXEDPOINT_CONSTEXPR uint32_t smoothstep_in_fractions(uint32_t t, uint32_t c) {
    constexpr bool fits = F <= 16;  // t^2
    const uint32_t fraction = t << (32 - F), factor = c << (31 - F);
    const uint64_t square = fits ? 0 : multiply_words(fraction, fraction);
    const uint32_t upper =
        fits ? (t * t) << (fits ? 32 - 2 * F : 0) : static_cast<uint32_t>(square >> 32);
    const uint64_t lower = fits ? 0 : multiply_words(static_cast<uint32_t>(square), factor) >> 32;
    const uint64_t product = multiply_words(upper, factor) + lower;
    return ((static_cast<uint32_t>(product >> 32) >> (29 - F)) + 1) >> 1;
}
template <int F, bool fits_32 = (F <= 10), bool fits_fractions = (F < 30)>
struct Smoothstep {
    using Word = uint64_t;
    static FIXEDPOINT_CONSTEXPR Word of(Word t, Word c) { return smoothstep_in_words<F>(t, c); }
};
template <int F>
struct Smoothstep<F, false, true> {
    using Word = uint32_t;
    static FIXEDPOINT_CONSTEXPR Word of(Word t, Word c) { return smoothstep_in_fractions<F>(t, c); }
};
template <int F>
struct Smoothstep<F, true, true> {
    using Word = uint32_t;
    static FIXEDPOINT_CONSTEXPR Word of(Word t, Word c) { return smoothstep_in<F>(t, c); }
};
// t^2 (1 + (1/2 - t)) for t below 1, from 32-bit products.
template <>
struct Smoothstep<32, false, false> {
    using Word = uint64_t;
    static FIXEDPOINT_CONSTEXPR Word of(Word t, Word) {
        constexpr uint32_t half = uint32_t(1) << 31;
        const uint32_t position = static_cast<uint32_t>(t);
        const bool rises = position < half;
        const uint32_t factor = rises ? half - position : position - half;
        const uint64_t square = multiply_words(position, position);
        const uint64_t high = multiply_words(static_cast<uint32_t>(square >> 32), factor);
        const uint64_t low = multiply_words(static_cast<uint32_t>(square), factor);
        // In units of 2^-63, rounded downward: the digits below never decide a tie.
        const uint64_t product =
            rises ? square + high + (low >> 32) : square - high - ((low + 0xffffffff) >> 32);
        const uint64_t rounded = product + (half >> 1);
        return 2 * (rounded >> 32) + (static_cast<uint32_t>(rounded) >> 31);
    }
};
template <>
struct Smoothstep<0, true, true> {
    using Word = uint32_t;
    static constexpr Word of(Word t, Word) { return t; }
};

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw smoothstep(Raw t) {
    using Word = typename Smoothstep<F>::Word;
    // 2^F as an operand, which no number of a format with one integer bit reaches.
    constexpr Unsigned<Raw> one = static_cast<Unsigned<Raw>>(Unsigned<Raw>(1) << F);
    constexpr Word c = static_cast<Word>((Word(1) << F) + ((Word(1) << F) >> 1));
    if (t <= 0) return 0;
    const Unsigned<Raw> position = static_cast<Unsigned<Raw>>(t);
    const Unsigned<Raw> result =
        position >= one ? one
                        : static_cast<Unsigned<Raw>>(Smoothstep<F>::of(
                              static_cast<Word>(position), static_cast<Word>(c - position)));
    return result > static_cast<Unsigned<Raw>>(RawLimits<Raw>::max) ? RawLimits<Raw>::max
                                                                    : static_cast<Raw>(result);
}

}  // namespace portable
}  // namespace fixedpoint
