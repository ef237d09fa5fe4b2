// SPDX-License-Identifier: MIT
// Conversion between fixed-point formats and integers of any width and signedness. An integer is
// the format with F = 0, so every conversion is one shift, rounded to nearest, half up, if it drops
// bits. convert wraps; convert_saturated saturates and reports whether it did.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/converted.hpp>
#include <fixedpoint/portable/round.hpp>

namespace fixedpoint {
namespace portable {

// The integer n 2^Shift mod 2^W, where W is the width of Target.
template <class Target, int Shift, class Source>
constexpr Target scale(Source n) {
    return static_cast<Target>(shifted_left(static_cast<Unsigned<Target>>(n), Shift));
}

// The integer n 2^Shift, saturated to the range of Target.
template <class Target, int Shift, class Source>
FIXEDPOINT_CONSTEXPR Converted<Target> scale_saturated(Source n) {
    constexpr bool target_is_signed = Target(-1) < Target(1);
    constexpr Target max =
        target_is_signed ? static_cast<Target>(RawLimits<Target>::max) : Target(-1);
    constexpr Target min =
        target_is_signed ? static_cast<Target>(RawLimits<Target>::min) : Target(0);
    // Zero and negative sources are compared as signed numbers and positive ones as unsigned
    // numbers, so that no comparison mixes the two or tests an unsigned number for being negative.
    if (n < Source(1)) {
        const bool fits = static_cast<Integer<RawLimits<Source>::width>>(n) >=
                          static_cast<Integer<RawLimits<Target>::width>>(min >> Shift);
        if (!fits) return {min, false};
    } else {
        const bool fits =
            static_cast<Unsigned<Source>>(n) <= static_cast<Unsigned<Target>>(max >> Shift);
        if (!fits) return {max, false};
    }
    return {scale<Target, Shift>(n), true};
}

// The left and the right shift of a raw from one format to another.
template <int FromF, int ToF>
constexpr int left_shift() {
    return ToF > FromF ? ToF - FromF : 0;
}
template <int FromF, int ToF>
constexpr int right_shift() {
    return left_shift<ToF, FromF>();
}

// a 2^-FromF in the format (ToRaw, ToF): floor(a 2^(ToF - FromF) + 1/2) mod 2^W.
template <class ToRaw, int ToF, class FromRaw, int FromF>
constexpr ToRaw convert(FromRaw a) {
    return scale<ToRaw, left_shift<FromF, ToF>()>(
        integer_round<FromRaw, right_shift<FromF, ToF>()>(a));
}

// The same, saturated instead of wrapped.
template <class ToRaw, int ToF, class FromRaw, int FromF>
constexpr Converted<ToRaw> convert_saturated(FromRaw a) {
    return scale_saturated<ToRaw, left_shift<FromF, ToF>()>(
        integer_round<FromRaw, right_shift<FromF, ToF>()>(a));
}

}  // namespace portable
}  // namespace fixedpoint
