// SPDX-License-Identifier: MIT
// The exact result in Q16.16, rounded, if a 32-bit core decides the rounding; otherwise the
// smallest number, which is never a result. For hosts and chips without kernels. In other formats
// the rounding always counts as undecided.
#pragma once

#include <fixedpoint/portable/atan2_32.hpp>
#include <fixedpoint/portable/doubt.hpp>
#include <fixedpoint/portable/exp_wide.hpp>
#include <fixedpoint/portable/log_32.hpp>
#include <fixedpoint/portable/sin_32.hpp>

namespace fixedpoint {
namespace portable {

// A number in units of 2^-31, rounded to 16 bits.
FIXEDPOINT_CONSTEXPR int32_t rounded_without_doubt(int64_t number) {
    const int64_t above = number + (int64_t(1) << 14) + FIXEDPOINT_DOUBT;
    return (above & 0x7fff) < 2 * FIXEDPOINT_DOUBT ? RawLimits<int32_t>::min
                                                   : static_cast<int32_t>(above >> 15);
}
FIXEDPOINT_CONSTEXPR int32_t rounded_without_doubt(int64_t magnitude, bool negative) {
    const int32_t rounded = rounded_without_doubt(magnitude);
    return negative && rounded >= 0 ? -rounded : rounded;
}

FIXEDPOINT_CONSTEXPR int32_t certain_sine(uint64_t turns) {
    const uint64_t position = position_of_quarter_turns(turns);
    return rounded_without_doubt(cubic_32<Sine32Table<>>(static_cast<uint32_t>(position >> 8)),
                                 (turns >> 41 & 1) != 0);
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw certain_sin(Raw) {
    return RawLimits<Raw>::min;
}
template <>
FIXEDPOINT_CONSTEXPR int32_t certain_sin<int32_t, 16>(int32_t angle) {
    return certain_sine(quarter_turns_32<16>(angle));
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw certain_cos(Raw) {
    return RawLimits<Raw>::min;
}
template <>
FIXEDPOINT_CONSTEXPR int32_t certain_cos<int32_t, 16>(int32_t angle) {
    return certain_sine(quarter_turns_32<16>(angle) + one_quarter_turn_32);
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw certain_atan2(Raw, Raw) {
    return RawLimits<Raw>::min;
}
template <>
FIXEDPOINT_CONSTEXPR int32_t certain_atan2<int32_t, 16>(int32_t y, int32_t x) {
    return (x | y) == 0 ? 0
                        : rounded_without_doubt(
                              unrounded_angle_32<16>(magnitude(y), magnitude(x), x < 0), y < 0);
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw certain_atan(Raw) {
    return RawLimits<Raw>::min;
}
template <>
FIXEDPOINT_CONSTEXPR int32_t certain_atan<int32_t, 16>(int32_t a) {
    return certain_atan2<int32_t, 16>(a, int32_t(1) << 16);
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw certain_log(Raw) {
    return RawLimits<Raw>::min;
}
template <>
FIXEDPOINT_CONSTEXPR int32_t certain_log<int32_t, 16>(int32_t a) {
    return a > 0 ? rounded_without_doubt(unrounded_log_32<16>(a)) : RawLimits<int32_t>::min;
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw certain_exp(Raw) {
    return RawLimits<Raw>::min;
}
// The mantissa errs by 0.2 units of 2^-31, so the result errs by less than its upper byte plus 1 in
// units of 2^-8 ulp; truncation adds one more unit.
template <>
FIXEDPOINT_CONSTEXPR int32_t certain_exp<int32_t, 16>(int32_t a) {
    const uint64_t power = exp_wide<int64_t, 40>(static_cast<int64_t>(a) * (int32_t(1) << 24), 16);
    const uint32_t whole = static_cast<uint32_t>(power >> 32);
    const int32_t above_tie = static_cast<int32_t>(power >> 24 & 0xff) - 128;
    if (whole >> 31 != 0) return RawLimits<int32_t>::max;
    if (magnitude(above_tie) <= (whole >> 24) + 2) return RawLimits<int32_t>::min;
    return saturated<int32_t>(static_cast<int64_t>(whole) + (above_tie > 0 ? 1 : 0));
}

}  // namespace portable
}  // namespace fixedpoint
