// SPDX-License-Identifier: MIT
// The piecewise cubics of Q32.32, bit for bit as avr/cubic_64.S computes them: value + t (slope - t
// (bend + t twist)), where t in [0, 1) is the position in the interval. tables/cubic.py generates
// the tables.
#pragma once

#include <fixedpoint/constexpr.hpp>
#include <fixedpoint/portable/cubic_32.hpp>
#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// In units of 2^-39, modulo 2^40, including half an ulp of Q32.32 for rounding. The position, below
// 2^40, is in units of 2^-40 of the whole table.
template <class Table>
FIXEDPOINT_CONSTEXPR uint64_t cubic_64(uint64_t position) {
    const uint8_t interval = static_cast<uint8_t>(position >> 32);
    const uint32_t t = static_cast<uint32_t>(position);
    const uint32_t t0 = t & 0xff, t1 = t >> 8 & 0xff, t2 = t >> 16 & 0xff, t3 = t >> 24;
    const int32_t twist = twist_of<Table>(interval);
    const uint32_t bend = read_program_memory(Table::bend[interval]) +
                          static_cast<uint32_t>(twist * static_cast<int32_t>(t3) +
                                                (twist * static_cast<int32_t>(t2) >> 8));
    const uint32_t b0 = bend & 0xff, b1 = bend >> 8 & 0xff, b2 = bend >> 16;
    const uint32_t slope =
        read_program_memory(Table::slope[interval]) -
        ((b2 * t3 << 8) + b2 * t2 + b1 * t3 + (b2 * t1 >> 8) + (b1 * t2 >> 8) + (b0 * t3 >> 8));
    const uint32_t s0 = slope & 0xff, s1 = slope >> 8 & 0xff, s2 = slope >> 16 & 0xff,
                   s3 = slope >> 24;
    const uint32_t rise = (s3 * t3 << 16) + ((s3 * t2 + s2 * t3) << 8) + s3 * t1 + s2 * t2 +
                          s1 * t3 + (s3 * t0 >> 8) + (s2 * t1 >> 8) + (s1 * t2 >> 8) +
                          (s0 * t3 >> 8);
    const uint64_t value = static_cast<uint64_t>(read_program_memory(Table::value[interval])) << 8 |
                           read_program_memory(Table::value_low[interval]);
    return (value + rise) & 0xffffffffff;
}

}  // namespace portable
}  // namespace fixedpoint
