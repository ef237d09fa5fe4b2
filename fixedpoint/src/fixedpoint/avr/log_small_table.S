// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/log_small.py
// Parabolas of ln on 16 cells of [1, 2]: the bend in units of 2^-8, the slope in 2^-16, the
// value in 2^-24.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    TABLE fixedpoint_log_small_table, 1
    // bend, slope, value
    .byte 121, 221, 255,   5,   0,   0, 107, 202, 240,  60, 133,  15,  96, 114, 227,  30
    .byte  39,  30,  86, 118, 215, 126, 254,  43,  78, 181, 204,   6,  32,  57,  71, 249
    .byte 194, 131, 157,  69,  65,  33, 186,  47, 134,  81,  59,   1, 178, 119, 231,  92
    .byte  55, 164, 170, 131, 204, 103,  50, 197, 163, 243,  63, 114,  47, 133, 157,  48
    .byte  74, 124,  43, 165, 151, 169, 243, 133,  40,  60, 146,   9,  67, 143,  38,  60
    .byte 141, 171,  62, 152,  35, 126, 136, 137, 236, 160,  33,  26, 132, 109,  81, 169
    ENDTABLE fixedpoint_log_small_table

#endif
