// SPDX-License-Identifier: MIT
// The core of sine, angle and logarithm in the 64-bit formats with 31 to 56 fraction bits other
// than Q32.32, bit for bit as avr/septic_64.S computes it: c0 + t (c1 + t (c2 + ... + t c7)), where
// t in [0, 1) is the position in the interval. tables/septic_64.py generates the tables and states
// their error.
#pragma once

#include <fixedpoint/constexpr.hpp>
#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// The value at x, which is in units of 2^-64; 0 if the value is below 0.
template <class Table>
FIXEDPOINT_CONSTEXPR uint64_t septic_64(uint64_t x) {
    int next = static_cast<uint8_t>(x >> 58) * 46;
    const uint64_t t = x << 6;
    int64_t a = 0;
    // The widths in bytes of the coefficients, 3, 4, 5, 5 and so on, and of the factors before
    // them.
    uint32_t widths = 0x88765543;
    for (uint8_t width = 0; widths != 0; widths >>= 4) {
        // There is no product before the first coefficient.
        const uint64_t upper = width == 0 ? 0 : t >> (64 - 8 * width) % 64;
        uint64_t sum = a < 0 ? 0 - upper : 0;
        for (int i = 0; i < width; ++i) {
            for (int j = width - 1 - i; j < width; ++j) {
                const uint32_t digits = static_cast<uint32_t>(a >> 8 * i & 0xff) *
                                        static_cast<uint32_t>(upper >> 8 * j & 0xff);
                const int column = i + j - width;
                sum += column < 0 ? digits >> 8
                                  : static_cast<uint64_t>(digits) << 8 * (column < 0 ? 0 : column);
            }
        }
        width = widths & 15;
        uint64_t coefficient = 0;
        for (int i = 8 - width; i < 8; ++i)
            coefficient |= static_cast<uint64_t>(read_program_memory(Table::record[next++]))
                           << 8 * i;
        // At the peak of a sine the sum may reach 2^63.
        a = static_cast<int64_t>(
            sum + static_cast<uint64_t>(static_cast<int64_t>(coefficient) >> (64 - 8 * width)));
    }
    const uint64_t value = static_cast<uint64_t>(a);
    return value >> 56 == 0xff ? 0 : value;
}

}  // namespace portable
}  // namespace fixedpoint
