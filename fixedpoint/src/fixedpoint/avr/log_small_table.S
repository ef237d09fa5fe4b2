// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/parabolas_small.py
// Parabolas of ln(1 + x) on 16 cells of [0, 1]: the bend in units of 2^-8, the slope
// in 2^-16, the value in 2^-24, with half an ulp of Q16.16.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    TABLE fixedpoint_log_small_table, 1
    // bend, slope, value
    .byte 120, 206, 255, 175,   0,   0, 107, 202, 240, 188, 133,  15,  96, 114, 227, 158
    .byte  39,  30,  86, 118, 215, 254, 254,  43,  78, 181, 204, 134,  32,  57,  71, 249
    .byte 194,   3, 158,  69,  65,  33, 186, 175, 134,  81,  59,   1, 178, 247, 231,  92
    .byte  55, 164, 170,   3, 205, 103,  50, 197, 163, 115,  64, 114,  47, 133, 157, 176
    .byte  74, 124,  43, 165, 151,  41, 244, 133,  40,  59, 146, 140,  67, 143,  38,  60
    .byte 141,  43,  63, 152,  35, 126, 136,   9, 237, 160,  33,  26, 132, 237,  81, 169
    ENDTABLE fixedpoint_log_small_table

#endif
