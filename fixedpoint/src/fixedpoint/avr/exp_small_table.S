// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/exp_small.py
// b for i = 0..11, and ln(1 + b/256) in units of 2^-32, less than 1/256 below i/16; and
// e^(j/256) - 1 in units of 2^-40, for j = 0..16, less its fifth byte, which is j.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    TABLE fixedpoint_exp_small_table, 1
    // b, logarithm
    .byte   0,   0,   0,   0,   0,  16,  96,  24, 133,  15,  33, 192,  48,  10,  31,  52
    .byte   4,  18,  87,  47,  72, 219,  48, 114,  63,  93, 151,  62,  85,  79, 116, 238
    .byte 224, 171,  95, 140, 119,  54, 173, 111, 165, 132,  60,  89, 127, 193,  92,  26
    .byte 213, 143, 221, 156, 156,  81, 159, 252,  73,  21, 112, 175
    // fine
    .byte   0,   0,   0,   0, 181,  42, 128,   0,   0,  86,   1,   2,  98, 131, 132,   4
    .byte  94, 181,  10,   8, 122, 239, 148,  12,  65,  54,  36,  18,  66, 143, 185,  24
    .byte  18,   1,  86,  32,  79, 147, 250,  40, 156,  78, 168,  50, 168,  60,  96,  61
    .byte  42, 104,  35,  73, 230, 220, 242,  85, 171, 167, 207,  99,  86, 214, 186, 114
    .byte 211, 119, 181, 130
    ENDTABLE fixedpoint_exp_small_table

#endif
