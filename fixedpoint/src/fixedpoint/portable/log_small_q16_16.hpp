// SPDX-License-Identifier: MIT
// The natural logarithm in Q16.16 by 16 parabolas, bit for bit like avr/log_q16_16_small.S; within
// 0.74 ulp for every input.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/log_small_table.hpp>

namespace fixedpoint {
namespace portable {

// ln(1 + x) in units of 2^-24, plus half an ulp of Q16.16; x is a fraction of 24 bits.
FIXEDPOINT_CONSTEXPR uint32_t parabola_small(uint32_t x) {
    using Table = LogarithmSmallTable<>;
    const uint32_t cell = x >> 20, d2 = x >> 16 & 15, d1 = x >> 8 & 0xff, d0 = x & 0xff;
    const uint32_t tangent = read_program_memory(Table::slope[cell]);
    const uint32_t bend = ((tangent >> 8) * (tangent >> 8) >> 8) * 122 >> 8;
    const uint32_t slope = tangent - (d2 * bend + (d1 * bend >> 8));
    const uint32_t slope1 = slope >> 8, slope0 = slope & 0xff;
    return read_program_memory(Table::value[cell]) + (d2 * slope1 << 8) + d2 * slope0 +
           d1 * slope1 + (d1 * slope0 >> 8) + (d0 * slope1 >> 8);
}

FIXEDPOINT_CONSTEXPR int32_t log_small_q16_16(int32_t a) {
    if (a <= 0) return RawLimits<int32_t>::min;
    constexpr int32_t ln2 = 11629080;
    int32_t sum = 15 * ln2;
    uint32_t normalised = static_cast<uint32_t>(a);
    for (; normalised >> 31 == 0; normalised <<= 1) sum -= ln2;
    const uint32_t fraction = normalised >> 7 & 0xffffff;
    return (sum + static_cast<int32_t>(parabola_small(fraction))) >> 8;
}

}  // namespace portable
}  // namespace fixedpoint
