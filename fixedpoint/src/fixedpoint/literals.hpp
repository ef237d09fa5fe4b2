// SPDX-License-Identifier: MIT
// Literals such as 0.38_q16_16, exact to the last bit: the compiler's characters are parsed, no
// double is involved, and the result is a constant. Always decimal, 017 being 17. The sign is not
// part of a literal: -0.38_q16_16 negates 0.38_q16_16, and the smallest number is written
// Q16_16::min().
//
// A format of one's own gets its literal in one line:
//   template <char... Text>
//   constexpr Fixed<8, 24> operator""_q8_24() { return literal<Fixed<8, 24>, Text...>(); }
#pragma once

#include <fixedpoint/fixed.hpp>
#include <fixedpoint/text.hpp>

namespace fixedpoint {
namespace literals {

template <class Number, char... Text>
FIXEDPOINT_CONSTEXPR Parsed<Number> parse_literal() {
    // Digit separators are the only characters that a literal has and decimal text has not.
    char text[] = {Text...};
    size_t length = 0;
    for (char character : text) {
        if (character != '\'') text[length++] = character;
    }
    return parse<Number>(text, length);
}

// The number that the characters say; what is not a decimal number in range does not compile.
template <class Number, char... Text>
FIXEDPOINT_CONSTEXPR Number literal() {
    constexpr Parsed<Number> result = parse_literal<Number, Text...>();
    static_assert(result.status != TextStatus::malformed,
                  "A fixed-point literal is a decimal number: 12, 0.38, 1e-3.");
    static_assert(result.status != TextStatus::out_of_range,
                  "This literal lies outside the range of its fixed-point format.");
    // By way of an integer, which the device's compiler makes an immediate operand; the struct
    // would take up RAM.
    constexpr typename Number::Raw raw = result.number.raw();
    return Number::from_raw(raw);
}

template <char... Text>
constexpr Q4_4 operator""_q4_4() {
    return literal<Q4_4, Text...>();
}
template <char... Text>
constexpr Q8_8 operator""_q8_8() {
    return literal<Q8_8, Text...>();
}
template <char... Text>
constexpr Q16_16 operator""_q16_16() {
    return literal<Q16_16, Text...>();
}
template <char... Text>
constexpr Q32_32 operator""_q32_32() {
    return literal<Q32_32, Text...>();
}

}  // namespace literals
}  // namespace fixedpoint
