// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/arctangent_small.py
// atan(i/16) for i = 0..15 in units of 2^-24, plus half an ulp of Q16.16 and an offset that
// centres the errors of the remaining angle.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    TABLE fixedpoint_arctangent_small_table, 1
    // angles
    .byte 120,   0,   0,  35, 251,  15,  48, 214,  31, 107, 115,  47,  98, 183,  62,  82
    .byte 138,  77, 220, 216,  91,  51, 148, 105,  21, 178, 118, 109,  44, 131, 214,   0
    .byte 143, 250,  47, 154, 247, 188, 164, 199, 172, 174, 185,   5, 184,   1, 207, 192
    ENDTABLE fixedpoint_arctangent_small_table

#endif
