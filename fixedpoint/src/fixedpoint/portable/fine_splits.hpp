// SPDX-License-Identifier: MIT
// Sine, cosine, angle and logarithm in the 64-bit formats with 31 to 56 fraction bits other than
// Q32.32, bit for bit as avr/sin_64.S, atan2_64.S and log_64.S compute them.
#pragma once

#include <fixedpoint/portable/exp_q32_32.hpp>
#include <fixedpoint/portable/septic_64.hpp>
#include <fixedpoint/portable/septic_atan_table.hpp>
#include <fixedpoint/portable/septic_log_table.hpp>
#include <fixedpoint/portable/septic_sine_table.hpp>
#include <fixedpoint/portable/split_64.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int F>
constexpr bool is_fine_split() {
    return sizeof(Raw) == 8 && F > 30 && F != 32 && F <= 56;
}

// high 2^64 + low, shifted right and rounded half up. The shift must be in 1..40.
FIXEDPOINT_CONSTEXPR int64_t rounded_64(int8_t high, uint64_t low, int shift) {
    const uint64_t above = static_cast<uint64_t>(int64_t(high)) << (64 - shift);
    return static_cast<int64_t>((above | low >> shift) + (low >> (shift - 1) & 1));
}

// The whole quarter turns in the magnitude of an angle, modulo 256, and the rest, in units of
// 2^-63, below pi/2.
struct QuarterTurnsAndRest {
    uint8_t quarters;
    uint64_t rest;
};
FIXEDPOINT_CONSTEXPR QuarterTurnsAndRest quarter_turns_of_fine(uint64_t positive,
                                                               uint8_t fraction) {
    constexpr uint64_t two_over_pi = 0xa2f9836e4e;      // 2^-40
    constexpr uint64_t half_pi = 0xc90fdaa22168c234;    // 2^-63
    constexpr uint64_t behind_half_pi = 0xc4c6;         // 2^-79
    const uint64_t upper = positive >> (fraction - 7);  // 2^-7
    const uint64_t quarters = fraction_product(upper, two_over_pi, 5) >> 7;
    const uint64_t behind = quarters * behind_half_pi;
    uint64_t rest = (positive << (63 - fraction)) - quarters * half_pi - (behind >> 16) -
                    ((behind & 0xffff) != 0 ? 1 : 0);
    const bool beyond = rest >= half_pi;
    if (beyond) rest -= half_pi;
    return {static_cast<uint8_t>(quarters + (beyond ? 1 : 0)), rest};
}
FIXEDPOINT_CONSTEXPR int64_t sine_of_rest_64(uint8_t quarters, uint64_t rest, bool negative,
                                             uint8_t fraction) {
    constexpr uint64_t half_pi = 0xc90fdaa22168c234;
    const int64_t sine =
        rounded_64(0, septic_64<SepticSineTable<>>((quarters & 1) != 0 ? half_pi - rest : rest),
                   63 - fraction);
    return ((quarters & 2) != 0) != negative ? -sine : sine;
}
template <class Raw, int>
FIXEDPOINT_CONSTEXPR Raw sin_64(Raw a, uint8_t fraction) {
    const QuarterTurnsAndRest angle = quarter_turns_of_fine(magnitude(a), fraction);
    return sine_of_rest_64(angle.quarters, angle.rest, a < 0, fraction);
}
template <class Raw, int>
FIXEDPOINT_CONSTEXPR Raw cos_64(Raw a, uint8_t fraction) {
    const QuarterTurnsAndRest angle = quarter_turns_of_fine(magnitude(a), fraction);
    return sine_of_rest_64(static_cast<uint8_t>(angle.quarters + 1), angle.rest, false, fraction);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void sincos_64(Raw a, Raw* pair, uint8_t fraction) {
    pair[0] = sin_64<Raw, F>(a, fraction);
    pair[1] = cos_64<Raw, F>(a, fraction);
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw atan2_64(Raw y, Raw x, uint8_t fraction) {
    // pi/2, and pi without its leading bit, in units of 2^-63.
    constexpr uint64_t half_pi = 0xc90fdaa22168c235, pi = 0x921fb54442d1846a;
    uint64_t larger = magnitude(x), smaller = magnitude(y);
    const bool steep = smaller > larger;
    if (steep) {
        larger = magnitude(y);
        smaller = magnitude(x);
    }
    if (larger >> 63 != 0) {
        larger >>= 1;
        smaller >>= 1;
    }
    const uint64_t ratio = static_cast<uint64_t>(
        divide_64<Raw, F>(static_cast<Raw>(smaller), static_cast<Raw>(larger), 63));
    uint64_t angle = septic_64<SepticAtanTable<>>(ratio << 1);
    uint8_t above = 0;
    if (steep) angle = half_pi - angle;
    if (x < 0) {
        above = angle <= pi ? 1 : 0;
        angle = pi - angle;
    }
    const Raw rounded = rounded_64(static_cast<int8_t>(above), angle, 63 - fraction);
    return y < 0 ? -rounded : rounded;
}

template <class Raw, int>
FIXEDPOINT_CONSTEXPR Raw log_64(Raw a, uint8_t fraction) {
    if (a <= 0) return RawLimits<Raw>::min;
    constexpr uint64_t ln2 = 0xb17217f7d1cf79ac;  // 2^-64
    uint64_t mantissa = static_cast<uint64_t>(a);
    int exponent = 64 - fraction;
    for (bool is_out = false; !is_out; --exponent) {
        is_out = mantissa >> 63 != 0;
        mantissa <<= 1;
    }
    const Word128 logarithm(0, septic_64<SepticLogTable<>>(mantissa) << 1);
    const Word128 multiple =
        Word128(ln2) * static_cast<uint64_t>(exponent < 0 ? -exponent : exponent);
    const Word128 sum = exponent < 0 ? logarithm - multiple : logarithm + multiple;
    return rounded_64(static_cast<int8_t>(sum.high), sum.low, 64 - fraction);
}

}  // namespace portable
}  // namespace fixedpoint
