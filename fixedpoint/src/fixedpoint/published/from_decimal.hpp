// SPDX-License-Identifier: MIT
// from_decimal: integer / 10^decimals truncated toward zero, modulo 2^W, as in the 2016 design:
// from_decimal<int32_t, 16>(38, 2) is 0.38.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/wide.hpp>
#include <fixedpoint/published/magnitude.hpp>

namespace fixedpoint {
namespace published {

// Corrected: the power of ten, originally a 16-bit int, overflowed from the fifth decimal on.
// Beyond the 19th decimal nothing is left of a 32-bit integer.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw from_decimal(int32_t integer, uint8_t decimals) {
    if (decimals > 19) return 0;
    uint64_t power = 1;
    for (uint8_t i = 0; i < decimals; ++i) power *= 10;
    return flip_sign<Raw>(
        static_cast<Unsigned<Raw>>(divide_magnitudes<int64_t, F>(magnitude(integer), power)),
        integer < 0 ? -1 : 1);
}

}  // namespace published
}  // namespace fixedpoint
