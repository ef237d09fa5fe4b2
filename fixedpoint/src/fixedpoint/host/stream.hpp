// SPDX-License-Identifier: MIT
/// \file
/// operator<< and operator>> of fixed-point numbers.
#pragma once

#include <algorithm>
#include <fixedpoint/host/text.hpp>
#include <istream>
#include <ostream>

namespace fixedpoint {

/// Writes the shortest text that reads back as the number or, with std::fixed, precision()
/// decimals, 255 at most. Honours width, fill, left, right, internal and showpos.
template <int IntegerBits, int F, class A>
std::ostream& operator<<(std::ostream& stream, Fixed<IntegerBits, F, A> number) {
    const bool is_fixed = (stream.flags() & std::ios::floatfield) == std::ios::fixed;
    const auto decimals =
        std::min<std::streamsize>(std::max<std::streamsize>(stream.precision(), 0), 255);
    std::string text =
        is_fixed ? to_string(number, static_cast<uint8_t>(decimals)) : to_string(number);
    if ((stream.flags() & std::ios::showpos) && text[0] != '-') text.insert(0, 1, '+');
    if ((stream.flags() & std::ios::adjustfield) == std::ios::internal) {
        text = fill_behind_sign(text, static_cast<std::size_t>(stream.width()), stream.fill());
    }
    return stream << text;
}

/// Reads the longest run of characters that can begin a decimal number. As for float, malformed
/// text gives 0, a number out of range gives the nearer limit, and both set failbit.
template <int IntegerBits, int F, class A>
std::istream& operator>>(std::istream& stream, Fixed<IntegerBits, F, A>& number) {
    const std::istream::sentry ready(stream);
    if (!ready) return stream;
    std::string text;
    bool has_digits = false, has_point = false, has_exponent = false;
    const auto continues = [&](char c) {
        switch (c) {
            case '+':
            case '-':
                return text.empty() || text.back() == 'e' || text.back() == 'E';
            case '.':
                return !has_exponent && !has_point && (has_point = true);
            case 'e':
            case 'E':
                return has_digits && !has_exponent && (has_exponent = true);
            default:
                return portable::is_digit(c) && (has_digits = true);
        }
    };
    using Traits = std::istream::traits_type;
    for (auto next = stream.peek(); next != Traits::eof() && continues(Traits::to_char_type(next));
         next = stream.peek()) {
        text += Traits::to_char_type(stream.get());
    }
    const auto result = parse<Fixed<IntegerBits, F, A>>(text.data(), text.size());
    number = result.number;
    if (result.status != TextStatus::ok) stream.setstate(std::ios::failbit);
    return stream;
}

}  // namespace fixedpoint
