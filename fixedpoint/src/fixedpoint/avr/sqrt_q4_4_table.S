// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/sqrt_q4_4.py
// Square roots of Q4.4 numbers.

#ifdef __AVR__

    .section .progmem.data.fixedpoint_sqrt_q4_4_table, "a", @progbits
    .balign 256
    .global fixedpoint_sqrt_q4_4_table
    .type fixedpoint_sqrt_q4_4_table, @object
fixedpoint_sqrt_q4_4_table:
    // roots
    .byte   0,   4,   6,   7,   8,   9,  10,  11,  11,  12,  13,  13,  14,  14,  15,  15
    .byte  16,  16,  17,  17,  18,  18,  19,  19,  20,  20,  20,  21,  21,  22,  22,  22
    .byte  23,  23,  23,  24,  24,  24,  25,  25,  25,  26,  26,  26,  27,  27,  27,  27
    .byte  28,  28,  28,  29,  29,  29,  29,  30,  30,  30,  30,  31,  31,  31,  31,  32
    .byte  32,  32,  32,  33,  33,  33,  33,  34,  34,  34,  34,  35,  35,  35,  35,  36
    .byte  36,  36,  36,  36,  37,  37,  37,  37,  38,  38,  38,  38,  38,  39,  39,  39
    .byte  39,  39,  40,  40,  40,  40,  40,  41,  41,  41,  41,  41,  42,  42,  42,  42
    .byte  42,  43,  43,  43,  43,  43,  43,  44,  44,  44,  44,  44,  45,  45,  45,  45
    .byte   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0
    .byte   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0
    .byte   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0
    .byte   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0
    .byte   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0
    .byte   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0
    .byte   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0
    .byte   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0
    .size fixedpoint_sqrt_q4_4_table, .-fixedpoint_sqrt_q4_4_table

#endif
