// SPDX-License-Identifier: MIT
// The exact product of two words of 32 bits. It is a call of its own: inlined, the chip's compiler
// extends an operand to 64 bits for all that it is multiplied by, and multiplies 64 bits in full.
#pragma once

#include <fixedpoint/integer.hpp>

namespace fixedpoint {
namespace portable {

FIXEDPOINT_CONSTEXPR __attribute__((noinline)) uint64_t multiply_words(uint32_t a, uint32_t b) {
    return static_cast<uint64_t>(a) * b;
}

}  // namespace portable
}  // namespace fixedpoint
