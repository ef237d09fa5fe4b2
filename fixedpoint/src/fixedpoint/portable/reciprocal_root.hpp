// SPDX-License-Identifier: MIT
// The mantissa of a reciprocal square root from a table, bit for bit as avr/reciprocal_root.inc
// computes it.
#pragma once

#include <fixedpoint/portable/reciprocal_sqrt_table.hpp>
#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// 2^38 / sqrt(radicand), less than 6 from the exact value and below 2^23. The radicand must be at
// least 2^30, and only its upper 24 bits count; tables/reciprocal_sqrt.py gives the formula.
FIXEDPOINT_CONSTEXPR uint32_t reciprocal_root_mantissa(uint32_t radicand) {
    const int h = static_cast<int>(radicand >> 24) - 64;
    const uint32_t l = radicand >> 16 & 0xff, x = radicand >> 8 & 0xff;
    const uint32_t slope = read_program_memory(ReciprocalSqrtTable<>::slope[h]);
    const uint32_t parabola =
        (l * (256 - l) >> 7) * read_program_memory(ReciprocalSqrtTable<>::bulge[h]) >> 7;
    return read_program_memory(ReciprocalSqrtTable<>::value[h]) - (l * (slope & 0xff) >> 8) -
           l * (slope >> 8) - (x * (slope >> 8) >> 8) - parabola;
}

}  // namespace portable
}  // namespace fixedpoint
