// SPDX-License-Identifier: MIT
// reciprocal_sqrt: 2^F sqrt(2^F / a), saturated; the largest number if a = 0, and 0 if a < 0. Bit
// for bit as the kernels compute it in Q8.8 (within 0.5164 ulp), in Q16.16 (0.66 ulp), in the other
// 32-bit formats (0.62 ulp) and in Q32.32 (0.65 ulp); rounded to nearest in all other formats.
#pragma once

#include <fixedpoint/portable/nearest_root.hpp>
#include <fixedpoint/portable/reciprocal_root.hpp>
#include <fixedpoint/portable/reciprocal_sqrt_32.hpp>
#include <fixedpoint/portable/reciprocal_sqrt_q32_32.hpp>
#include <fixedpoint/portable/reciprocal_sqrt_q8_8.hpp>
#include <fixedpoint/portable/reciprocal_sqrt_small_q16_16.hpp>

namespace fixedpoint {
namespace portable {

// Rounded to nearest in every format and without a table: for CorrectlyRounded and the small
// variant.
template <class Raw, int F>
constexpr Raw nearest_reciprocal_sqrt(Raw a) {
    using Word = Unsigned<Raw>;
    return a < 0    ? Raw(0)
           : a == 0 ? RawLimits<Raw>::max
                    : nearest_root_of_ratio<Raw, Word>(1, static_cast<Word>(a), 3 * F);
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
    static FIXEDPOINT_CONSTEXPR int64_t apply(int64_t a) { return reciprocal_sqrt_q32_32(a); }
};

// The small variant: rounded to nearest except in Q16.16.
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
