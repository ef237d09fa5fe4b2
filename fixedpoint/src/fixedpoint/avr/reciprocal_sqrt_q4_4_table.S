// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/functions_q4_4.py
// 1 / sqrt of every Q4.4 number.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    TABLE fixedpoint_reciprocal_sqrt_q4_4_table
    // by the raw number
    .byte 127,  64,  45,  37,  32,  29,  26,  24,  23,  21,  20,  19,  18,  18,  17,  17
    .byte  16,  16,  15,  15,  14,  14,  14,  13,  13,  13,  13,  12,  12,  12,  12,  11
    .byte  11,  11,  11,  11,  11,  11,  10,  10,  10,  10,  10,  10,  10,  10,   9,   9
    .byte   9,   9,   9,   9,   9,   9,   9,   9,   9,   8,   8,   8,   8,   8,   8,   8
    .byte   8,   8,   8,   8,   8,   8,   8,   8,   8,   7,   7,   7,   7,   7,   7,   7
    .byte   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7
    .byte   7,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6
    .byte   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6
    .byte   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0
    .byte   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0
    .byte   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0
    .byte   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0
    .byte   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0
    .byte   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0
    .byte   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0
    .byte   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0
    ENDTABLE fixedpoint_reciprocal_sqrt_q4_4_table

#endif
