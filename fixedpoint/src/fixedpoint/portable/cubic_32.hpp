// SPDX-License-Identifier: MIT
// Piecewise cubics on 256 intervals, the core of every 32-bit function, bit for bit as
// avr/cubic_32.S computes them: value + t (slope - t (bend + t twist)), where t in [0, 1) is the
// position in the interval. tables/cubic.py generates the tables.
#pragma once

#include <fixedpoint/constexpr.hpp>
#include <fixedpoint/portable/multiply_high_24.hpp>
#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// Whether the 32-bit core is accurate enough for a function whose results are below 2.
template <int F>
constexpr bool is_coarse_32() {
    return F <= 24;
}

// Signed, in program memory as a plain byte.
template <class Table>
FIXEDPOINT_CONSTEXPR int32_t twist_of(uint8_t interval) {
    return static_cast<int8_t>(read_program_memory(Table::twist[interval]));
}

// In units of 2^-31, modulo 2^32, within 5.7 units (avr/cubic_core_32.inc). The position is in
// units of 2^-32 of the whole table.
template <class Table>
FIXEDPOINT_CONSTEXPR uint32_t cubic_32(uint32_t position) {
    const uint8_t interval = static_cast<uint8_t>(position >> 24);
    const int32_t t = static_cast<int32_t>(position & 0xffffff), t1 = t >> 8 & 0xff, t2 = t >> 16;
    const int32_t bent =
        read_program_memory(Table::bend[interval]) + (twist_of<Table>(interval) * t2 >> 8);
    const int32_t fall = (bent >> 8) * t2 + ((bent >> 8) * t1 >> 8) + ((bent & 0xff) * t2 >> 8);
    const uint32_t slope =
        (read_program_memory(Table::slope[interval]) >> 8) - static_cast<uint32_t>(fall);
    return read_program_memory(Table::value[interval]) +
           multiply_high_24(slope, static_cast<uint32_t>(t));
}

// slope t / 2^24, without the parts below the unit, as the products of bytes that are added.
FIXEDPOINT_CONSTEXPR uint32_t rise_40(uint32_t slope, uint32_t t) {
    const uint32_t t0 = t & 0xff, t1 = t >> 8 & 0xff, t2 = t >> 16;
    const uint32_t s0 = slope & 0xff, s1 = slope >> 8 & 0xff, s2 = slope >> 16 & 0xff,
                   s3 = slope >> 24;
    return (s3 * t2 << 16) + ((s3 * t1 + s2 * t2) << 8) + s3 * t0 + s2 * t1 + s1 * t2 +
           (s2 * t0 >> 8) + (s1 * t1 >> 8) + (s0 * t2 >> 8);
}

template <class Table>
FIXEDPOINT_CONSTEXPR uint64_t value_of(uint8_t interval) {
    return static_cast<uint64_t>(read_program_memory(Table::value[interval])) << 8 |
           read_program_memory(Table::value_low[interval]);
}

// In units of 2^-39, modulo 2^40, within 57 units, 2^-33.1, and the upper byte of the slope.
struct Cubic40 {
    uint64_t value;
    uint32_t slope;
};
template <class Table>
FIXEDPOINT_CONSTEXPR Cubic40 cubic_40(uint32_t position) {
    const uint8_t interval = static_cast<uint8_t>(position >> 24);
    const uint32_t t = position & 0xffffff, t2 = t >> 16;
    const uint32_t bent =
        static_cast<uint32_t>(
            (static_cast<int32_t>(read_program_memory(Table::bend[interval])) << 8) +
            twist_of<Table>(interval) * static_cast<int32_t>(t2)) &
        0xffffff;
    const uint32_t slope = read_program_memory(Table::slope[interval]) - multiply_high_24(bent, t);
    return {(value_of<Table>(interval) + rise_40(slope, t)) & 0xffffffffff, slope >> 24};
}

}  // namespace portable
}  // namespace fixedpoint
