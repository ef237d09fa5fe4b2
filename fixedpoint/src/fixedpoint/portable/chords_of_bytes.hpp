// SPDX-License-Identifier: MIT
// Linear interpolation in the tables of tables/chords_of_bytes.py, as the 16-bit kernels evaluate
// it.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// Whether the tables are accurate enough for the format.
template <class Raw, int F>
constexpr bool is_coarse_16() {
    return sizeof(Raw) == 2 && F <= 8;
}

// In units of the table. The position's high byte is the interval, counted from the table's first.
template <class Table>
FIXEDPOINT_CONSTEXPR uint16_t chord_of_bytes(uint16_t position) {
    const uint8_t interval = static_cast<uint8_t>(position >> 8);
    return static_cast<uint16_t>(
        read_program_memory(Table::value[interval]) +
        (read_program_memory(Table::slope[interval]) * (position & 0xffu) >> 8));
}

}  // namespace portable
}  // namespace fixedpoint
