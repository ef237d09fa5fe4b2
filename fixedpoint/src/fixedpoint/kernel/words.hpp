// SPDX-License-Identifier: MIT
// The words of a 64-bit number. The chip's compiler shifts 64 bits by a loop over bytes, even by
// four of them. In its calling convention, the upper word of a 64-bit argument is where a 32-bit
// result is returned, and two 32-bit arguments are where a 64-bit result is: these functions are a
// `ret`.
#pragma once

#include <fixedpoint/integer.hpp>

namespace fixedpoint {
namespace kernel {

#ifdef __AVR__
__attribute__((naked, noinline)) inline uint32_t load_upper_word(uint64_t) { __asm__("ret"); }
__attribute__((naked, noinline)) inline uint64_t load_words(uint32_t, uint32_t) { __asm__("ret"); }
FIXEDPOINT_IN_PLACE uint32_t upper_word(uint64_t a) {
    return __builtin_constant_p(a) ? static_cast<uint32_t>(a >> 32) : load_upper_word(a);
}
FIXEDPOINT_IN_PLACE uint64_t join_words(uint32_t upper, uint32_t lower) {
    return __builtin_constant_p(upper) && __builtin_constant_p(lower)
               ? static_cast<uint64_t>(upper) << 32 | lower
               : load_words(upper, lower);
}
// The empty statements hide that a number has been extended to 32 bits before, for which the
// compiler would choose a slower product.
inline uint32_t multiply_halves_now(uint16_t a, uint16_t b) {
    __asm__("" : "+r"(a));
    __asm__("" : "+r"(b));
    return static_cast<uint32_t>(a) * b;
}
FIXEDPOINT_IN_PLACE uint32_t multiply_halves(uint16_t a, uint16_t b) {
    return __builtin_constant_p(a) && __builtin_constant_p(b) ? static_cast<uint32_t>(a) * b
                                                              : multiply_halves_now(a, b);
}
#else
FIXEDPOINT_IN_PLACE uint32_t multiply_halves(uint16_t a, uint16_t b) {
    return static_cast<uint32_t>(a) * b;
}
FIXEDPOINT_IN_PLACE uint32_t upper_word(uint64_t a) { return static_cast<uint32_t>(a >> 32); }
FIXEDPOINT_IN_PLACE uint64_t join_words(uint32_t upper, uint32_t lower) {
    return static_cast<uint64_t>(upper) << 32 | lower;
}
#endif

constexpr uint16_t upper_half(uint32_t a) { return static_cast<uint16_t>(a >> 16); }
constexpr uint32_t join_halves(uint16_t upper, uint16_t lower) {
    return static_cast<uint32_t>(upper) << 16 | lower;
}
// The low three bytes of `upper` followed by the highest byte of `lower`.
constexpr uint32_t word_from_byte_3(uint32_t upper, uint32_t lower) {
    return upper << 8 | static_cast<uint8_t>(lower >> 24);
}

}  // namespace kernel
}  // namespace fixedpoint
