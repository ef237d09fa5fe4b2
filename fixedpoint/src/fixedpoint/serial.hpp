// SPDX-License-Identifier: MIT
/// \file
/// Numbers to and from what has Arduino's members: print(Serial, x) needs write(text, length), and
/// read<Number>(Serial) needs peek() and read(), as Print and Stream have them.
#pragma once

#include <fixedpoint/text.hpp>

namespace fixedpoint {

/// Writes the shortest text that parse reads as x; returns the characters written.
template <class Out, int IntegerBits, int F, class A>
size_t print(Out& out, Fixed<IntegerBits, F, A> x) {
    char text[text_capacity<Fixed<IntegerBits, F, A>>()];
    return out.write(text, print(x, text, sizeof text));
}
/// Writes x with so many decimals, at most F, from which on they are exact.
template <class Out, int IntegerBits, int F, class A>
size_t print(Out& out, Fixed<IntegerBits, F, A> x, uint8_t decimals) {
    char text[text_capacity<Fixed<IntegerBits, F, A>>()];
    return out.write(
        text, print(x, decimals < F ? decimals : static_cast<uint8_t>(F), text, sizeof text));
}

/// Takes the characters of a number that have arrived, up to the first one that is none of it, and
/// parses them: a stream that has more to come says so by TextStatus::malformed or a number cut
/// short, so wait for the line's end. 40 characters are read at most, more than any number needs.
template <class Number, class In>
Parsed<Number> read(In& in) {
    char text[40];
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
