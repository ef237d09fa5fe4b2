// SPDX-License-Identifier: MIT
// x^n of a number of 64 bits, by squaring, on a mantissa of 88 bits: bit for bit as
// avr/short_power_64.S computes it.
#pragma once

#include <fixedpoint/portable/divide.hpp>

namespace fixedpoint {
namespace portable {

// mantissa 2^(exponent - 88), the first bit of the last byte being set.
struct LongPower {
    uint8_t mantissa[11];
    int8_t exponent;
};

// The product of two is cut to 88 bits, and its columns of bytes below the tenth are left out,
// together less than 10 of the last place, 20 where it moves up by a bit: below 21 2^-87 of itself.
FIXEDPOINT_CONSTEXPR LongPower multiply_long(const LongPower& a, const LongPower& b) {
    uint8_t bytes[12] = {};  // byte 10 and on of the product
    uint32_t sum = 0;
    for (uint8_t k = 10; k < 22; ++k) {
        for (uint8_t i = static_cast<uint8_t>(k - 10); i < 11; ++i)
            sum += uint32_t(a.mantissa[i]) * b.mantissa[k - i];
        bytes[k - 10] = static_cast<uint8_t>(sum);
        sum >>= 8;
    }
    const uint8_t shift = bytes[11] < 128 ? 1 : 0;
    LongPower product = {{}, static_cast<int8_t>(a.exponent + b.exponent - shift)};
    for (uint8_t i = 0; i < 11; ++i) {
        product.mantissa[i] =
            static_cast<uint8_t>(bytes[i + 1] << shift | (shift != 0 ? bytes[i] >> 7 : 0));
    }
    return product;
}

// The highest bytes, as many as are asked for.
FIXEDPOINT_CONSTEXPR uint64_t front_of(const LongPower& a, uint8_t bytes) {
    uint64_t front = 0;
    for (uint8_t i = 11; i > 11 - bytes; --i) front = front << 8 | a.mantissa[i - 1];
    return front;
}

// 2^63 / m of m = mantissa / 2^88, at most 2^-10 too small before it is rounded downward.
FIXEDPOINT_CONSTEXPR uint64_t reciprocal_digits(const LongPower& a) {
    constexpr uint64_t longest = (uint64_t(1) << 40) - 1;
    const uint64_t quotient = static_cast<uint64_t>(
        divide<int64_t, 32>(int64_t(1) << 55, static_cast<int64_t>(front_of(a, 6))));
    const uint64_t y = quotient > longest ? longest : quotient;
    uint64_t e = 0;  // m y, modulo 2, in units of 2^-48, later of 2^-40
    for (uint8_t i = 1; i < 11; ++i) {
        for (uint8_t j = static_cast<uint8_t>(i < 5 ? 5 - i : 0); j < 5 && i + j < 12; ++j) {
            e += static_cast<uint64_t>(uint32_t(a.mantissa[i]) * static_cast<uint8_t>(y >> 8 * j))
                 << 8 * (i + j - 5);
        }
    }
    e >>= 8;
    int64_t y_e = 0x1000;  // in units of 2^-8
    for (uint8_t i = 0; i < 5; ++i) {
        for (uint8_t j = static_cast<uint8_t>(4 - i); j < 5; ++j) {
            y_e += static_cast<int64_t>(uint32_t(static_cast<uint8_t>(e >> 8 * i)) *
                                        static_cast<uint8_t>(y >> 8 * j))
                   << 8 * (i + j - 4);
        }
    }
    if ((e >> 40 & 1) != 0) y_e -= static_cast<int64_t>(y << 8);
    return (y << 24) + static_cast<uint64_t>((-2 * y_e) >> 24);
}

// From here on the powers and reciprocals of numbers of 64 bits are beyond every format, unless n
// has no further digit.
constexpr bool is_beyond_64_bits(const LongPower& power) {
    return power.exponent >= 64 || power.exponent <= -64;
}

// x^n or its reciprocal, x = a 2^(exponent - 64), in units of 2^(exponent - 64), rounded to
// nearest; 2^64 - 1 where it is more. Needs exponent from 0 to 64, 0 < a <= 2^63 and n > 0. Before
// rounded it is within 21 (n - 1) 2^-87 + 2^-73 of itself, as the squares double what a product
// loses; from 2^63 units on it is rounded downward.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR uint64_t short_power_64(uint64_t a, uint16_t n, int8_t exponent,
                                             bool reciprocal) {
    static_assert(sizeof(Raw) == 8 && F == 0, "The exponent stands for the fraction bits.");
    constexpr uint64_t beyond = ~uint64_t(0);
    LongPower x = {{}, exponent};
    for (; a >> 63 == 0; a <<= 1) --x.exponent;
    for (uint8_t i = 0; i < 8; ++i) x.mantissa[i + 3] = static_cast<uint8_t>(a >> 8 * i);
    LongPower power = x;
    uint16_t digit = 0x8000;
    while ((n & digit) == 0) digit = static_cast<uint16_t>(digit >> 1);
    while ((digit = static_cast<uint16_t>(digit >> 1)) != 0) {
        bool by_x = false;
        do {
            if (is_beyond_64_bits(power)) return (power.exponent > 0) == reciprocal ? 0 : beyond;
            power = multiply_long(power, by_x ? x : power);
            by_x = !by_x;
        } while (by_x && (n & digit) != 0);
    }
    const uint64_t digits = reciprocal ? reciprocal_digits(power) : front_of(power, 8);
    // In units: digits / 2^surplus, with 2^63 <= digits < 2^64.
    const int surplus = reciprocal ? exponent - 1 + power.exponent : exponent - power.exponent;
    return surplus < 0    ? beyond
           : surplus == 0 ? digits
           : surplus > 64 ? 0
                          : (digits >> (surplus - 1) >> 1) + (digits >> (surplus - 1) & 1);
}

}  // namespace portable
}  // namespace fixedpoint
