// SPDX-License-Identifier: MIT
/// \file
/// The control sequences of a terminal (ECMA-48, as every terminal program understands them) that
/// the firmware uses. Lines and columns count from 1, at most 99.
#pragma once

#include <stdint.h>

#include <firmware/flash_text.hpp>

namespace firmware {
namespace terminal {

/// Characters of the sequence that moves the cursor, at most; that erases the rest of a line; that
/// clears the screen.
/// @{
constexpr uint8_t longest_move = 8;
constexpr uint8_t erase_length = 3;
constexpr uint8_t clear_length = 4;
/// @}

/// Writes the text. The port must have room for it, as in all of these.
template <class Port>
void write(FlashText text) {
    for (uint8_t i = 0; i < text.length; ++i) {
        const char character = text[i];
        Port::try_write(&character, 1);
    }
}
/// Erases from the cursor to the end of its line.
template <class Port>
void erase_rest_of_line() {
    write<Port>(FIRMWARE_TEXT("\x1b[K"));
}
/// Erases all lines.
template <class Port>
void clear_screen() {
    write<Port>(FIRMWARE_TEXT("\x1b[2J"));
}

/// Writes a number of one or two digits and returns how many.
inline uint8_t put_number(char* text, uint8_t number) {
    uint8_t tens = 0;
    for (; number >= 10; number = static_cast<uint8_t>(number - 10)) ++tens;
    uint8_t length = 0;
    if (tens != 0) text[length++] = static_cast<char>('0' + tens);
    text[length++] = static_cast<char>('0' + number);
    return length;
}

/// Writes the sequence that moves the cursor and returns its length.
inline uint8_t move(char* text, uint8_t line, uint8_t column) {
    uint8_t length = 0;
    text[length++] = '\x1b';
    text[length++] = '[';
    length = static_cast<uint8_t>(length + put_number(text + length, line));
    text[length++] = ';';
    length = static_cast<uint8_t>(length + put_number(text + length, column));
    text[length++] = 'H';
    return length;
}

}  // namespace terminal
}  // namespace firmware
