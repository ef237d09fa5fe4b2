// SPDX-License-Identifier: MIT
// normalise3 of 32-bit numbers with up to 27 fraction bits other than 16, bit for bit as
// avr/normalise3_32.S computes it. The error budget is there.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/column_of_product.hpp>
#include <fixedpoint/portable/reciprocal_root.hpp>

namespace fixedpoint {
namespace portable {

// 2^63 / sqrt(sum 2^24) for a sum of 2^38 to 2^40 - 1, from -2.1 to 1.4 off, at most 2^32 - 1.
FIXEDPOINT_CONSTEXPR uint32_t reciprocal_root_of_sum(uint64_t sum) {
    // y 2^9 is too small by less than 2^-17.1 of it: sum y^2 = 2^84 (1 - e).
    const uint32_t y = reciprocal_root_mantissa(static_cast<uint32_t>(sum >> 8)) - 9;
    const uint64_t square = static_cast<uint64_t>(y) * y;
    const uint32_t product =
        column_of_product(square, sum, 5, 8) + column_of_product(square, sum, 6) +
        (column_of_product(square, sum, 7) << 8) + (column_of_product(square, sum, 8) << 16);
    const uint32_t e = ~product << 4 & 0xffffff;  // 2^-40
    const uint32_t y2 = y >> 16, y1 = y >> 8 & 0xff, e2 = e >> 16, e1 = e >> 8 & 0xff;
    const uint32_t rise = (255 + (y2 * e2 << 8) + y2 * e1 + y1 * e2) >> 8;
    const uint32_t result = (y << 9) + rise;
    return result < rise ? 0xffffffff : result;
}

template <int F>
FIXEDPOINT_CONSTEXPR void normalise3_32(const int32_t* v, int32_t* unit) {
    uint32_t scaled[3] = {};
    uint32_t largest = 0;
    for (int i = 0; i < 3; ++i) {
        scaled[i] =
            v[i] == RawLimits<int32_t>::min ? magnitude(RawLimits<int32_t>::max) : magnitude(v[i]);
        largest |= scaled[i];
    }
    if (largest == 0) {
        for (int i = 0; i < 3; ++i) unit[i] = 0;
        return;
    }
    for (; largest >> 30 == 0; largest <<= 1) {
        for (uint32_t& a : scaled) a <<= 1;
    }
    uint64_t sum = 0;  // of the squares, 2^24
    for (const uint32_t a : scaled) {
        const uint64_t a3 = a >> 24, a2 = a >> 16 & 0xff, a1 = a >> 8 & 0xff, a0 = a & 0xff;
        sum += (a3 * a3 << 24) + (a2 * a2 << 8) + (a1 * a1 >> 8) +
               2 * ((a3 * a2 << 16) + (a3 * a1 << 8) + a2 * a1 + a3 * a0 + (a2 * a0 >> 8));
    }
    const int small = sum >> 38 == 0 ? 1 : 0;
    const uint32_t reciprocal = reciprocal_root_of_sum(sum << 2 * small);
    for (int i = 0; i < 3; ++i) {
        const uint32_t a = scaled[i] << small;
        // In units of 2^-31. The products omitted are worth 3 on average.
        const uint32_t component = 3 + column_of_product(a, reciprocal, 3, 8) +
                                   column_of_product(a, reciprocal, 4) +
                                   (column_of_product(a, reciprocal, 5) << 8) +
                                   (column_of_product(a, reciprocal, 6) << 16);
        const int32_t rounded = static_cast<int32_t>(((component >> (30 - F)) + 1) >> 1);
        unit[i] = v[i] < 0 ? -rounded : rounded;
    }
}

}  // namespace portable
}  // namespace fixedpoint
