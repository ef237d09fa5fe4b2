// SPDX-License-Identifier: MIT
/// \file
/// The control sequences that the firmware uses (ECMA-48, which every terminal program
/// understands). Lines and columns count from 1 and must be at most 99.
#pragma once

#include <stdint.h>

#include <firmware/flash_text.hpp>

namespace firmware {
namespace terminal {

/// The length of a sequence in characters: at most, for moving the cursor; for erasing the rest of
/// a line; for clearing the screen.
/// @{
constexpr uint8_t longest_move = 8;
constexpr uint8_t erase_length = 3;
constexpr uint8_t clear_length = 4;
/// @}

/// Writes the text. The port must have room for all of it, here and in the functions below.
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

/// Writes a number in 0..99 and returns its number of digits.
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
