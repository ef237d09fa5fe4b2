// SPDX-License-Identifier: MIT
// x^n for a 64-bit number, by squaring, with a mantissa of 88 bits: bit for bit as
// avr/short_power_64.S computes it.
#pragma once

#include <fixedpoint/portable/divide.hpp>

namespace fixedpoint {
namespace portable {

// mantissa 2^(exponent - 88); the top bit of the last byte is set.
struct LongPower {
    uint8_t mantissa[11];
    int8_t exponent;
};

// The product of two is truncated to 88 bits, and its byte columns below the tenth, together less
// than 10 units in the last place, or 20 if the product is shifted up by a bit, are omitted: the
// relative error is below 21 2^-87.
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

// The upper `bytes` bytes.
FIXEDPOINT_CONSTEXPR uint64_t front_of(const LongPower& a, uint8_t bytes) {
    uint64_t front = 0;
    for (uint8_t i = 11; i > 11 - bytes; --i) front = front << 8 | a.mantissa[i - 1];
    return front;
}

// 2^63 / m for m = mantissa / 2^88, at most 2^-10 too small before it is rounded downward.
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

// Whether the powers and reciprocals of 64-bit numbers are out of range in every format, unless n
// has no further digit.
constexpr bool is_beyond_64_bits(const LongPower& power) {
    return power.exponent >= 64 || power.exponent <= -64;
}

// x^n or its reciprocal for x = a 2^(exponent - 64), in units of 2^(exponent - 64), rounded to
// nearest and saturated to 2^64 - 1. Requires exponent in 0..64, 0 < a <= 2^63 and n > 0. Before
// rounding its relative error is at most 21 (n - 1) 2^-87 + 2^-73, since squaring doubles the loss
// of a product; from 2^63 units on it is rounded downward.
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
    // The result in units is digits / 2^surplus, with 2^63 <= digits < 2^64.
    const int surplus = reciprocal ? exponent - 1 + power.exponent : exponent - power.exponent;
    return surplus < 0    ? beyond
           : surplus == 0 ? digits
           : surplus > 64 ? 0
                          : (digits >> (surplus - 1) >> 1) + (digits >> (surplus - 1) & 1);
}

}  // namespace portable
}  // namespace fixedpoint
