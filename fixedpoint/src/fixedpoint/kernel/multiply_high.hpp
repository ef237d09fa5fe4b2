// SPDX-License-Identifier: MIT
// The upper half of the product of two 64-bit numbers, from the products of their words.
#pragma once

#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/kernel/words.hpp>

namespace fixedpoint {
namespace kernel {

// a b / 2^64, or up to 3 less.
FIXEDPOINT_CONSTEXPR uint64_t multiply_high(uint64_t a, uint64_t b) {
    const uint32_t a1 = upper_word(a), b1 = upper_word(b);
    return multiply_words(a1, b1) + upper_product<uint32_t, 0>(static_cast<uint32_t>(a), b1) +
           upper_product<uint32_t, 0>(a1, static_cast<uint32_t>(b));
}

}  // namespace kernel
}  // namespace fixedpoint
