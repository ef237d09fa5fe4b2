// SPDX-License-Identifier: MIT
// atan: the arc tangent in radians, faithful (error below 0.75 ulp).
#pragma once

#include <fixedpoint/portable/atan2.hpp>
#include <fixedpoint/portable/convert.hpp>

namespace fixedpoint {
namespace portable {

// The small variant, for every format: its only table is the few atan(2^-i) of the word, and in
// Q16.16 it does not have one.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw atan_small(Raw a) {
    // The signed format may not be able to represent 1; the unsigned one always can.
    constexpr Unsigned<Raw> one = static_cast<Unsigned<Raw>>(Unsigned<Raw>(1) << F);
    return round_from_cordic<Raw, F>(first_quadrant_angle<F>(magnitude(a), one), a < 0);
}

template <>
FIXEDPOINT_CONSTEXPR int32_t atan_small<int32_t, 16>(int32_t a) {
    return atan_small_q16_16(a);
}

template <class Raw, int F>
struct ArcTangent {
    static FIXEDPOINT_CONSTEXPR Raw apply(Raw a) { return atan_small<Raw, F>(a); }
};
// The arc tangent of Q16.16 rounded to nearest, like the table of the kernel.
template <>
struct ArcTangent<int8_t, 4> {
    static FIXEDPOINT_CONSTEXPR int8_t apply(int8_t a) {
        return convert_saturated<int8_t, 4, int32_t, 16>(
                   atan_q16_16(convert<int32_t, 16, int8_t, 4>(a)))
            .number;
    }
};
template <>
struct ArcTangent<int16_t, 8> {
    static FIXEDPOINT_CONSTEXPR int16_t apply(int16_t a) { return atan2_q8_8(a, 1 << 8); }
};
template <int F>
struct ArcTangent<int32_t, F> {
    static FIXEDPOINT_CONSTEXPR int32_t apply(int32_t a) { return atan_32<F>(a); }
};
template <>
struct ArcTangent<int32_t, 16> {
    static FIXEDPOINT_CONSTEXPR int32_t apply(int32_t a) { return atan_q16_16(a); }
};
template <>
struct ArcTangent<int64_t, 32> {
    static FIXEDPOINT_CONSTEXPR int64_t apply(int64_t a) { return atan_q32_32(a); }
};

template <class Raw, int F>
constexpr Raw atan(Raw a) {
    return ArcTangent<Raw, F>::apply(a);
}

}  // namespace portable
}  // namespace fixedpoint
