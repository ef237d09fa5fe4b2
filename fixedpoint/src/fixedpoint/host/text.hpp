// SPDX-License-Identifier: MIT
// to_string: decimal text as std::string, which streams and fmt pad and align.
#pragma once

#include <fixedpoint/text.hpp>
#include <string>

namespace fixedpoint {

// The shortest text that reads back.
template <int I, int F, class A>
std::string to_string(Fixed<I, F, A> number) {
    char buffer[text_capacity<Fixed<I, F, A>>()];
    return {buffer, print(number, buffer, sizeof buffer)};
}

// The text with so many decimals.
template <int I, int F, class A>
std::string to_string(Fixed<I, F, A> number, uint8_t decimals) {
    std::string text(text_capacity<Fixed<I, F, A>>(decimals), '\0');
    text.resize(print(number, decimals, &text[0], text.size()));
    return text;
}

}  // namespace fixedpoint
