// SPDX-License-Identifier: MIT
// reciprocal_sqrt in Q8.8, bit for bit as avr/reciprocal_sqrt_q8_8.S computes it; within 0.5164
// ulp.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/reciprocal_sqrt_q8_8_table.hpp>

namespace fixedpoint {
namespace portable {

// 2^20 / sqrt(radicand). The radicand must be at least 2^14.
FIXEDPOINT_CONSTEXPR uint16_t reciprocal_root_q8_8(uint16_t radicand) {
    using Table = ReciprocalSqrtQ8_8Table<>;
    // 32 intervals of 2^9 from 2^14 on, 32 of 2^10 from 2^15 on.
    const uint16_t position =
        static_cast<uint16_t>(radicand >> 15 != 0 ? radicand >> 2 : (radicand >> 1) - 0x2000);
    const uint8_t interval = static_cast<uint8_t>(position >> 8);
    return static_cast<uint16_t>(
        read_program_memory(Table::value[interval]) -
        (read_program_memory(Table::slope[interval]) * (position & 0xffu) >> 8));
}

FIXEDPOINT_CONSTEXPR int16_t reciprocal_sqrt_q8_8(int16_t a) {
    if (a < 0) return 0;
    if (a == 0) return RawLimits<int16_t>::max;
    uint16_t radicand = static_cast<uint16_t>(a);
    uint32_t power = 1;
    for (; radicand >> 14 == 0; radicand = static_cast<uint16_t>(radicand << 2)) power <<= 1;
    return static_cast<int16_t>((reciprocal_root_q8_8(radicand) * power + 128) >> 8);
}

}  // namespace portable
}  // namespace fixedpoint
