// SPDX-License-Identifier: MIT
// normalise3 of Q32.32, bit for bit as avr/normalise3_q32_32.S computes it. The error budget is
// there.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/column_of_product.hpp>
#include <fixedpoint/portable/reciprocal_root.hpp>

namespace fixedpoint {
namespace portable {

// 2^63 / sqrt(sum) for a sum of 2^46 to 2^48 - 1, at most 2^40 - 1.
FIXEDPOINT_CONSTEXPR uint64_t reciprocal_root_of_wide_sum(uint64_t sum) {
    // y 2^17 is too small by less than 2^-17.1 of it: sum y^2 = 2^92 (1 - e).
    const uint32_t y = reciprocal_root_mantissa(static_cast<uint32_t>(sum >> 16)) - 9;
    const uint64_t square = static_cast<uint64_t>(y) * y, upper = square >> 8, rest = sum >> 8;
    // Columns of the bytes 1 to 5 of the square and the bytes of the sum, of which there are six.
    const uint32_t s0 = static_cast<uint32_t>(sum & 0xff);
    const uint32_t product =
        column_of_product(upper, rest, 3, 8) + (static_cast<uint32_t>(upper >> 32) * s0 >> 8) +
        column_of_product(upper, rest, 4) + (column_of_product(upper, rest, 5) << 8) +
        (column_of_product(upper, rest, 6) << 16) + (column_of_product(upper, rest, 7) << 24);
    uint32_t e = ~product << 5;  // 2^-49
    const uint32_t bend = (e >> 24) * (e >> 24);
    e += (bend >> 2) + (bend >> 3);
    const uint64_t rise =
        ((uint64_t(column_of_product(y, e, 5)) << 16) +
         (uint64_t(column_of_product(y, e, 4)) << 8) + column_of_product(y, e, 3)) >>
        9;
    const uint64_t result = (static_cast<uint64_t>(y) << 17) + rise;
    return result >> 40 != 0 ? 0xffffffffff : result;
}

FIXEDPOINT_CONSTEXPR void normalise3_q32_32(const int64_t* v, int64_t* unit) {
    if ((v[0] | v[1] | v[2]) == 0) {
        for (int i = 0; i < 3; ++i) unit[i] = 0;
        return;
    }
    uint64_t largest = 1;
    for (int i = 0; i < 3; ++i) largest |= static_cast<uint64_t>(v[i] < 0 ? ~v[i] : v[i]);
    int shift = 0;
    for (; largest >> 62 == 0; largest <<= 1) ++shift;
    uint64_t scaled[3] = {};
    uint64_t sum = 0;  // of the squares, 2^32
    for (int i = 0; i < 3; ++i) {
        const uint64_t a = magnitude(v[i]) << shift >> 24;
        scaled[i] = a;
        const uint64_t a4 = a >> 32, a3 = a >> 24 & 0xff, a2 = a >> 16 & 0xff, a1 = a >> 8 & 0xff,
                       a0 = a & 0xff;
        sum += (a4 * a4 << 32) + (a3 * a3 << 16) + a2 * a2 +
               2 * ((a4 * a3 << 24) + (a4 * a2 << 16) + ((a4 * a1 + a3 * a2) << 8) + a4 * a0 +
                    a3 * a1 + (a3 * a0 >> 8) + (a2 * a1 >> 8));
    }
    const int small = sum >> 46 == 0 ? 1 : 0;
    const uint64_t reciprocal = reciprocal_root_of_wide_sum(sum << 2 * small);
    for (int i = 0; i < 3; ++i) {
        const uint64_t a = scaled[i] << small;
        // In units of 2^-39. The products omitted are worth 4 on average.
        const uint64_t component = 4 + column_of_product(a, reciprocal, 4, 8) +
                                   uint64_t(column_of_product(a, reciprocal, 5)) +
                                   (uint64_t(column_of_product(a, reciprocal, 6)) << 8) +
                                   (uint64_t(column_of_product(a, reciprocal, 7)) << 16) +
                                   (uint64_t(column_of_product(a, reciprocal, 8)) << 24);
        const int64_t rounded = static_cast<int64_t>(((component >> 6) + 1) >> 1);
        unit[i] = v[i] < 0 ? -rounded : rounded;
    }
}

}  // namespace portable
}  // namespace fixedpoint
