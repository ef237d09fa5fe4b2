// SPDX-License-Identifier: MIT
/// \file
/// Text that stays in flash: FIRMWARE_TEXT("..."), read one character at a time.
#pragma once

#include <stdint.h>

#ifdef __AVR__
#include <avr/pgmspace.h>
/// A string literal of at most 255 characters, kept in flash.
#define FIRMWARE_TEXT(text) firmware::flash_text(PSTR(text), sizeof text - 1)
#else
/// A string literal of at most 255 characters; on the chip it stays in flash.
#define FIRMWARE_TEXT(text) firmware::flash_text(text, sizeof text - 1)
#endif

namespace firmware {

/// A text that is kept in flash.
struct FlashText {
    /// The first character: in flash, not in RAM.
    const char* address;
    /// The number of characters.
    uint8_t length;

    /// The character i, which must be less than `length`.
    char operator[](uint8_t i) const {
#ifdef __AVR__
        return static_cast<char>(pgm_read_byte(address + i));
#else
        return address[i];
#endif
    }
};

/// A function, since avr-gcc 5.4 loses a string of PSTR within braces.
inline FlashText flash_text(const char* address, uint8_t length) { return {address, length}; }

}  // namespace firmware
