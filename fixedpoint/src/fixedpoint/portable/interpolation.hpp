// SPDX-License-Identifier: MIT
// Interpolation in tables, bit for bit as the assembly kernels do it: linear on 256 intervals, and
// the terms of parabolas.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// slope fraction / 2^16 from three of the four byte products, two of them without their low byte.
FIXEDPOINT_CONSTEXPR uint16_t rise(uint16_t slope, uint16_t fraction) {
    const uint16_t slope_high = slope >> 8, slope_low = slope & 0xff;
    const uint16_t fraction_high = fraction >> 8, fraction_low = fraction & 0xff;
    return static_cast<uint16_t>(slope_high * fraction_high + (slope_high * fraction_low >> 8) +
                                 (slope_low * fraction_high >> 8));
}

// The height of a parabola with unit `bend` above its chord: t (1 - t) 2^9.
FIXEDPOINT_CONSTEXPR uint16_t height(uint16_t fraction) {
    const uint16_t fraction_high = fraction >> 8;
    return static_cast<uint16_t>(fraction_high * (255 - fraction_high) >> 7);
}

// `position`: the interval in bits 16..23, the fraction of it in bits 0..15.
template <class Table>
FIXEDPOINT_CONSTEXPR uint32_t interpolate_rising(uint32_t position) {
    const uint8_t interval = static_cast<uint8_t>(position >> 16);
    return read_program_memory(Table::value[interval]) +
           rise(read_program_memory(Table::slope[interval]), static_cast<uint16_t>(position));
}
template <class Table>
FIXEDPOINT_CONSTEXPR uint32_t interpolate_falling(uint32_t position) {
    const uint8_t interval = static_cast<uint8_t>(position >> 16);
    return read_program_memory(Table::value[interval]) -
           rise(read_program_memory(Table::slope[interval]), static_cast<uint16_t>(position));
}

}  // namespace portable
}  // namespace fixedpoint
