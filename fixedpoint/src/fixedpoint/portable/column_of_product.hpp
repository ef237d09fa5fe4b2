// SPDX-License-Identifier: MIT
// One column of a product, for kernels that omit the lowest ones.
#pragma once

#include <stdint.h>

#include <fixedpoint/constexpr.hpp>

namespace fixedpoint {
namespace portable {

// The sum of a_i b_j with i + j = column, where a has six bytes and b five; or of their upper
// bytes, if kept = 8.
FIXEDPOINT_CONSTEXPR uint32_t column_of_product(uint64_t a, uint64_t b, int column, int kept = 0) {
    uint32_t sum = 0;
    for (int i = column < 4 ? 0 : column - 4; i <= column && i < 6; ++i) {
        sum += static_cast<uint32_t>(a >> 8 * i & 0xff) *
                   static_cast<uint32_t>(b >> 8 * (column - i) & 0xff) >>
               kept;
    }
    return sum;
}

}  // namespace portable
}  // namespace fixedpoint
