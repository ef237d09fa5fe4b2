// SPDX-License-Identifier: MIT
/// \file
/// Numbers to and from Arduino's streams. print(Serial, x) needs write(text, length), and
/// read<Number>(Serial) needs peek() and read(), as members of Print and Stream.
#pragma once

#include <fixedpoint/text.hpp>

namespace fixedpoint {

/// Writes the shortest text that parse reads as x; returns what `write` returns, the number of
/// characters written.
template <class Out, int IntegerBits, int F, class A>
size_t print(Out& out, Fixed<IntegerBits, F, A> x) {
    char text[text_capacity<Fixed<IntegerBits, F, A>>()];
    return out.write(text, print(x, text, sizeof text));
}
/// Writes x with that many decimals, rounded to nearest, half up; more than F count as F, which are
/// exact. Returns what `write` returns.
template <class Out, int IntegerBits, int F, class A>
size_t print(Out& out, Fixed<IntegerBits, F, A> x, uint8_t decimals) {
    char text[text_capacity<Fixed<IntegerBits, F, A>>()];
    return out.write(
        text, print(x, decimals < F ? decimals : static_cast<uint8_t>(F), text, sizeof text));
}

/// Reads the characters that have arrived, up to the first that cannot belong to a number, and
/// parses them. It does not wait: call it once the line is complete, since a number still arriving
/// is cut short or malformed. At most 40 characters are read, or as many as the longest exact text
/// of the format has, if that is more; text with more digits is split there.
template <class Number, class In>
Parsed<Number> read(In& in) {
    char text[text_capacity<Number>() > 40 ? text_capacity<Number>() : 40];
    size_t length = 0;
    for (int next = in.peek(); length < sizeof text && next >= 0; next = in.peek()) {
        const char c = static_cast<char>(next);
        if (!portable::is_digit(c) && c != '.' && c != '-' && c != '+' && c != 'e' && c != 'E') {
            break;
        }
        text[length++] = static_cast<char>(in.read());
    }
    return parse<Number>(text, length);
}

}  // namespace fixedpoint
