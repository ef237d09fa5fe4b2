// SPDX-License-Identifier: MIT
// Products of words: the exact one of two 32-bit words, its upper word, the upper word of that of
// two 64-bit words, and a 64-bit word times a byte's fraction. The exact one is never inlined: the
// chip's compiler would extend an operand to 64 bits for all its products, and multiply in full 64
// bits.
#pragma once

#include <fixedpoint/integer.hpp>

namespace fixedpoint {
namespace portable {

template <class = uint32_t, int = 0>
FIXEDPOINT_CONSTEXPR __attribute__((noinline)) uint64_t multiply_words(uint32_t a, uint32_t b) {
    return static_cast<uint64_t>(a) * b;
}

template <class, int>
FIXEDPOINT_CONSTEXPR uint32_t upper_product(uint32_t a, uint32_t b) {
    return static_cast<uint32_t>(multiply_words(a, b) >> 32);
}

// a j / 256, truncated.
template <class, int>
FIXEDPOINT_CONSTEXPR uint64_t byte_fraction(uint64_t a, uint8_t j) {
    return multiply_words(static_cast<uint32_t>(a >> 32), j) * (uint32_t(1) << 24) +
           (multiply_words(static_cast<uint32_t>(a), j) >> 8);
}

// a b / 2^64, or up to 2^18 less: the product of the upper words, plus the products of the upper
// halves of an upper and a lower word.
template <class, int>
FIXEDPOINT_CONSTEXPR uint64_t multiply_upper_halves(uint64_t a, uint64_t b) {
    const uint32_t a1 = static_cast<uint32_t>(a >> 32), b1 = static_cast<uint32_t>(b >> 32);
    const uint16_t a0 = static_cast<uint16_t>(a >> 16), b0 = static_cast<uint16_t>(b >> 16);
    return multiply_words(a1, b1) + (a1 >> 16) * b0 + (b1 >> 16) * a0;
}

}  // namespace portable
}  // namespace fixedpoint
