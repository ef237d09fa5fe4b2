// SPDX-License-Identifier: MIT
// The cube root of Q32.32, bit for bit as avr/cbrt_q32_32.S computes it.
#pragma once

#include <fixedpoint/portable/cbrt_64_table.hpp>
#include <fixedpoint/portable/cubic_64.hpp>
#include <fixedpoint/portable/exp_q32_32.hpp>

namespace fixedpoint {
namespace portable {

// Bytes 8 to 10 of the cube of 2^40 + u, in units of 2^-120, including the carries from byte 7. u
// must be below 2^39.
FIXEDPOINT_CONSTEXPR uint32_t middle_of_cube(uint64_t u) {
    // The square from byte 2 on, without 2^80.
    uint64_t square = u << 25;
    for (int i = 0; i < 5; ++i) {
        for (int j = 0; j < 5; ++j) {
            const uint64_t product = (u >> 8 * i & 0xff) * (u >> 8 * j & 0xff);
            if (i + j >= 2) square += product << 8 * (i + j >= 2 ? i + j - 2 : 0);
        }
    }
    uint32_t cube = static_cast<uint32_t>(square) + static_cast<uint32_t>(u << 24);
    for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 5; ++j) {
            const uint32_t product = static_cast<uint32_t>(square >> 8 * i & 0xff) *
                                     static_cast<uint32_t>(u >> 8 * j & 0xff);
            const int column = i + j - 5;
            if (column >= 0 && column < 4) cube += product << 8 * (column < 0 ? 0 : column % 4);
        }
    }
    return cube >> 8;
}

// One Newton step: the root y = 1 + u from the table becomes y + (m - y^3) / (3 y^2), where m is
// the mantissa; the slope of the table is 1 / (3 y^2).
FIXEDPOINT_CONSTEXPR int64_t cbrt_q32_32(int64_t a) {
    using Table = Cbrt64Table<>;
    constexpr uint64_t half_roots[3] = {0x80000000000000, 0xa14517cc6b9457,
                                        0xcb2ff529eb71e4};  // 2^-56
    if (a == 0) return 0;
    uint64_t mantissa = magnitude(a);
    int place = 64;
    while (mantissa >> 63 == 0) {
        mantissa <<= 1;
        --place;
    }
    mantissa <<= 1;
    const uint64_t position = mantissa >> 24;
    const uint8_t interval = static_cast<uint8_t>(position >> 32);
    const uint64_t root = cubic_64<Table>(position);  // 2^-39
    const uint32_t bend = read_program_memory(Table::bend[interval]) >> 16;
    const int32_t slope =
        static_cast<int32_t>((read_program_memory(Table::slope[interval]) >> 16) -
                             (bend * static_cast<uint8_t>(position >> 24) >> 7));  // 2^-15
    // The residual m - y^3 is in -84..16 2^-39, since the table's root is biased upward: 24 bits in
    // units of 2^-56.
    const uint32_t rest =
        (static_cast<uint32_t>(mantissa >> 8) - middle_of_cube(root << 1)) & 0xffffff;
    const int64_t distance = static_cast<int64_t>(rest) - (rest < 0x400000 ? 0 : 0x1000000);
    const uint64_t fine = (uint64_t(1) << 55) + (root << 16) +
                          static_cast<uint64_t>(distance * slope >> 16);       // 2^-55
    const uint64_t scaled = fraction_product(fine, half_roots[place % 3], 7);  // 2^-54
    const int64_t result = static_cast<int64_t>(((scaled >> (32 - place / 3)) + 1) >> 1);
    return a < 0 ? -result : result;
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw cbrt(Raw a) {
    return cbrt_q32_32(a);
}

}  // namespace portable
}  // namespace fixedpoint
