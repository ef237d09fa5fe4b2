// SPDX-License-Identifier: MIT
// The exponential function of Q32.32 and what follows from its core, bit for bit as
// avr/exp_q32_32.S, avr/exp2_q32_32.S and avr/hyperbolic_q32_32.S compute them.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/exp_64_table.hpp>
#include <fixedpoint/portable/word128.hpp>

namespace fixedpoint {
namespace portable {

// The first `bytes` bytes of the product of two fractions of that many bytes. Of the byte products
// below them, only the upper bytes of the next column are included.
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

// 1 - e^-t for t below 2^-16, both in units of 2^-72.
FIXEDPOINT_CONSTEXPR uint64_t fall_of_power_q32_32(uint64_t t) {
    const uint64_t square = fraction_product(t >> 16, t >> 16, 5);
    const uint32_t cube = static_cast<uint32_t>(fraction_product(square >> 16, t >> 32, 3));
    // A third, from the upper two bytes.
    const uint32_t upper = (cube >> 16) * 0x55, middle = (cube >> 8 & 0xff) * 0x55;
    const uint32_t third = (upper << 8) + upper + (upper >> 8) + middle + (middle >> 8);
    return t - ((square - third) >> 1);
}

// whole 2^-32 + guard 2^-40.
struct GuardedPower {
    uint64_t whole;
    uint8_t guard;
};
constexpr int64_t rounded(GuardedPower power) {
    return static_cast<int64_t>(power.whole + (power.guard >> 7));
}

// 2^k e^-r, rounded downward. k must be in -33..33 and r below 0.78; r is in units of 2^-72, and
// `upper` its upper two bytes.
FIXEDPOINT_CONSTEXPR GuardedPower power_of_rest_q32_32(int k, uint16_t upper, uint64_t rest) {
    using Table = Exp64Table<>;
    const uint64_t q = fall_of_power_q32_32(rest);
    const uint64_t f = read_program_memory(Table::fine[upper & 0xff]);
    const uint64_t fall = f + q - fraction_product(f >> 16, q >> 8, 6);
    const uint64_t power = read_program_memory(Table::coarse[upper >> 8]);
    const uint32_t power_low = read_program_memory(Table::coarse_low[upper >> 8]);
    const uint64_t product = fraction_product(power, fall, 8);
    const uint64_t low = (power_low - static_cast<uint32_t>(product)) & 0xff;
    const uint64_t mantissa = power - (product >> 8) - (power_low < (product & 0xff) ? 1 : 0);

    // The mantissa, in units of 2^-72, is shifted right by -1 to 65 bits to units of 2^-40.
    const int shift = 32 - k;
    if (shift < 0) return {mantissa << 1 | low >> 7, static_cast<uint8_t>(low << 1)};
    if (shift >= 64) return {0, static_cast<uint8_t>(mantissa >> (shift - 8))};
    return {mantissa >> shift,
            static_cast<uint8_t>(shift < 8 ? mantissa << (8 - shift) | low >> shift
                                           : mantissa >> (shift - 8))};
}

// e^a for a in units of 2^-72. a must be in [-23, 32 ln 2).
FIXEDPOINT_CONSTEXPR GuardedPower unrounded_exp_72(const Word128& a) {
    // k + 41, where a is k ln 2 minus a rest in 0..0.779.
    const int32_t whole = static_cast<int32_t>(static_cast<int64_t>(a.high) >> 8) + 24;
    const int32_t fraction = static_cast<uint8_t>(a.high);
    const int k = static_cast<int>((whole * 185 + (fraction * 185 >> 8) + 945) >> 7);
    using Table = Exp64Table<>;
    const uint64_t multiple = read_program_memory(Table::multiple[k - 8]);
    const Word128 rest =
        Word128(multiple >> 56, multiple << 8 | read_program_memory(Table::multiple_low[k - 8])) -
        a;
    return power_of_rest_q32_32(
        k - 41, static_cast<uint16_t>(rest.high << 8 | static_cast<uint8_t>(rest.low >> 56)),
        rest.low & 0xffffffffffffff);
}
FIXEDPOINT_CONSTEXPR GuardedPower unrounded_exp_q32_32(int64_t a) {
    return unrounded_exp_72(
        Word128(static_cast<uint64_t>(a >> 24), static_cast<uint64_t>(a) << 40));
}

FIXEDPOINT_CONSTEXPR int64_t exp_q32_32(int64_t a) {
    // From 31 ln 2 on the result is 2^63 or more; below -33 ln 2 it is 0.
    if (a >= 92288378627) return RawLimits<int64_t>::max;
    if (a < -(int64_t(23) << 32)) return 0;
    return rounded(unrounded_exp_q32_32(a));
}

// 2^fraction e^(a / 2^fraction) = 2^32 e^x, bit for bit as avr/exp_64.S computes it.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw exp_64(Raw a, uint8_t fraction) {
    using Table = Exp64Table<>;
    const Raw whole = a >> fraction;
    if (whole >= 64) return RawLimits<Raw>::max;
    if (whole < -64) return 0;
    const uint64_t behind = fraction == 0 ? 0 : static_cast<uint64_t>(a) << (64 - fraction) % 64;
    const uint64_t whole_of_multiple = static_cast<uint64_t>(((178 * fraction + 192) >> 8) - 23);
    const Word128 x =
        Word128(static_cast<uint64_t>(whole) << 8 | behind >> 56, behind << 8) +
        Word128(whole_of_multiple << 8 | read_program_memory(Table::multiple[fraction + 1]) >> 56,
                read_program_memory(Table::multiple[fraction + 1]) << 8 |
                    read_program_memory(Table::multiple_low[fraction + 1]));
    const int64_t whole_of_x = static_cast<int64_t>(x.high) >> 8;
    if (whole_of_x >= 22) return RawLimits<Raw>::max;
    if (whole_of_x < -23) return 0;
    const Raw power = rounded(unrounded_exp_72(x));
    return power < 0 ? RawLimits<Raw>::max : power;
}

// Only in Q32.32; the caller must check the range.

// e^a in units of 2^-40, rounded downward. a must be in [-23, 15].
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw exp_fine(Raw a) {
    const GuardedPower power = unrounded_exp_q32_32(a);
    return static_cast<Raw>(power.whole << 8 | power.guard);
}

// (e^a + e^-a) / 2 and (e^a - e^-a) / 2. a must be in [0, 32 ln 2).
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw cosh_unsaturated(Raw a) {
    const GuardedPower rising = unrounded_exp_q32_32(a), falling = unrounded_exp_q32_32(-a);
    const uint64_t carry = static_cast<uint64_t>(rising.guard + falling.guard) >> 8;
    return static_cast<Raw>((rising.whole + falling.whole + carry + 1) >> 1);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw sinh_unsaturated(Raw a) {
    const GuardedPower rising = unrounded_exp_q32_32(a), falling = unrounded_exp_q32_32(-a);
    const uint64_t borrow = rising.guard < falling.guard ? 1 : 0;
    return static_cast<Raw>((rising.whole - falling.whole - borrow + 1) >> 1);
}

// 2^a. a must be in [-33, 31).
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw exp2_unsaturated(Raw a) {
    // In units of 2^-72.
    constexpr uint8_t ln2[9] = {0xca, 0xab, 0x79, 0xcf, 0xd1, 0xf7, 0x17, 0x72, 0xb1};
    const uint32_t g = uint32_t(0) - static_cast<uint32_t>(a);
    // The rest; its lowest byte belongs to the current column.
    uint8_t rest[9] = {};
    uint32_t sum = 0;
    for (int column = -1; column < 9; ++column) {
        for (int i = 0; i < 4; ++i) {
            const int j = column + 4 - i;
            if (j < 0 || j > 8) continue;
            const uint32_t product = (g >> 8 * i & 0xff) * ln2[j < 0 || j > 8 ? 0 : j];
            sum += column < 0 ? product >> 8 : product;
        }
        if (column < 0) continue;
        rest[column < 0 ? 0 : column] = static_cast<uint8_t>(sum);
        sum >>= 8;
    }
    uint64_t lower = 0;
    for (int i = 6; i >= 0; --i) lower = lower << 8 | rest[i];
    return rounded(power_of_rest_q32_32(static_cast<int>(a >> 32) + (g != 0 ? 1 : 0),
                                        static_cast<uint16_t>(rest[8] << 8 | rest[7]), lower));
}

}  // namespace portable
}  // namespace fixedpoint
