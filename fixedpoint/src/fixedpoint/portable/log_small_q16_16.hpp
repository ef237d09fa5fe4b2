// SPDX-License-Identifier: MIT
// The natural logarithm in Q16.16 by 16 parabolas, bit for bit as avr/log_q16_16_small.S computes
// it, which says what each step is; within 0.73 ulp for every input.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/log_small_table.hpp>

namespace fixedpoint {
namespace portable {

FIXEDPOINT_CONSTEXPR int32_t log_small_q16_16(int32_t a) {
    using Table = LogarithmSmallTable<>;
    if (a <= 0) return RawLimits<int32_t>::min;
    constexpr int32_t ln2 = 11629080, half_ulp = 128;
    int32_t sum = 15 * ln2 + half_ulp;
    uint32_t normalised = static_cast<uint32_t>(a);
    for (; normalised >> 31 == 0; normalised <<= 1) sum -= ln2;

    const uint32_t fraction = normalised >> 7 & 0xffffff, cell = fraction >> 20;
    const uint32_t d2 = fraction >> 16 & 15, d1 = fraction >> 8 & 0xff, d0 = fraction & 0xff;
    const uint32_t bend = read_program_memory(Table::bend[cell]);
    const uint32_t slope =
        read_program_memory(Table::slope[cell]) - (d2 * bend + (d1 * bend >> 8));
    const uint32_t slope1 = slope >> 8, slope0 = slope & 0xff;
    const uint32_t rise = (d2 * slope1 << 8) + d2 * slope0 + d1 * slope1 + (d1 * slope0 >> 8) +
                          (d0 * slope1 >> 8);
    return (sum + static_cast<int32_t>(read_program_memory(Table::value[cell]) + rise)) >> 8;
}

}  // namespace portable
}  // namespace fixedpoint
