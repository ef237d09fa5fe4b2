// SPDX-License-Identifier: MIT
// Raws to and from hexadecimal text: 0x and all digits of the two's complement.
#pragma once

#include <fixedpoint/portable/decimal_parse.hpp>

namespace fixedpoint {
namespace portable {

template <class Word>
FIXEDPOINT_CONSTEXPR size_t print_hexadecimal(Word raw, char* buffer, size_t capacity) {
    constexpr uint8_t digits = 2 * sizeof(Word);
    if (capacity < digits + size_t(2)) return 0;
    buffer[0] = '0';
    buffer[1] = 'x';
    for (uint8_t i = digits; i > 0; --i, raw = static_cast<Word>(raw >> 4)) {
        const uint8_t digit = static_cast<uint8_t>(raw) & 15;
        buffer[i + 1] = static_cast<char>(digit < 10 ? '0' + digit : 'a' + (digit - 10));
    }
    return digits + size_t(2);
}

// The value of a hexadecimal digit; 16 if c is not one.
constexpr uint8_t hexadecimal_digit(char c) {
    return static_cast<uint8_t>(is_digit(c)            ? c - '0'
                                : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                                       : 16);
}

// Out of range if there are more digits than a Word has, not counting leading zeros.
template <class Word>
FIXEDPOINT_CONSTEXPR Parsed<Word> parse_hexadecimal(const char* text, size_t length) {
    if (length == 0) return {0, TextStatus::empty, 0};
    if (text[0] != '0') return {0, TextStatus::malformed, 0};
    if (length < 2 || (text[1] != 'x' && text[1] != 'X')) return {0, TextStatus::malformed, 1};
    Word raw = 0;
    bool fits = true;
    size_t at = 2;
    for (; at < length && hexadecimal_digit(text[at]) < 16; ++at) {
        fits = fits && static_cast<Word>(raw >> (RawLimits<Word>::width - 4)) == 0;
        raw = static_cast<Word>(static_cast<Word>(raw << 4) | hexadecimal_digit(text[at]));
    }
    if (at == 2 || at < length) return {0, TextStatus::malformed, at};
    return {fits ? raw : Word(0), fits ? TextStatus::ok : TextStatus::out_of_range, at};
}

}  // namespace portable
}  // namespace fixedpoint
