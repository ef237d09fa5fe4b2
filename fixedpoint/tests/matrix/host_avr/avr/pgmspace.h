// SPDX-License-Identifier: MIT
// Flash for a host that plays an AVR: its program memory is its memory.
#pragma once

#define PROGMEM
#define pgm_read_byte(address) (*(address))
#define pgm_read_word(address) (*(address))
#define pgm_read_dword(address) (*(address))
