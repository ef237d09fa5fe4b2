// SPDX-License-Identifier: MIT
// int32_t fixedpoint_reciprocal_sqrt_q16_16_small(int32_t a);
//
// 2^24 / sqrt(a) within 0.68 ulp, without a table; 2^31 - 1 if a = 0; 0 if a < 0.
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
//
// M = a 4^s has the reciprocal root Y, low by up to 2^-11 of it (reciprocal_root_small.S). With
// e = 1 - M Y^2, from products truncated to units of 2^-30, Y + Y e / 2 + Y 3/8 e^2 has 24 bits;
// the square of the upper byte of e approximates the last term. One unit makes up for truncation,
// and 15 - s bits are rounded off.
//
// Error in ulp: up to 2 units of the 24 bits, weighted by 2^(s - 15), 0.18 at a = 37; rounding 0.5.
// 2^24, the result for 1, does not fit in 24 bits. Worst over all inputs: 0.67980, at 37.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define m1 r23
#define m2 r24
#define m3 r25
#define s r30
#define zero r31
#define y0 r18
#define y1 r19
// Y^2.
#define s0 r20
#define s1 r21
#define s2 r26
#define s3 r27
// M Y^2 modulo 1, then 2 e, in units of 2^-31; the upper two replace m1 and s0.
#define e0 r22
#define e1 r23
#define e2 r20
// The bytes of the root below those of Y, and one for carries.
#define x0 r25
#define x1 r21
#define below r24

    FUNCTION fixedpoint_reciprocal_sqrt_q16_16_small
    sbiw r24, 0
    brmi .Lnone
    brne .Lregular
    cpi r22, 2
    cpc r23, r1
    brsh .Lregular
    dec r22             // 1: 2^24; 0: 2^31 - 1
    mov r23, r22
    mov r24, r22
    ldi r25, 1
    sbrc r22, 0
    ldi r25, 0x7f
    ret
.Lnone:
    ldi r22, 0
    ldi r23, 0
    movw r24, r22
    ret

.Lregular:
    XCALL fixedpoint_reciprocal_root_small
    mul y0, y0
    movw s0, r0
    mul y1, y1
    movw s2, r0
    mul_add y0, y1, s1, s2, zero, s3
    add s1, r0
    adc s2, r1
    adc s3, zero

    mul m3, s0
    mov e0, r1
    mul m1, s2
    mov e2, r1
    mul m1, s3
    add e0, r0
    adc r1, zero
    mov e1, r1
    add e0, e2
    adc e1, zero
    mul m3, s3
    mov e2, r0
    mul_add_upper m2, s1, e0, zero, e1, e2
    mul_add m3, s1, e0, e1, zero, e2
    mul_add m2, s2, e0, e1, zero, e2
    mul_add m2, s3, e1, e2
    mul_add m3, s2, e1, e2
    com e0
    com e1
    com e2
    lsl e0
    rol e1
    rol e2

    // x1:x0 = e Y / 2^16 + e2^2 / 2^8 + 1
    mul e2, e2
    movw below, r0
    mul_add_upper e0, y1, below, zero, x0
    mul_add e2, y0, below, x0
    mul_add e1, y1, below, x0
    clr x1
    adc x1, x1
    mul e2, y1
    sec
    adc x0, r0
    adc x1, r1
    mov r22, x0
    mov r23, y0
    mov r24, y1
    add r23, x1
    adc r24, zero
    subi s, 15
    neg s               // no carry from 0
    clr r1
    XJMP fixedpoint_shift_root_small
    ENDFUNC fixedpoint_reciprocal_sqrt_q16_16_small
#endif
