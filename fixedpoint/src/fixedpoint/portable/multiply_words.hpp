// SPDX-License-Identifier: MIT
// The exact product of two words of 32 bits, its upper word, and that of two words of 64 bits. The
// first is a call of its own: inlined, the chip's compiler extends an operand to 64 bits for all
// that it is multiplied by, and multiplies 64 bits in full.
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

// a b / 2^64, at most 2^18 less: of the words, and of an upper and a lower one what their upper
// halves have in it.
template <class, int>
FIXEDPOINT_CONSTEXPR uint64_t multiply_upper_halves(uint64_t a, uint64_t b) {
    const uint32_t a1 = static_cast<uint32_t>(a >> 32), b1 = static_cast<uint32_t>(b >> 32);
    const uint16_t a0 = static_cast<uint16_t>(a >> 16), b0 = static_cast<uint16_t>(b >> 16);
    return multiply_words(a1, b1) + (a1 >> 16) * b0 + (b1 >> 16) * a0;
}

}  // namespace portable
}  // namespace fixedpoint
