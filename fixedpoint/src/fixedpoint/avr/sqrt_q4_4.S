// SPDX-License-Identifier: MIT
// int8_t fixedpoint_sqrt_q4_4(int8_t a)
// The nearest number to the square root of a (there are no ties); 0 where a < 0.
//
// In:       a r24
// Out:      r24
// Clobbers: r30, r31
// Stack:    0 bytes.
//
// The table holds the root of every number: no arithmetic is faster than one load.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    FUNCTION fixedpoint_sqrt_q4_4
    mov r30, r24
    ldi r31, hi8(fixedpoint_sqrt_q4_4_table)
    lpm r24, Z
    ret
    ENDFUNC fixedpoint_sqrt_q4_4

#endif
