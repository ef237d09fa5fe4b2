// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/log_small.py
// Parabolas of ln(1 + x) on 16 cells of [0, 1]: the slope in units of 2^-16, the bend in
// 2^-8, the value in 2^-24, plus half an ulp of Q16.16.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    TABLE fixedpoint_log_small_table, 1
    // slope, bend, value
    .byte 206, 255, 120, 175,   0,   0, 202, 240, 107, 188, 133,  15, 114, 227,  96, 158
    .byte  39,  30, 118, 215,  86, 254, 254,  43, 181, 204,  78, 134,  32,  57, 249, 194
    .byte  71,   3, 158,  69,  33, 186,  65, 175, 134,  81,   1, 178,  59, 247, 231,  92
    .byte 164, 170,  55,   3, 205, 103, 197, 163,  50, 115,  64, 114, 133, 157,  47, 176
    .byte  74, 124, 165, 151,  43,  41, 244, 133,  59, 146,  40, 140,  67, 143,  60, 141
    .byte  38,  43,  63, 152, 126, 136,  35,   9, 237, 160,  26, 132,  33, 237,  81, 169
    ENDTABLE fixedpoint_log_small_table

#endif
