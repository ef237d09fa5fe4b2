// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/log_small.py
// Parabolas of ln(1 + x) on 16 cells of [0, 1]: the slope in units of 2^-16 and the value in
// 2^-24, plus half an ulp of Q16.16; its lowest byte is last.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    TABLE fixedpoint_log_small_table, 1
    // slope, value
    .byte 222, 255,   0,   0, 122, 202, 240, 133,  15, 189,  99, 227,  39,  30, 182, 104
    .byte 215, 255,  43,  18, 167, 204,  32,  57, 156, 234, 194, 158,  69,  28,  18, 186
    .byte 134,  81, 209, 242, 177, 232,  92,  17, 132, 170, 205, 103,  73, 181, 163,  64
    .byte 114, 144, 101, 157,  74, 124, 244, 149, 151, 244, 133,  72,  43, 146,  67, 143
    .byte 171,  27, 141,  63, 152, 117, 110, 136, 237, 160,  40,  10, 132,  82, 169,  15
    ENDTABLE fixedpoint_log_small_table

#endif
