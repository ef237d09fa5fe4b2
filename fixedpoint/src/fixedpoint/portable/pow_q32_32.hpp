// SPDX-License-Identifier: MIT
// x^y of Q32.32 for x > 0, bit for bit as avr/pow_q32_32.S computes it.
#pragma once

#include <fixedpoint/portable/exp_q32_32.hpp>
#include <fixedpoint/portable/pow_64_table.hpp>
#include <fixedpoint/portable/word128.hpp>

namespace fixedpoint {
namespace portable {

// (1 + s)(1 - digit 2^-8place) - 1, in units of 2^-104.
FIXEDPOINT_CONSTEXPR Word128 times_factor(const Word128& s, uint8_t digit, int place) {
    return s - (Word128(digit) << (104 - 8 * place)) - ((s * digit) >> 8 * place);
}

// ln(1 + s) for s below 2^-23, both in units of 2^-104.
FIXEDPOINT_CONSTEXPR Word128 logarithm_beside_1(const Word128& s) {
    // In units of 2^-103, 2^-79 and 2^-102: s^2 / 2 is square's, s^3 / 2 is cube's.
    const Word128 half = s >> 1;
    const uint64_t fraction = static_cast<uint64_t>(half >> 24);
    const uint64_t square = fraction_product(fraction, fraction, 7);
    const uint64_t cube = fraction_product(square >> 24, fraction >> 24, 4);
    const uint64_t upper = square >> 48;
    // cube / 3 is 85/256 (cube + cube/256 + ...).
    const uint64_t third = cube * 85;
    return (half - Word128(square + (upper * upper >> 7) - cube - (third >> 8) - (third >> 16) -
                           (third >> 24) - (third >> 32)))
           << 1;
}

// ln a in units of 2^-104, modulo 2^128. a must not be 0.
FIXEDPOINT_CONSTEXPR Word128 logarithm_104(uint64_t a) {
    using Table = Pow64Table<>;
    uint8_t exponent = 63;
    while (a >> 63 == 0) {
        a <<= 1;
        --exponent;
    }
    const Word128 ln2(read_program_memory(Table::ln2[1]), read_program_memory(Table::ln2[0]));
    Word128 s = Word128(a << 1) << 40;
    const uint8_t first = static_cast<uint8_t>(s >> 98);
    s = times_factor(s, static_cast<uint8_t>(read_program_memory(Table::first_digits[first])), 1);
    const uint8_t second = static_cast<uint8_t>(s >> 92);
    const uint16_t of_second = read_program_memory(Table::second_digits[second]);
    s = times_factor(s, static_cast<uint8_t>(of_second >> 8), 1);
    s = times_factor(s, static_cast<uint8_t>(of_second), 2);
    const uint8_t third = static_cast<uint8_t>(s >> 86);
    const uint16_t of_third = read_program_memory(Table::third_digits[third]);
    s = times_factor(s, static_cast<uint8_t>(of_third >> 8), 2);
    s = times_factor(s, static_cast<uint8_t>(of_third), 3);
    const uint8_t fourth = static_cast<uint8_t>(s >> 80);
    s = times_factor(s, static_cast<uint8_t>(read_program_memory(Table::fourth_digits[fourth])), 3);
    return logarithm_beside_1(s) + ln2 * exponent +
           Word128(read_program_memory(Table::first_upper[first]),
                   read_program_memory(Table::first_lower[first])) +
           Word128(read_program_memory(Table::second_upper[second]),
                   read_program_memory(Table::second_lower[second])) +
           Word128(read_program_memory(Table::third_upper[third]),
                   read_program_memory(Table::third_lower[third])) +
           Word128(read_program_memory(Table::fourth_upper[fourth]),
                   read_program_memory(Table::fourth_lower[fourth]));
}

// x^y as an unsigned number. If it is out of range, the result is only guaranteed to be above 2^63.
// x is unsigned too and must not be 0.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw pow_unsaturated(Raw x, Raw y) {
    static_assert(F == 32, "This is the power of Q32.32.");
    const Word128 logarithm = logarithm_104(static_cast<uint64_t>(x));
    const bool below_1 = static_cast<int64_t>(logarithm.high) < 0;
    const bool falls = below_1 != (y < 0);
    const Word128 distance = below_1 ? Word128() - logarithm : logarithm;
    const uint64_t factor = magnitude(y);

    // Their product in bytes, in units of 2^-72, from column 7 of the byte products on; only the
    // carries of that column count.
    uint8_t bytes[10] = {};
    uint32_t sum = 0;
    bool beyond = false;
    for (int column = 7; column < 22; ++column) {
        for (int i = 0; i < 8; ++i) {
            const int j = column - i;
            if (j < 0 || j > 13) continue;
            sum += static_cast<uint32_t>(factor >> 8 * i & 0xff) *
                   static_cast<uint8_t>(distance >> 8 * j);
        }
        if (column >= 18) {
            beyond = beyond || sum != 0;
        } else if (column >= 8) {
            bytes[column - 8] = static_cast<uint8_t>(sum);
        }
        sum >>= 8;
    }
    const uint8_t limit = falls ? 23 : 22;
    Word128 product(static_cast<uint64_t>(bytes[9]) << 8 | bytes[8], 0);
    for (int i = 7; i >= 0; --i) product.low = product.low << 8 | bytes[i];
    if (beyond || bytes[9] >= limit) product = Word128(static_cast<uint64_t>(limit) << 8, 0);
    if (falls) product = Word128() - product;
    return rounded(unrounded_exp_72(product));
}

}  // namespace portable
}  // namespace fixedpoint
