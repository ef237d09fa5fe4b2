// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/parabolas_small.py
// Parabolas of 256/257 atan(x) on 16 cells of [0, 1]: the bend in units of 2^-8, the slope
// in 2^-16, the value in 2^-24, with half an ulp of Q16.16.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    TABLE fixedpoint_arctangent_small_table, 1
    // bend, slope, value
    .byte   8,  49, 255,  84,   0,   0,  24,  55, 254,  20, 235,  15,  38,  63, 251,  93
    .byte 182,  31,  51, 127, 246,  14,  68,  47,  62,  37, 240, 207, 120,  62,  70, 102
    .byte 232,  20,  61,  77,  76, 155, 223, 107, 125,  91,  80,  12, 214,  35,  43, 105
    .byte  82, 254, 203, 239,  59, 118,  83, 186, 193, 191, 169, 130,  82,  95, 183, 104
    .byte 114, 142,  80,  39, 173, 101, 150, 153,  77,  45, 163, 232,  24, 164,  73, 137
    .byte 153, 226, 254, 173,  70, 104, 144,  97,  78, 183,  66, 177, 135, 237,  14, 192
    ENDTABLE fixedpoint_arctangent_small_table

#endif
