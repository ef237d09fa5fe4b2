// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/exp_q8_8.py
// e^a at every 64th a in units of 2^-7 ulp, and the growth at each distance minus its
// quadratic part, in units of 2^-17.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    TABLE fixedpoint_exp_q8_8_table, 1
    // powers
    .byte  63,   0,   0,  69,   0,   0,  92,   0,   0, 122,   0,   0, 172,   0,   0, 209
    .byte   0,   0,  27,   1,   0, 107,   1,   0, 211,   1,   0,  88,   2,   0,   1,   3
    .byte   0, 221,   3,   0, 245,   4,   0,  93,   6,   0,  45,   8,   0, 127,  10,   0
    .byte 123,  13,   0,  79,  17,   0,  58,  22,   0, 136,  28,   0, 165,  36,   0,  12
    .byte  47,   0, 100,  60,   0, 148,  77,   0, 156,  99,   0, 230, 127,   0,  58, 164
    .byte   0, 220, 210,   0, 195,  14,   1, 167,  91,   1, 105, 190,   1,  50,  61,   2
    .byte 253, 223,   2,  13, 177,   3, 120, 189,   4,  26,  22,   6, 171, 208,   7, 234
    .byte   8,  10, 140, 226,  12, 106, 139,  16,  95,  62,  21,   6,  71,  27,  97,   6
    .byte  35,  14, 249,  44,  10, 191,  57
    // growth
    .byte 104,  99,  95,  90,  86,  81,  77,  72,  67,  63,  57,  56,  51,  46,  43,  40
    .byte  36,  32,  28,  25,  22,  18,  18,  15,  12,   9,   9,   7,   6,   3,   3,   1
    .byte   2,   0,   2,   2,   2,   4,   4,   6,   8,   8,  12,  16,  19,  21,  26,  31
    .byte  36,  42,  46,  53,  60,  67,  75,  79,  89,  98, 110, 119, 129, 140, 151, 165
    ENDTABLE fixedpoint_exp_q8_8_table

#endif
