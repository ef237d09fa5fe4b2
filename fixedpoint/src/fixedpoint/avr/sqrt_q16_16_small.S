// SPDX-License-Identifier: MIT
// int32_t fixedpoint_sqrt_q16_16_small(int32_t a);
//
// The result of fixedpoint_sqrt_q16_16, without a table: the integer nearest to sqrt(a 2^16); 0 if
// a <= 0.
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
//
// M = a 4^s has the reciprocal root Y, low by up to 2^-11 of it (reciprocal_root_small.S). c, the
// upper half of M Y, is not above the root of M in units of 2^16. Nor is c + (M - c^2) Y / 2, which
// is less than 6 units of 2^-8 below it, since all truncated parts are positive. Shifted back by s
// bits and rounded, this root x of a 2^16 is thus correct or too small.
//
// x is too small while a 2^16 > x^2 + x. The lower half of the sum is not needed: the condition is
// a > floor((x^2 + x) / 2^16), and two bytes decide it, since both sides differ by less than 2^12.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define m0 r22
#define m1 r23
#define m2 r24
#define m3 r25
#define y0 r18
#define y1 r19
#define zero r31
#define a0 r26
#define a1 r27
// The root of M in units of 2^8, followed by another byte.
#define c1 r21
#define c0 r20
#define behind r25
// Bytes 1..3 of x^2 + x, x = m2:m0.
#define p1 r18
#define p2 r19
#define p3 r20

    SECTION fixedpoint_sqrt_q16_16_small
.Lnone:
    ldi m0, 0
    ldi m1, 0
    movw m2, m0
    ret
    ENTRY fixedpoint_sqrt_q16_16_small
    cp r1, m0
    cpc r1, m1
    cpc r1, m2
    cpc r1, m3
    brge .Lnone
    movw a0, m0
    XCALL fixedpoint_reciprocal_root_small
    // c = m3:m2 y / 2^15; the product of the lowest bytes is truncated.
    mul m3, y1
    movw c0, r0
    mul m3, y0
    mov behind, r0
    add c0, r1
    adc c1, zero
    mul_add m2, y1, behind, c0, zero, c1
    lsl behind
    rol c0
    rol c1
    // M - c^2 < 2^24
    mul c0, c0
    sub m0, r0
    sbc m1, r1
    sbc m2, zero
    mul c0, c1
    sub m1, r0
    sbc m2, r1
    sub m1, r0
    sbc m2, r1
    mul c1, c1
    sub m2, r0
    // c, followed by another byte, += m2:m1 y / 2^16
    mul m1, y1
    movw m0, r0
    mul_add m2, y0, m0, m1
    ldi behind, 0
    adc behind, zero
    mul_add m2, y1, m1, behind
    mov m0, m1
    mov m1, c0
    mov m2, c1
    add m1, behind
    adc m2, zero
    XCALL fixedpoint_shift_root_small
.Ltest:
    mul m0, m1
    movw p1, r0
    mul m1, m2
    mov p3, r0
    mul_add m0, m2, p2, p3
    lsl_bytes p1, 3
    mul_add m1, m1, p2, p3
    mul m0, m0
    add r0, m0
    adc p1, m1
    adc p2, m2
    adc p3, zero
    add p1, r1
    adc p2, zero
    adc p3, zero
    cp p2, a0
    cpc p3, a1
    brpl .Ldone
    increment_bytes m0, 3
    rjmp .Ltest
.Ldone:
    clr r1
    ret
    ENDFUNC fixedpoint_sqrt_q16_16_small
#endif
