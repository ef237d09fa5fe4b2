// SPDX-License-Identifier: MIT
// The exponential function of Q32.32, bit for bit as avr/exp_q32_32.S computes it.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/exp_64_table.hpp>

namespace fixedpoint {
namespace portable {

// The first `bytes` bytes of the product of two fractions of so many bytes: of the byte products
// that lie below only those of the next column count, with their upper bytes.
FIXEDPOINT_CONSTEXPR uint64_t fraction_product(uint64_t a, uint64_t b, int bytes) {
    uint64_t product = 0;
    for (int i = 0; i < bytes; ++i) {
        for (int j = bytes - 1 - i; j < bytes; ++j) {
            const uint32_t digits =
                static_cast<uint32_t>(a >> 8 * i & 0xff) * static_cast<uint32_t>(b >> 8 * j & 0xff);
            const int column = i + j - bytes;
            product += column < 0 ? digits >> 8
                                  : static_cast<uint64_t>(digits) << 8 * (column < 0 ? 0 : column);
        }
    }
    return product;
}

// 1 - e^-t, t below 2^-16, both in units of 2^-72.
FIXEDPOINT_CONSTEXPR uint64_t fall_of_power_q32_32(uint64_t t) {
    const uint64_t square = fraction_product(t >> 16, t >> 16, 5);
    const uint32_t cube = static_cast<uint32_t>(fraction_product(square >> 16, t >> 32, 3));
    // A third, from the upper two bytes.
    const uint32_t upper = (cube >> 16) * 0x55, middle = (cube >> 8 & 0xff) * 0x55;
    const uint32_t third = (upper << 8) + upper + (upper >> 8) + middle + (middle >> 8);
    return t - ((square - third) >> 1);
}

FIXEDPOINT_CONSTEXPR int64_t exp_q32_32(int64_t a) {
    // From 31 ln 2 on the result is 2^63 or more; below -33 ln 2 it is 0.
    if (a >= 92288378627) return RawLimits<int64_t>::max;
    if (a < -(int64_t(23) << 32)) return 0;

    // k + 41, where a is k ln 2 less what is left, 0 to 0.779.
    const int32_t whole = static_cast<int32_t>(a >> 32) + 24;
    const int32_t fraction = static_cast<int32_t>(a >> 24 & 0xff);
    const int k = static_cast<int>((whole * 185 + (fraction * 185 >> 8) + 945) >> 7);
    using Table = Exp64Table<>;
    // In units of 2^-72, of which the lowest 40 bits are those of the multiple.
    const uint64_t multiple = read_program_memory(Table::multiple[k - 8]);
    const uint32_t upper = static_cast<uint32_t>(multiple >> 32) - static_cast<uint32_t>(a);
    const uint64_t rest = static_cast<uint64_t>(upper & 0xffff) << 40 |
                          (multiple & 0xffffffff) << 8 |
                          read_program_memory(Table::multiple_low[k - 8]);

    const uint64_t q = fall_of_power_q32_32(rest);
    const uint64_t f = read_program_memory(Table::fine[upper >> 16 & 0xff]);
    const uint64_t fall = f + q - fraction_product(f >> 16, q >> 8, 6);
    const uint64_t power = read_program_memory(Table::coarse[upper >> 24]);
    const uint32_t power_low = read_program_memory(Table::coarse_low[upper >> 24]);
    const uint64_t product = fraction_product(power, fall, 8);
    const uint32_t low = (power_low - static_cast<uint32_t>(product)) & 0xff;
    const uint64_t mantissa = power - (product >> 8) - (power_low < (product & 0xff) ? 1 : 0);

    // The mantissa, 2^-72, goes down by 81 - k bits, 8 to 73.
    const int shift = 81 - k;
    const uint64_t doubled = shift == 8   ? mantissa << 1 | low >> 7
                             : shift < 73 ? mantissa >> (shift < 73 && shift > 8 ? shift - 9 : 0)
                                          : 0;
    return static_cast<int64_t>((doubled >> 1) + (doubled & 1));
}

}  // namespace portable
}  // namespace fixedpoint
