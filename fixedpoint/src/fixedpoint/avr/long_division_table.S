// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/long_division.py
// Powers of two and reciprocals, by which divisors are normalised.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    TABLE fixedpoint_long_division_table
    // powers of two
    .byte   0, 128,  64,  64,  32,  32,  32,  32,  16,  16,  16,  16,  16,  16,  16,  16
    .byte   8,   8,   8,   8,   8,   8,   8,   8,   8,   8,   8,   8,   8,   8,   8,   8
    .byte   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4
    .byte   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4
    .byte   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2
    .byte   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2
    .byte   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2
    .byte   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2
    // reciprocals
    .byte 255, 252, 248, 244, 240, 236, 233, 229, 225, 222, 218, 215, 212, 208, 205, 202
    .byte 199, 195, 192, 189, 186, 183, 180, 178, 175, 172, 169, 166, 164, 161, 158, 156
    .byte 153, 151, 148, 146, 143, 141, 138, 136, 134, 131, 129, 127, 125, 122, 120, 118
    .byte 116, 114, 112, 110, 108, 106, 104, 102, 100,  98,  96,  94,  92,  90,  88,  87
    .byte  85,  83,  81,  80,  78,  76,  74,  73,  71,  70,  68,  66,  65,  63,  62,  60
    .byte  59,  57,  56,  54,  53,  51,  50,  48,  47,  46,  44,  43,  41,  40,  39,  37
    .byte  36,  35,  33,  32,  31,  30,  28,  27,  26,  25,  24,  22,  21,  20,  19,  18
    .byte  17,  15,  14,  13,  12,  11,  10,   9,   8,   7,   6,   5,   4,   3,   2,   1
    ENDTABLE fixedpoint_long_division_table

#endif
