// SPDX-License-Identifier: MIT
// The two 128-bit operations that 64-bit formats need: a full product and a quotient. The host has
// a native 128-bit integer; the compiler of the 8-bit device does not, so the device works in
// 32-bit digits.
#pragma once

#include <fixedpoint/portable/multiply_words.hpp>

namespace fixedpoint {
namespace portable {

struct Wide128 {
    uint64_t high;
    uint64_t low;
};

struct Division128 {
    uint64_t quotient;
    uint64_t remainder;
};

// a b, exact, from four 32 x 32 bit products.
FIXEDPOINT_CONSTEXPR Wide128 multiply_full_by_digits(uint64_t a, uint64_t b) {
    const uint32_t a0 = static_cast<uint32_t>(a), a1 = static_cast<uint32_t>(a >> 32);
    const uint32_t b0 = static_cast<uint32_t>(b), b1 = static_cast<uint32_t>(b >> 32);
    const uint64_t p00 = multiply_words(a0, b0);
    const uint64_t p01 = multiply_words(a0, b1);
    const uint64_t p10 = multiply_words(a1, b0);
    const uint64_t p11 = multiply_words(a1, b1);
    // At most 3 (2^32 - 1), so nothing is lost.
    const uint64_t middle = (p00 >> 32) + static_cast<uint32_t>(p01) + static_cast<uint32_t>(p10);
    return {p11 + (p01 >> 32) + (p10 >> 32) + (middle >> 32),
            (middle << 32) | static_cast<uint32_t>(p00)};
}

// (high 2^64 + low) / divisor by shift and subtract. Requires high < divisor, so that the quotient
// fits in 64 bits.
FIXEDPOINT_CONSTEXPR Division128 divide_full_by_bits(uint64_t high, uint64_t low,
                                                     uint64_t divisor) {
    uint64_t remainder = high;
    for (int i = 0; i < 64; ++i) {
        const bool carry = (remainder >> 63) != 0;
        remainder = (remainder << 1) | (low >> 63);
        low <<= 1;
        if (carry || remainder >= divisor) {
            remainder -= divisor;
            low |= 1;
        }
    }
    return {low, remainder};
}

#if defined(__SIZEOF_INT128__)
__extension__ typedef unsigned __int128 Native128;
FIXEDPOINT_CONSTEXPR Wide128 multiply_full(uint64_t a, uint64_t b) {
    const Native128 product = static_cast<Native128>(a) * b;
    return {static_cast<uint64_t>(product >> 64), static_cast<uint64_t>(product)};
}
FIXEDPOINT_CONSTEXPR Division128 divide_full(uint64_t high, uint64_t low, uint64_t divisor) {
    const Native128 dividend = (static_cast<Native128>(high) << 64) | low;
    return {static_cast<uint64_t>(dividend / divisor), static_cast<uint64_t>(dividend % divisor)};
}
#else
FIXEDPOINT_CONSTEXPR Wide128 multiply_full(uint64_t a, uint64_t b) {
    return multiply_full_by_digits(a, b);
}
FIXEDPOINT_CONSTEXPR Division128 divide_full(uint64_t high, uint64_t low, uint64_t divisor) {
    return divide_full_by_bits(high, low, divisor);
}
#endif

}  // namespace portable
}  // namespace fixedpoint
