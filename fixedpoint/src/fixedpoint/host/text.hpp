// SPDX-License-Identifier: MIT
/// \file
/// parse and to_string: decimal text as std::string.
#pragma once

#include <fixedpoint/text.hpp>
#include <string>

namespace fixedpoint {

/// The number, its status, and where reading stopped, as for parse in text.hpp.
template <class Number>
Parsed<Number> parse(const std::string& text) {
    return parse<Number>(text.data(), text.size());
}

/// The shortest text that reads back as the number.
template <int IntegerBits, int F, class A>
std::string to_string(Fixed<IntegerBits, F, A> number) {
    char buffer[text_capacity<Fixed<IntegerBits, F, A>>()];
    return {buffer, print(number, buffer, sizeof buffer)};
}

/// The number with that many decimals, rounded to nearest, half up.
template <int IntegerBits, int F, class A>
std::string to_string(Fixed<IntegerBits, F, A> number, uint8_t decimals) {
    std::string text(text_capacity<Fixed<IntegerBits, F, A>>(decimals), '\0');
    text.resize(print(number, decimals, &text[0], text.size()));
    return text;
}

/// `text`, which must not be empty, padded to `width` with `fill` between its sign and its digits.
inline std::string fill_behind_sign(std::string text, std::size_t width, char fill) {
    const std::size_t sign = text[0] == '-' || text[0] == '+' ? 1 : 0;
    if (text.size() < width) text.insert(sign, width - text.size(), fill);
    return text;
}

}  // namespace fixedpoint
