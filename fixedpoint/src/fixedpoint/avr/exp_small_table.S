// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/exp_small.py
// e^(i/16) - 1 in units of 2^-32, for i = 0..11, and e^(j/256) - 1 in units of 2^-40, for
// j = 0..15, less its fifth byte, which is j.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    TABLE fixedpoint_exp_small_table, 1
    // coarse
    .byte   0,   0,   0,   0, 120, 181, 130,  16,  91,   4,  22,  34, 113, 129, 203,  52
    .byte 196, 227, 181,  72,  96,  23, 233,  93,  62,  81, 122, 116, 120,  36, 128, 140
    .byte 226, 152,  18, 166,  18,  67,  75, 193, 248,  93,  69, 222,  24, 230,  29, 253
    // fine
    .byte   0,   0,   0,   0, 181,  42, 128,   0,   0,  86,   1,   2,  98, 131, 132,   4
    .byte  94, 181,  10,   8, 122, 239, 148,  12,  65,  54,  36,  18,  66, 143, 185,  24
    .byte  18,   1,  86,  32,  79, 147, 250,  40, 156,  78, 168,  50, 168,  60,  96,  61
    .byte  42, 104,  35,  73, 230, 220, 242,  85, 171, 167, 207,  99,  86, 214, 186, 114
    ENDTABLE fixedpoint_exp_small_table

#endif
