// SPDX-License-Identifier: MIT
// atan: the arc tangent in radians, faithful (error below 0.75 ulp).
#pragma once

#include <fixedpoint/portable/atan2.hpp>

namespace fixedpoint {
namespace portable {

// The small variant, for every format: no table but the word's few atan(2^-i), in Q16.16 none.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw atan_small(Raw a) {
    // 1 may be beyond the signed format, never beyond the unsigned one.
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
