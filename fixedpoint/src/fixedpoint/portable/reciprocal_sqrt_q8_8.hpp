// SPDX-License-Identifier: MIT
// reciprocal_sqrt in Q8.8, bit for bit as avr/reciprocal_sqrt_q8_8.S computes it; within 0.5164
// ulp.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/reciprocal_sqrt_q8_8_table.hpp>

namespace fixedpoint {
namespace portable {

FIXEDPOINT_CONSTEXPR int16_t reciprocal_sqrt_q8_8(int16_t a) {
    using Table = ReciprocalSqrtQ8_8Table<>;
    if (a < 0) return 0;
    if (a == 0) return RawLimits<int16_t>::max;
    uint16_t radicand = static_cast<uint16_t>(a);
    uint8_t power = 1;
    for (; radicand >> 14 == 0; radicand = static_cast<uint16_t>(radicand << 2))
        power = static_cast<uint8_t>(power << 1);
    // 32 intervals of 2^9 from 2^14 on, 32 of 2^10 from 2^15 on.
    const bool upper = radicand >> 15 != 0;
    const uint16_t position =
        upper ? radicand >> 2 : static_cast<uint16_t>((radicand >> 1) - 0x2000);
    const uint8_t interval = static_cast<uint8_t>(position >> 8);
    const uint32_t value = static_cast<uint32_t>(
        read_program_memory(Table::value[interval]) -
        (read_program_memory(Table::slope[interval]) * (position & 0xffu) >> 8));
    return static_cast<int16_t>((value * power + 128) >> 8);
}

}  // namespace portable
}  // namespace fixedpoint
