// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/leading_one.py
// For a byte that is not zero, indexed by its upper 7 bits.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    TABLE fixedpoint_leading_one_table
    // The base-2 logarithm, rounded downward
    .byte   0,   1,   2,   2,   3,   3,   3,   3,   4,   4,   4,   4,   4,   4,   4,   4
    .byte   5,   5,   5,   5,   5,   5,   5,   5,   5,   5,   5,   5,   5,   5,   5,   5
    .byte   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6
    .byte   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6,   6
    .byte   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7
    .byte   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7
    .byte   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7
    .byte   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7,   7
    // The factor that moves the leading one to the top
    .byte 128,  64,  32,  32,  16,  16,  16,  16,   8,   8,   8,   8,   8,   8,   8,   8
    .byte   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4
    .byte   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2
    .byte   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2,   2
    .byte   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1
    .byte   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1
    .byte   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1
    .byte   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1
    ENDTABLE fixedpoint_leading_one_table

#endif
