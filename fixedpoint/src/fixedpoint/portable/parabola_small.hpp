// SPDX-License-Identifier: MIT
// A function on [0, 1) by 16 parabolas, bit for bit as avr/parabola_small.S computes it.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// The function of x in the table's units; x is a fraction of 24 bits.
template <class Table>
FIXEDPOINT_CONSTEXPR uint32_t parabola_small(uint32_t x) {
    const uint32_t cell = x >> 20, d2 = x >> 16 & 15, d1 = x >> 8 & 0xff, d0 = x & 0xff;
    const uint32_t bend = read_program_memory(Table::bend[cell]);
    const uint32_t slope = read_program_memory(Table::slope[cell]) - (d2 * bend + (d1 * bend >> 8));
    const uint32_t slope1 = slope >> 8, slope0 = slope & 0xff;
    return read_program_memory(Table::value[cell]) + (d2 * slope1 << 8) + d2 * slope0 +
           d1 * slope1 + (d1 * slope0 >> 8) + (d0 * slope1 >> 8);
}

}  // namespace portable
}  // namespace fixedpoint
