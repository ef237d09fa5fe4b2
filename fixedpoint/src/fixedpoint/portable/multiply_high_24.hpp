// SPDX-License-Identifier: MIT
// The product of 24-bit fractions as the assembly kernels form it.
#pragma once

#include <stdint.h>

namespace fixedpoint {
namespace portable {

// a b / 2^24 from six of the nine byte products, three of them without their low byte: up to 5 too
// small.
FIXEDPOINT_CONSTEXPR uint32_t multiply_high_24(uint32_t a, uint32_t b) {
    const uint32_t a0 = a & 0xff, a1 = a >> 8 & 0xff, a2 = a >> 16;
    const uint32_t b0 = b & 0xff, b1 = b >> 8 & 0xff, b2 = b >> 16;
    return (a2 * b2 << 8) + a2 * b1 + a1 * b2 + (a2 * b0 >> 8) + (a1 * b1 >> 8) + (a0 * b2 >> 8);
}

}  // namespace portable
}  // namespace fixedpoint
