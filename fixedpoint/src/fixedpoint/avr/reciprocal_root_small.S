// SPDX-License-Identifier: MIT
// The code shared by sqrt_q16_16_small.S and reciprocal_sqrt_q16_16_small.S, without a table.
//
// fixedpoint_reciprocal_root_small
// In       a = r25:r22 > 0
// Out      M = r25:r22 = a 4^s, from 2^30 to 2^32; s = r30; Y = r19:r18, below 2^16, at most
//          2^31 / sqrt(M) and at most 0.0004 of it below it; r31 = 0
// Changes  r0, r1, r20, r21
//
// y, the first 8 bits of Y, is a polynomial in the upper byte of M, off by up to 1 in 41. With
// m = M / 2^32 and E = 1 - m y^2, Y = y + y E / 2 + y 3/8 E^2; the square of the upper byte of E
// approximates the last term. E is lowered by a constant, so that Y is never above the root and all
// later remainders are positive.
//
// fixedpoint_shift_root_small
// In       root = r24:r22, s = r30 < 16; carry clear, r31 = 0
// Out      r25:r22 = root / 2^s, rounded
// Changes  r30

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define m0 r22
#define m1 r23
#define m2 r24
#define m3 r25
#define s r30
#define zero r31
#define y0 r18
#define y1 r19
#define e0 r20
#define e1 r21

// tables/reciprocal_root_small.py proves the bounds of Y for them.
#define C0 128
#define C1 59
#define C3 198
#define BIAS 12

    SECTION fixedpoint_reciprocal_root_small
    ENTRY fixedpoint_reciprocal_root_small
    ldi s, 0
    ldi zero, 0
.Lbyte:
    tst m3
    brne .Ltest
    mov_from_top m1, m0, 3
    mov m0, zero
    subi s, -4
    rjmp .Lbyte
.Ltwo_bits:
    lsl_bytes m0, 4
    lsl_bytes m0, 4
    inc s
.Ltest:
    cpi m3, 64
    brlo .Ltwo_bits
    // y = C0 + z (C1 + C3 z^2), z = 1 - m
    mov e0, m3
    com e0
    mul e0, e0
    ldi y0, C3
    mul r1, y0
    ldi y0, C1
    add y0, r1
    mul e0, y0
    ldi y1, C0
    add y1, r1
    // m y, then m y^2
    mul m2, y1
    mov e0, r1
    mul m3, y1
    add r0, e0
    adc r1, zero
    movw e0, r0
    mul e0, y1
    mov y0, r1
    mul e1, y1
    add r0, y0
    adc r1, zero
    movw e0, r0
    // E in units of 2^-15
    lsl e0
    rol e1
    com e0
    com e1
    subi e0, BIAS - 1
    sbci e1, 0x80
    mul e0, y1
    mov y0, r1
    mulsu_add e1, y1, y0, y1
    muls_add e1, e1, y0, y1
    ret
    ENDFUNC fixedpoint_reciprocal_root_small

    ENTRY fixedpoint_shift_root_small
    sbrs s, 3
    rjmp 2f
    andi s, 7
    lsl m0              // the carry is the last bit out, if none follows
    mov m0, m1
    mov m1, m2
    mov m2, zero
    rjmp 2f
1:  lsr_bytes m0, 3
2:  dec s
    brpl 1b
    adc_each m0, zero, 3
    ldi m3, 0
    ret
    ENDFUNC fixedpoint_shift_root_small
#endif
