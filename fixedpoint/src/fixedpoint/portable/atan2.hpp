// SPDX-License-Identifier: MIT
// atan2: the angle of the vector (x, y) in radians, in (-pi, pi], faithful (error below 0.75 ulp),
// saturated; atan2(0, 0) = 0.
#pragma once

#include <fixedpoint/portable/atan2_32.hpp>
#include <fixedpoint/portable/atan2_q16_16.hpp>
#include <fixedpoint/portable/atan2_q32_32.hpp>
#include <fixedpoint/portable/atan2_q8_8.hpp>
#include <fixedpoint/portable/atan2_small_q16_16.hpp>
#include <fixedpoint/portable/cordic.hpp>

namespace fixedpoint {
namespace portable {

// The angle of (x, y) in the scale of the word, within 0.2 ulp of F fraction bits. x and y must be
// non-negative and not both zero.
//
// The vector is rotated towards the x axis by atan(2^-i), i = 1, 2, ..., each rotation only if y
// stays non-negative. With Y = 2^i y, rotation i is Y -= x, x += Y / 2^(2i), and y / x < 2^-i after
// it, since y < 2^-(i-1) x before. Y is exact and only x is truncated. Once x grows too little to
// matter (3 i >= F + 5), atan(2^-i) is 2^-i and the rotations become the long division Y / x. x
// starts below 2^(Bits-2) and grows by less than a factor of sqrt(2) 1.17, so Y < 2 x fits.
template <int F, class Coordinate>
FIXEDPOINT_CONSTEXPR CordicWord<F> first_quadrant_angle(Coordinate y, Coordinate x) {
    using Word = CordicWord<F>;
    using Constants = CordicConstants<Word>;
    constexpr int bits = cordic_bits<Word>();
    constexpr int rotations = (F + 7) / 3;
    constexpr int turns = F + 4;

    const bool steep = y > x;
    Coordinate larger = steep ? y : x;
    Coordinate smaller = steep ? x : y;
    while ((larger >> (RawLimits<Coordinate>::width - 1)) == 0) {
        larger = static_cast<Coordinate>(larger << 1);
        smaller = static_cast<Coordinate>(smaller << 1);
    }
    Word adjacent = cordic_coordinate<Word>(larger);
    Word opposite = cordic_coordinate<Word>(smaller);

    // Half of the largest remaining angle.
    Word angle = Word(1) << (bits - 2 - turns - 1);
    for (int i = 1; i <= rotations; ++i) {
        opposite = opposite << 1;
        if (opposite >= adjacent) {
            const Word before = opposite;
            opposite = opposite - adjacent;
            adjacent = adjacent + (before >> 2 * i);
            angle = angle + read_program_memory(Constants::arctangent[i - 1]);
        }
    }
    for (int i = rotations + 1; i <= turns; ++i) {
        opposite = opposite << 1;
        if (opposite >= adjacent) {
            opposite = opposite - adjacent;
            angle = angle + (Word(1) << (bits - 2 - i));
        }
    }
    return steep ? Constants::half_pi() - angle : angle;
}

// The small variant, for every format: no table but the word's few atan(2^-i), in Q16.16 none.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw atan2_small(Raw y, Raw x) {
    if (x == 0 && y == 0) return 0;
    CordicWord<F> angle = first_quadrant_angle<F>(magnitude(y), magnitude(x));
    if (x < 0) angle = CordicConstants<CordicWord<F>>::pi() - angle;
    return round_from_cordic<Raw, F>(angle, y < 0);
}

template <>
FIXEDPOINT_CONSTEXPR int32_t atan2_small<int32_t, 16>(int32_t y, int32_t x) {
    return atan2_small_q16_16(y, x);
}

template <class Raw, int F>
struct AngleOf {
    static FIXEDPOINT_CONSTEXPR Raw apply(Raw y, Raw x) { return atan2_small<Raw, F>(y, x); }
};
template <>
struct AngleOf<int16_t, 8> {
    static FIXEDPOINT_CONSTEXPR int16_t apply(int16_t y, int16_t x) { return atan2_q8_8(y, x); }
};
template <int F>
struct AngleOf<int32_t, F> {
    static FIXEDPOINT_CONSTEXPR int32_t apply(int32_t y, int32_t x) { return atan2_32<F>(y, x); }
};
template <>
struct AngleOf<int32_t, 16> {
    static FIXEDPOINT_CONSTEXPR int32_t apply(int32_t y, int32_t x) { return atan2_q16_16(y, x); }
};
template <>
struct AngleOf<int64_t, 32> {
    static FIXEDPOINT_CONSTEXPR int64_t apply(int64_t y, int64_t x) { return atan2_q32_32(y, x); }
};

template <class Raw, int F>
constexpr Raw atan2(Raw y, Raw x) {
    return AngleOf<Raw, F>::apply(y, x);
}

}  // namespace portable
}  // namespace fixedpoint
