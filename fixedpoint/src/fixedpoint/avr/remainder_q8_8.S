// SPDX-License-Identifier: MIT
// int16_t fixedpoint_remainder_q8_8(int16_t a, int16_t b)
// a - b trunc(a / b), exact, with the sign of a; a if b = 0.
//
// void fixedpoint_divrem_q8_8(int16_t a, int16_t b, int16_t* quotient_and_remainder)
// trunc(a / b), saturated, and the remainder. If b = 0: the limit with the sign of a, or 0, and a.
//
// void fixedpoint_divmod_q8_8(int16_t a, int16_t b, int16_t* quotient_and_remainder)
// The same for floor(a / b), with a remainder that has the sign of b.
//
// The fraction bits cancel: the same for every 16-bit format.
//
// Restoring division of the magnitudes: the divisor is shifted left until it exceeds the dividend,
// and then right again bit by bit. The cost is proportional to the length of the quotient. If the
// quotient is requested, the carry of each comparison, the complement of a quotient bit, is shifted
// into ones.
//
// In:       a r25:r24, b r23:r22, r21:r20 the results' address
// Out:      r25:r24, the remainder
// Clobbers: r18, r22, r23, T; with a quotient r19, r26, r27, r30, r31 too
// Stack:    0 bytes.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define a0 r24
#define a1 r25
#define b0 r22
#define b1 r23
#define bits r18
#define sign r19
#define q0 r30
#define q1 r31

    .macro negate low, high
    com \high
    neg \low
    sbci \high, 0xff
    .endm

    .macro kernel name, quotient, floored
    FUNCTION fixedpoint_\name\()_q8_8
    .if \quotient
    mov sign, a1
    eor sign, b1
    ldi q0, 0xff
    ldi q1, 0xff
    .endif
    bst a1, 7
    brtc 1f
    negate a0, a1
1:  tst b1
    brpl 1f
    negate b0, b1
1:  clr bits
    cpse b1, bits
    rjmp .Lup_\name
    cp a1, b0
    brlo .Lup_\name
    // The divisor has one byte and is shifted left by a byte.
    mov b1, b0
    clr b0
    ldi bits, 8
    tst b1
    .if \quotient
    brne .Lup_\name
    // 2^15, which the sign turns into the limit, unless a is 0 like the divisor.
    clr bits
    cp a0, b0
    cpc a1, b0
    breq 1f
    lsr q1
1:  rjmp .Lsigned_\name
    .else
    breq .Ldone_\name
    .endif
.Lup_\name\():
    cp a0, b0
    cpc a1, b1
    brlo .Laligned_\name
    inc bits
    lsl b0
    rol b1
    brcc .Lup_\name
    // A divisor of 2^16 exceeds every dividend.
    ror b1
    rjmp .Lsubtract_\name
.Laligned_\name\():
    tst bits
    breq .Ldone_\name
.Ldown_\name\():
    lsr b1
    ror b0
    cp a0, b0
    cpc a1, b1
    brlo .Lnext_\name
.Lsubtract_\name\():
    sub a0, b0
    sbc a1, b1
.Lnext_\name\():
    .if \quotient
    rol q0
    rol q1
    .endif
    dec bits
    brne .Ldown_\name
.Ldone_\name\():
    .if \quotient
    .if \floored
    // If the signs differ: -(q + 1), which is the complement, and the remainder minus |b|.
    tst sign
    brpl .Lsigned_\name
    cp a0, bits
    cpc a1, bits
    breq .Lsigned_\name
    sub a0, b0
    sbc a1, b1
    rjmp .Lremainder_\name
    .endif
.Lsigned_\name\():
    tst sign
    brmi .Lnegative_\name
1:  com q0
    com q1
    brmi 1b             // 2^15 saturates to 2^15 - 1
    rjmp .Lremainder_\name
.Lnegative_\name\():
    adiw q0, 1
.Lremainder_\name\():
    .endif
    brtc 1f
    negate a0, a1
1:
    .if \quotient
    movw r26, r20
    st X+, q0
    st X+, q1
    st X+, a0
    st X, a1
    .endif
    ret
    ENDFUNC fixedpoint_\name\()_q8_8
    .endm

    kernel remainder, 0, 0
    kernel divrem, 1, 0
    kernel divmod, 1, 1
#endif
