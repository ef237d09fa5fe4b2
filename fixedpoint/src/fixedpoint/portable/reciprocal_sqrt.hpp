// SPDX-License-Identifier: MIT
// reciprocal_sqrt: 2^F sqrt(2^F / a), saturated; the largest number where a = 0, 0 where a < 0.
// Rounded to nearest, except in Q8.8, there within 0.5164 ulp, and in formats of 32 bits, there bit
// for bit as the kernels compute it, in Q16.16 within 0.66 ulp, else within 0.75 ulp, and in
// Q32.32, there within 0.63 ulp.
#pragma once

#include <fixedpoint/portable/divide.hpp>
#include <fixedpoint/portable/nearest_root.hpp>
#include <fixedpoint/portable/reciprocal_sqrt_32.hpp>
#include <fixedpoint/portable/reciprocal_sqrt_q8_8.hpp>
#include <fixedpoint/portable/reciprocal_sqrt_small_q16_16.hpp>
#include <fixedpoint/portable/reciprocal_sqrt_table.hpp>
#include <fixedpoint/portable/sqrt.hpp>

namespace fixedpoint {
namespace portable {

// Rounded to nearest in every format, and with no table: the small variant.
template <class Raw, int F>
constexpr Raw nearest_reciprocal_sqrt(Raw a) {
    using Word = Unsigned<Raw>;
    return a < 0    ? Raw(0)
           : a == 0 ? RawLimits<Raw>::max
                    : nearest_root_of_ratio<Raw, Word>(1, static_cast<Word>(a), 3 * F);
}

// 2^38 / sqrt(radicand) less than 6 from the exact value, below 2^23. Needs a radicand of at least
// 2^30 and looks at its upper 24 bits; tables/reciprocal_sqrt.py gives the formula.
FIXEDPOINT_CONSTEXPR uint32_t reciprocal_root_mantissa(uint32_t radicand) {
    const int h = static_cast<int>(radicand >> 24) - 64;
    const uint32_t l = radicand >> 16 & 0xff, x = radicand >> 8 & 0xff;
    const uint32_t slope = read_program_memory(ReciprocalSqrtTable<>::slope[h]);
    const uint32_t parabola =
        (l * (256 - l) >> 7) * read_program_memory(ReciprocalSqrtTable<>::bulge[h]) >> 7;
    return read_program_memory(ReciprocalSqrtTable<>::value[h]) - (l * (slope & 0xff) >> 8) -
           l * (slope >> 8) - (x * (slope >> 8) >> 8) - parabola;
}

FIXEDPOINT_CONSTEXPR int32_t reciprocal_sqrt_q16_16(int32_t a) {
    if (a < 64) return nearest_reciprocal_sqrt<int32_t, 16>(a);
    uint32_t radicand = static_cast<uint32_t>(a);
    // The kernel drops the last byte of four before it normalises.
    if (radicand >> 24 != 0) radicand &= ~uint32_t(0xff);
    int shift = 14;
    while (radicand < uint32_t(1) << 30) {
        radicand <<= 2;
        --shift;
    }
    return static_cast<int32_t>(((reciprocal_root_mantissa(radicand) >> (shift - 1)) + 1) >> 1);
}

// 2^48 / sqrt(a) by the square root and the division of Operations, a class with these of Q32.32.
//
// a 4^k is at least 2^54, so that its root s, half a unit off, is at least 2^43, and the quotient
// 2^(64 + k) / s is off by 2^48 / sqrt(a) / 2^44 at most for that: 1/8 ulp from a = 2^14 on.
template <class Operations>
FIXEDPOINT_CONSTEXPR int64_t reciprocal_sqrt_by_division(int64_t a) {
    if (a < int64_t(1) << 14) return nearest_reciprocal_sqrt<int64_t, 32>(a);
    int64_t numerator = int64_t(1) << 32;
    for (; a >> 54 == 0; a = a << 8) numerator = numerator << 4;
    return Operations::divide(numerator, Operations::sqrt(a));
}

struct SqrtAndDivision {
    static FIXEDPOINT_CONSTEXPR int64_t sqrt(int64_t a) { return portable::sqrt<int64_t, 32>(a); }
    static FIXEDPOINT_CONSTEXPR int64_t divide(int64_t a, int64_t b) {
        return portable::divide<int64_t, 32>(a, b);
    }
};

template <class Raw, int F>
struct ReciprocalSqrt {
    static constexpr Raw apply(Raw a) { return nearest_reciprocal_sqrt<Raw, F>(a); }
};
template <>
struct ReciprocalSqrt<int16_t, 8> {
    static FIXEDPOINT_CONSTEXPR int16_t apply(int16_t a) { return reciprocal_sqrt_q8_8(a); }
};
template <int F>
struct ReciprocalSqrt<int32_t, F> {
    static constexpr int32_t apply(int32_t a) { return reciprocal_sqrt_32<F>(a); }
};
template <>
struct ReciprocalSqrt<int32_t, 16> {
    static FIXEDPOINT_CONSTEXPR int32_t apply(int32_t a) { return reciprocal_sqrt_q16_16(a); }
};
template <>
struct ReciprocalSqrt<int64_t, 32> {
    static FIXEDPOINT_CONSTEXPR int64_t apply(int64_t a) {
        return reciprocal_sqrt_by_division<SqrtAndDivision>(a);
    }
};

// The small variant; nearest but in Q16.16.
template <class Raw, int F>
constexpr Raw reciprocal_sqrt_small(Raw a) {
    return nearest_reciprocal_sqrt<Raw, F>(a);
}
template <>
FIXEDPOINT_CONSTEXPR int32_t reciprocal_sqrt_small<int32_t, 16>(int32_t a) {
    return reciprocal_sqrt_small_q16_16(a);
}

template <class Raw, int F>
constexpr Raw reciprocal_sqrt(Raw a) {
    return ReciprocalSqrt<Raw, F>::apply(a);
}

}  // namespace portable
}  // namespace fixedpoint
