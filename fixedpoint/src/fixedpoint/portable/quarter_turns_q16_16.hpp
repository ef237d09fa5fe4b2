// SPDX-License-Identifier: MIT
// The angle of the Q16.16 sine and cosine in quarter turns, bit for bit as
// avr/quarter_turns_q16_16.inc computes it.
#pragma once

#include <stdint.h>

namespace fixedpoint {
namespace portable {

constexpr uint32_t one_quarter_turn_q16_16 = uint32_t(1) << 24;

// The angle in quarter turns, modulo 256, with 24 fraction bits. It is up to 6 units too small
// because of the byte products that the kernel omits.
FIXEDPOINT_CONSTEXPR uint32_t quarter_turns_q16_16(int32_t angle) {
    const uint32_t a = static_cast<uint32_t>(angle);
    const uint32_t a0 = a & 0xff, a1 = a >> 8 & 0xff, a2 = a >> 16 & 0xff, a3 = a >> 24;
    // 2/pi = 0.a2f9836e4e...
    constexpr uint32_t m0 = 0x4e, m1 = 0x6e, m2 = 0x83, m3 = 0xf9, m4 = 0xa2;
    const uint32_t near_zero = (a0 * m3 >> 8) + (a1 * m2 >> 8) + (a2 * m1 >> 8) + a0 * m4 +
                               a1 * m3 + a2 * m2 + ((a1 * m4 + a2 * m3) << 8) + (a2 * m4 << 16);
    if (a3 == 0) return near_zero;
    if (a3 == 0xff) return near_zero - 0xa2f9836e;
    const uint32_t unsigned_turns =
        near_zero + (a3 * m0 >> 8) + a3 * m1 + (a3 * m2 << 8) + (a3 * m3 << 16) + (a3 * m4 << 24);
    return angle < 0 ? unsigned_turns - 0xf9836e4e : unsigned_turns;
}

// The position in the first quarter with the same sine, up to its sign.
FIXEDPOINT_CONSTEXPR uint32_t fold_quarter_turns_q16_16(uint32_t turns) {
    const bool backward = (turns >> 24 & 1) != 0;
    return (backward ? ~turns : turns) & 0xffffff;
}
constexpr bool is_lower_half_turn_q16_16(uint32_t turns) { return (turns >> 25 & 1) != 0; }

}  // namespace portable
}  // namespace fixedpoint
