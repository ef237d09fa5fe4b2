// SPDX-License-Identifier: MIT
// exp in Q8.8, bit for bit as avr/exp_q8_8.S computes it; within 0.519 ulp.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/exp_q8_8_table.hpp>

namespace fixedpoint {
namespace portable {

FIXEDPOINT_CONSTEXPR int16_t exp_q8_8(int16_t a) {
    if (a < -1600) return 0;
    if (a >= 1243) return RawLimits<int16_t>::max;
    const uint16_t position = static_cast<uint16_t>(a + 1600);
    const uint8_t distance = position & 63;

    // Units of 2^-7 ulp and of 2^-17.
    const uint32_t power = read_program_memory(ExpQ8_8Table<>::power[position >> 6]);
    const uint16_t growth =
        static_cast<uint16_t>(512 * distance + distance * (distance + 5) +
                              read_program_memory(ExpQ8_8Table<>::growth[distance]));
    const uint32_t power0 = power & 0xff, power1 = power >> 8 & 0xff, power2 = power >> 16;
    const uint32_t growth0 = growth & 0xff, growth1 = growth >> 8;
    const uint32_t product = (power2 * growth1 << 8) + power2 * growth0 + power1 * growth1 +
                             (power1 * growth0 >> 8) + (power0 * growth1 >> 8);
    return static_cast<int16_t>((2 * power + product + 128) >> 8);
}

}  // namespace portable
}  // namespace fixedpoint
