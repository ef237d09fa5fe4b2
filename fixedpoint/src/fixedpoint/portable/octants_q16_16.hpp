// SPDX-License-Identifier: MIT
// From the angle in the first octant to that of the vector, bit for bit as avr/octants_q16_16.inc
// computes it.
#pragma once

#include <fixedpoint/integer.hpp>

namespace fixedpoint {
namespace portable {

// `first` is the angle of the vector folded into the first octant, with 24 fraction bits and
// including half an ulp of Q16.16 for rounding. The octant is `steep` (beyond pi/4 from the x
// axis), `left` (x < 0) and `below` (y < 0).
FIXEDPOINT_CONSTEXPR int32_t angle_in_octant_q16_16(uint32_t first, bool steep, bool left,
                                                    bool below) {
    constexpr uint32_t half_pi = 26353589, pi = 52707179, ulp = 256;
    // Subtracting the angle subtracts the half ulp too; `ulp` makes up for it.
    const uint32_t angle = steep ? (left ? half_pi + first : half_pi + ulp - first)
                                 : (left ? pi + ulp - first : first);
    const int32_t rounded = static_cast<int32_t>(angle >> 8);
    return below ? -rounded : rounded;
}

}  // namespace portable
}  // namespace fixedpoint
