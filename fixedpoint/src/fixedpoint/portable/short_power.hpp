// SPDX-License-Identifier: MIT
// x^n for a number of up to 32 bits, by squaring, with a mantissa of 48 bits: bit for bit as
// avr/short_power.S computes it.
#pragma once

#include <fixedpoint/portable/divide.hpp>

namespace fixedpoint {
namespace portable {

// A power is one word: a mantissa in [2^55, 2^56) with the exponent in place of its low byte.
// x = mantissa 2^(exponent - 56).
//
// The product of two is truncated to 48 bits, and its byte columns below the fifth, together 2^-5
// units in the last place, are omitted: the relative error is below 1.04 2^-47.
FIXEDPOINT_CONSTEXPR uint64_t multiply_short(uint64_t a, uint64_t b) {
    uint64_t sum = 0;  // byte 4 and on of the product
    for (uint8_t i = 0; i < 6; ++i) {
        for (uint8_t j = static_cast<uint8_t>(i < 4 ? 4 - i : 0); j < 6; ++j) {
            sum += static_cast<uint64_t>(uint32_t(static_cast<uint8_t>(a >> (8 * i + 8))) *
                                         static_cast<uint8_t>(b >> (8 * j + 8)))
                   << (8 * (i + j - 4));
        }
    }
    const uint8_t exponent = static_cast<uint8_t>(a + b);
    return sum >> 63 != 0 ? (sum >> 16 << 8) | exponent
                          : (sum >> 15 << 8) | static_cast<uint8_t>(exponent - 1);
}

// Whether a power of 32-bit numbers and its reciprocal are out of range in every format.
constexpr bool is_beyond_32_bits(uint64_t power) {
    return static_cast<int8_t>(power) >= 47 || static_cast<int8_t>(power) <= -47;
}

// x^n or its reciprocal for x = a 2^(exponent - 32), in units of 2^(exponent - 32), rounded to
// nearest and saturated to 2^32 - 1. Requires exponent in 0..32, a > 0 and 0 < n < 2^15. Before
// rounding its relative error is at most 1.04 (n - 1) 2^-47 + 2^-39, since squaring doubles the
// loss of a product; from 2^31 units on it is rounded downward.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR uint32_t short_power(uint32_t a, uint16_t n, int8_t exponent,
                                          bool reciprocal) {
    static_assert(sizeof(Raw) == 4 && F == 0, "The exponent stands for the fraction bits.");
    constexpr uint32_t beyond = ~uint32_t(0);
    int8_t exponent_of_x = exponent;
    while (a >> 31 == 0) {
        a <<= 1;
        --exponent_of_x;
    }
    const uint64_t x = static_cast<uint64_t>(a) << 24 | static_cast<uint8_t>(exponent_of_x);
    uint64_t power = x;
    uint16_t digit = 0x4000;
    while ((n & digit) == 0) digit = static_cast<uint16_t>(digit >> 1);
    while ((digit = static_cast<uint16_t>(digit >> 1)) != 0 && !is_beyond_32_bits(power)) {
        power = multiply_short(power, power);
        if ((n & digit) != 0 && !is_beyond_32_bits(power)) power = multiply_short(power, x);
    }
    uint64_t digits = power >> 24;
    int surplus = exponent - static_cast<int8_t>(power);
    if (reciprocal) {
        // 2^94 / mantissa, from 2^38 to 2^39.
        const int64_t quotient =
            divide<int64_t, 32>(int64_t(1) << 62, static_cast<int64_t>(power >> 8 << 8));
        digits = quotient >> 39 != 0 ? beyond : static_cast<uint64_t>(quotient >> 7);
        surplus = exponent - 1 + static_cast<int8_t>(power);
    }
    // The result in units is digits / 2^surplus, with 2^31 <= digits < 2^32.
    return surplus < 0     ? beyond
           : surplus == 0  ? static_cast<uint32_t>(digits)
           : surplus <= 32 ? static_cast<uint32_t>(((digits >> (surplus - 1)) + 1) >> 1)
                           : 0;
}

}  // namespace portable
}  // namespace fixedpoint
