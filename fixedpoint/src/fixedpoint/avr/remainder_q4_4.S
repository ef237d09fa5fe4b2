// SPDX-License-Identifier: MIT
// int8_t fixedpoint_remainder_q4_4(int8_t a, int8_t b)
// a - b trunc(a / b), exact, with the sign of a; a if b = 0: the same for every 8-bit format.
//
// In:       a r24, b r22
// Out:      r24
// Clobbers: r18, r22, T
// Stack:    0 bytes.
//
// Restoring division of the magnitudes without a quotient: the divisor is shifted left until it
// exceeds the dividend, and then right again bit by bit. The cost is proportional to the length of
// the quotient.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define a r24
#define b r22
#define lowest r18

    FUNCTION fixedpoint_remainder_q4_4
    bst a, 7
    brtc 1f
    neg a
1:  tst b
    breq .Ldone
    brpl 1f
    neg b
1:  mov lowest, b
.Lup:
    cp a, b
    brlo .Laligned
    lsl b
    brcc .Lup
    // A divisor of 2^8 exceeds every dividend.
    ror b
    rjmp .Lsubtract
.Ldown:
    lsr b
    cp a, b
    brlo .Laligned
.Lsubtract:
    sub a, b
.Laligned:
    cp b, lowest
    brne .Ldown
.Ldone:
    brtc 1f
    neg a
1:  ret
    ENDFUNC fixedpoint_remainder_q4_4

#endif
