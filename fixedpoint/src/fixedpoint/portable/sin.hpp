// SPDX-License-Identifier: MIT
// sin, cos, sincos of an angle in radians: for every input faithful (error below 0.75 ulp) and
// never outside [-1, 1], saturated if the format cannot represent 1.
#pragma once

#include <fixedpoint/portable/cordic.hpp>
#include <fixedpoint/portable/elementary_table.hpp>
#include <fixedpoint/portable/sin_16.hpp>
#include <fixedpoint/portable/sin_32.hpp>
#include <fixedpoint/portable/sin_q16_16.hpp>
#include <fixedpoint/portable/sin_q32_32.hpp>
#include <fixedpoint/portable/sin_small_q16_16.hpp>

namespace fixedpoint {
namespace portable {

// The word for argument reduction of an angle of W bits: twice as wide, so that pi/2 times the
// number of quarter turns keeps W - 1 guard bits.
template <int W>
struct ReductionWordOf {
    using Type = uint32_t;
};
template <>
struct ReductionWordOf<32> {
    using Type = uint64_t;
};
template <>
struct ReductionWordOf<64> {
    using Type = Word128;
};

constexpr bool is_negative(uint32_t word) { return (word >> 31) != 0; }
constexpr bool is_negative(uint64_t word) { return (word >> 63) != 0; }
constexpr bool is_negative(const Word128& word) { return is_negative(word.high); }

template <class Word>
constexpr Word negated(const Word& word) {
    return Word(0) - word;
}

// A two's-complement word shifted right by `count`, with sign extension.
template <class Word>
constexpr Word shift_right_signed(const Word& word, int count) {
    return is_negative(word) ? negated(Word(1)) - ((negated(Word(1)) - word) >> count)
                             : word >> count;
}

// The unit vector at an angle slightly beyond +-pi/4 at most; two's complement, with Bits - 2
// fraction bits.
template <class Word>
struct UnitVector {
    Word cosine;
    Word sine;
};

// Rotations by +-atan(2^-i) leave an angle below 2^-turns. The rotation by that is a multiplication
// by it, since its cosine differs from 1 by less than 2^-(F + 6).
template <int F, class Word>
FIXEDPOINT_CONSTEXPR UnitVector<Word> unit_vector(Word angle) {
    using Constants = CordicConstants<Word>;
    constexpr int bits = cordic_bits<Word>();
    constexpr int turns = (F + 6) / 2;
    constexpr int angle_bits = F + 5;

    Word x = Constants::gain();
    Word y(0);
    for (int i = 1; i <= turns; ++i) {
        // After the end of the table atan(2^-i) is 2^-i or, for words finer than those of sines,
        // 2^-i - 2^-3i / 3.
        const Word step =
            i <= Constants::arctangent_count ? read_program_memory(Constants::arctangent[i - 1])
            : F <= Constants::largest_fraction_bits || 3 * i + 2 >= bits
                ? Word(1) << (bits - 2 - i)
                : (Word(1) << (bits - 2 - i)) - (ElementaryConstants<Word>::third() >> (3 * i + 2));
        const Word x_part = x >> i;
        const Word y_part = shift_right_signed(y, i);
        if (is_negative(angle)) {
            x = x + y_part;
            y = y - x_part;
            angle = angle + step;
        } else {
            x = x - y_part;
            y = y + x_part;
            angle = angle - step;
        }
    }

    // x and y times the remaining angle, bit by bit from the lowest.
    const bool negative = is_negative(angle);
    Word factor = (negative ? negated(angle) : angle) >> (bits - 2 - angle_bits);
    Word x_part(0);
    Word y_part(0);
    for (int i = turns - 1; i < angle_bits; ++i) {
        if ((static_cast<uint8_t>(factor) & 1) != 0) {
            x_part = x_part + x;
            y_part = y_part + y;
        }
        x_part = x_part >> 1;
        y_part = shift_right_signed(y_part, 1);
        factor = factor >> 1;
    }
    x_part = x_part >> (turns - 1);
    y_part = shift_right_signed(y_part, turns - 1);
    if (negative) return {x + y_part, y - x_part};
    return {x - y_part, y + x_part};
}

template <class Raw, int F, class Word>
FIXEDPOINT_CONSTEXPR Raw round_signed_from_cordic(Word value, bool negate) {
    const bool negative = is_negative(value);
    return round_from_cordic<Raw, F>(negative ? negated(value) : value, negative != negate);
}

template <class Raw>
struct SineCosine {
    Raw sine;
    Raw cosine;
};

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR SineCosine<Raw> sine_and_cosine(Raw angle) {
    using Reduction = typename ReductionWordOf<RawLimits<Raw>::width>::Type;
    using Constants = CordicConstants<Reduction>;
    using Word = CordicWord<F>;
    constexpr int bits = cordic_bits<Reduction>();

    // The nearest number of quarter turns. If F is 0 or 1, the bits of 2/pi are too few for that,
    // but the remainder is still within reach of the rotations.
    const Unsigned<Raw> positive = magnitude(angle);
    const Reduction product = Constants::two_over_pi() * positive;
    const Unsigned<Raw> quarters = static_cast<Unsigned<Raw>>(
        (product + (Reduction(1) << (bits / 2 + F - 1))) >> (bits / 2 + F));
    const Reduction remainder =
        (Reduction(positive) << (bits - 2 - F)) - Constants::half_pi() * quarters;

    const UnitVector<Word> unit =
        unit_vector<F>(static_cast<Word>(remainder >> (bits - cordic_bits<Word>())));
    const bool odd = (quarters & 1) != 0;
    const bool beyond = (quarters & 2) != 0;
    return {round_signed_from_cordic<Raw, F>(odd ? unit.cosine : unit.sine, beyond != (angle < 0)),
            round_signed_from_cordic<Raw, F>(odd ? unit.sine : unit.cosine, beyond != odd)};
}

// The small variants, for every format: their only table is the few atan(2^-i) of the word, and in
// Q16.16 they do not have one.
template <class Raw, int F>
constexpr Raw sin_small(Raw angle) {
    return sine_and_cosine<Raw, F>(angle).sine;
}
template <class Raw, int F>
constexpr Raw cos_small(Raw angle) {
    return sine_and_cosine<Raw, F>(angle).cosine;
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void sincos_small(Raw angle, Raw* result) {
    const SineCosine<Raw> both = sine_and_cosine<Raw, F>(angle);
    result[0] = both.sine;
    result[1] = both.cosine;
}

template <>
FIXEDPOINT_CONSTEXPR int32_t sin_small<int32_t, 16>(int32_t angle) {
    return sin_small_q16_16(angle);
}
template <>
FIXEDPOINT_CONSTEXPR int32_t cos_small<int32_t, 16>(int32_t angle) {
    return cos_small_q16_16(angle);
}
template <>
FIXEDPOINT_CONSTEXPR void sincos_small<int32_t, 16>(int32_t angle, int32_t* result) {
    result[0] = sin_small_q16_16(angle);
    result[1] = cos_small_q16_16(angle);
}

template <class Raw, int F, bool is_coarse = is_coarse_16<Raw, F>()>
struct Sine {
    static constexpr Raw sin(Raw angle) { return sin_small<Raw, F>(angle); }
    static constexpr Raw cos(Raw angle) { return cos_small<Raw, F>(angle); }
    static FIXEDPOINT_CONSTEXPR void sincos(Raw angle, Raw* result) {
        sincos_small<Raw, F>(angle, result);
    }
};
template <int F>
struct Sine<int16_t, F, true> {
    static FIXEDPOINT_CONSTEXPR int16_t sin(int16_t angle) { return sin_16<F>(angle); }
    static FIXEDPOINT_CONSTEXPR int16_t cos(int16_t angle) { return cos_16<F>(angle); }
    static FIXEDPOINT_CONSTEXPR void sincos(int16_t angle, int16_t* result) {
        result[0] = sin_16<F>(angle);
        result[1] = cos_16<F>(angle);
    }
};
template <int F>
struct Sine<int32_t, F, false> {
    static FIXEDPOINT_CONSTEXPR int32_t sin(int32_t angle) { return sin_32<F>(angle); }
    static FIXEDPOINT_CONSTEXPR int32_t cos(int32_t angle) { return cos_32<F>(angle); }
    static FIXEDPOINT_CONSTEXPR void sincos(int32_t angle, int32_t* result) {
        const uint64_t turns = quarter_turns_32<F>(angle);
        result[0] = sine_of_quarter_turns_32<F>(turns);
        result[1] = sine_of_quarter_turns_32<F>(turns + one_quarter_turn_32);
    }
};
template <>
struct Sine<int32_t, 16, false> {
    static FIXEDPOINT_CONSTEXPR int32_t sin(int32_t angle) { return sin_q16_16(angle); }
    static FIXEDPOINT_CONSTEXPR int32_t cos(int32_t angle) { return cos_q16_16(angle); }
    static FIXEDPOINT_CONSTEXPR void sincos(int32_t angle, int32_t* result) {
        result[0] = sin_q16_16(angle);
        result[1] = cos_q16_16(angle);
    }
};
template <>
struct Sine<int64_t, 32> {
    static FIXEDPOINT_CONSTEXPR int64_t sin(int64_t angle) { return sin_q32_32(angle); }
    static FIXEDPOINT_CONSTEXPR int64_t cos(int64_t angle) { return cos_q32_32(angle); }
    static FIXEDPOINT_CONSTEXPR void sincos(int64_t angle, int64_t* result) {
        const uint64_t turns = quarter_turns_q32_32(angle);
        result[0] = sine_of_quarter_turns_q32_32(turns);
        result[1] = sine_of_quarter_turns_q32_32(turns + one_quarter_turn_q32_32);
    }
};

template <class Raw, int F>
constexpr Raw sin(Raw angle) {
    return Sine<Raw, F>::sin(angle);
}
template <class Raw, int F>
constexpr Raw cos(Raw angle) {
    return Sine<Raw, F>::cos(angle);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void sincos(Raw angle, Raw* result) {
    Sine<Raw, F>::sincos(angle, result);
}

}  // namespace portable
}  // namespace fixedpoint
