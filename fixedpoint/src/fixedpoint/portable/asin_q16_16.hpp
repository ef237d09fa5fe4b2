// SPDX-License-Identifier: MIT
// The arc sine and the arc cosine in Q16.16, bit for bit as avr/asin_q16_16.S computes them.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/arc_sine_table.hpp>
#include <fixedpoint/portable/interpolation.hpp>

namespace fixedpoint {
namespace portable {

// In units of 2^-23.
constexpr int32_t half_pi_q16_16 = 13176795;

// asin s 2^23 + 64, half an ulp, for s from 0 to 1/2 in units of 2^-22.
FIXEDPOINT_CONSTEXPR int32_t small_arc_sine_q16_16(uint32_t s) {
    const uint8_t interval = static_cast<uint8_t>(s >> 16);
    const uint16_t fraction = static_cast<uint16_t>(s);
    const uint32_t bend = read_program_memory(ArcSineTable<>::arc_bend[interval]);
    return static_cast<int32_t>(
        read_program_memory(ArcSineTable<>::arc_value[interval]) + 2 * s +
        rise(read_program_memory(ArcSineTable<>::arc_slope[interval]), fraction) -
        (height(fraction) * bend >> 7));
}

// sqrt(n 2^-17) in units of 2^-22, for n from 1 to 2^15.
FIXEDPOINT_CONSTEXPR uint32_t root_of_half_q16_16(uint16_t n) {
    uint8_t shift = 0;
    for (; n < 1 << 14; ++shift) n = static_cast<uint16_t>(n << 2);
    const uint8_t interval = static_cast<uint8_t>((n >> 10) - 16);
    const uint16_t fraction = static_cast<uint16_t>(n << 6);
    const uint32_t bend = read_program_memory(ArcSineTable<>::root_bend[interval]);
    return (read_program_memory(ArcSineTable<>::root_value[interval]) +
            rise(read_program_memory(ArcSineTable<>::root_slope[interval]), fraction) +
            (height(fraction) * bend >> 7)) >>
           shift;
}

// asin |a| 2^23 + 64, half an ulp.
FIXEDPOINT_CONSTEXPR int32_t arc_sine_q16_16(int32_t a) {
    const uint32_t positive = magnitude(a);
    if (positive >= uint32_t(1) << 16) return half_pi_q16_16 + 64;
    if (positive < uint32_t(1) << 15) return small_arc_sine_q16_16(positive << 6);
    const uint16_t rest = static_cast<uint16_t>(0 - positive);
    return half_pi_q16_16 + 3 * 64 - 2 * small_arc_sine_q16_16(root_of_half_q16_16(rest));
}

// Both only in Q16.16.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw asin(Raw a) {
    const int32_t angle = arc_sine_q16_16(a) >> 7;
    return a < 0 ? -angle : angle;
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw acos(Raw a) {
    const int32_t angle = arc_sine_q16_16(a);
    return (a < 0 ? half_pi_q16_16 + angle : half_pi_q16_16 + 2 * 64 - angle) >> 7;
}

}  // namespace portable
}  // namespace fixedpoint
