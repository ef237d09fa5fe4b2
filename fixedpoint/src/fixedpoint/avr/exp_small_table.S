// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/exp_small.py
// b for i = 0..11, and ln(1 + b/256) in units of 2^-32, less than 1/256 below i/16; and
// j/256 - ln(1 + j/256) for j = 0..17 in units of 2^-40, plus the correction of the kernel.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    TABLE fixedpoint_exp_small_table, 1
    // b, logarithm
    .byte   0,   0,   0,   0,   0,  16,  96,  24, 133,  15,  34,  50, 145, 236,  31,  52
    .byte   4,  18,  87,  47,  72, 219,  48, 114,  63,  93, 151,  62,  85,  79, 116, 238
    .byte 224, 171,  95, 139,  44, 130,   7, 111, 166,  33, 184, 244, 127, 193,  92,  26
    .byte 213, 143, 221, 155, 156,  81, 159, 252,  73,  21, 112, 175
    // shortfall
    .byte 124,   0,   0,   0, 102, 171, 127,   0, 203,  89, 253,   1, 140,  20, 119,   4
    .byte  92, 234, 234,   7, 170, 239,  86,  12, 135,  62, 185,  17, 144, 246,  15,  24
    .byte 222,  60,  89,  31, 234,  59, 147,  39, 125,  35, 188,  48, 152,  40, 210,  58
    .byte  99, 133, 211,  69,  24, 121, 190,  81, 239,  71, 145,  94,  14,  59,  74, 108
    .byte 115, 160, 231, 122, 227, 202, 103, 138
    ENDTABLE fixedpoint_exp_small_table

#endif
