// SPDX-License-Identifier: MIT
// int16_t fixedpoint_remainder_q8_8(int16_t a, int16_t b)
// a - b trunc(a / b), exact, with the sign of a; a if b = 0: the same for every 16-bit format.
//
// In:       a r25:r24, b r23:r22
// Out:      r25:r24
// Clobbers: r18, r22, r23, T
// Stack:    0 bytes.
//
// Restoring division of the magnitudes without a quotient: the divisor is shifted left until it
// exceeds the dividend, and then right again bit by bit. The cost is proportional to the length of
// the quotient.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define a0 r24
#define a1 r25
#define b0 r22
#define b1 r23
#define bits r18

    .macro negate low, high
    com \high
    neg \low
    sbci \high, 0xff
    .endm

    FUNCTION fixedpoint_remainder_q8_8
    bst a1, 7
    brtc 1f
    negate a0, a1
1:  tst b1
    brpl 1f
    negate b0, b1
1:  clr bits
    cpse b1, bits
    rjmp .Lup
    cp a1, b0
    brlo .Lup
    // The divisor has one byte and is shifted left by a byte.
    mov b1, b0
    clr b0
    ldi bits, 8
    tst b1
    breq .Ldone
.Lup:
    cp a0, b0
    cpc a1, b1
    brlo .Laligned
    inc bits
    lsl b0
    rol b1
    brcc .Lup
    // A divisor of 2^16 exceeds every dividend.
    ror b1
    rjmp .Lsubtract
.Laligned:
    tst bits
    breq .Ldone
.Ldown:
    lsr b1
    ror b0
    cp a0, b0
    cpc a1, b1
    brlo .Lnext
.Lsubtract:
    sub a0, b0
    sbc a1, b1
.Lnext:
    dec bits
    brne .Ldown
.Ldone:
    brtc 1f
    negate a0, a1
1:  ret
    ENDFUNC fixedpoint_remainder_q8_8

#endif
