// SPDX-License-Identifier: MIT
// Text that stays in flash: FIRMWARE_TEXT("..."), read a character at a time.
#pragma once

#include <stdint.h>

#ifdef __AVR__
#include <avr/pgmspace.h>
#define FIRMWARE_TEXT(text) firmware::flash_text(PSTR(text), sizeof text - 1)
#else
#define FIRMWARE_TEXT(text) firmware::flash_text(text, sizeof text - 1)
#endif

namespace firmware {

struct FlashText {
    const char* address;
    uint8_t length;

    char operator[](uint8_t i) const {
#ifdef __AVR__
        return static_cast<char>(pgm_read_byte(address + i));
#else
        return address[i];
#endif
    }
};

// A function, as avr-gcc 5.4 loses a string of PSTR within braces.
inline FlashText flash_text(const char* address, uint8_t length) { return {address, length}; }

}  // namespace firmware
