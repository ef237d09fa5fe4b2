// SPDX-License-Identifier: MIT
// The square root and its reciprocal in Q16.16, without a table. Each is a section, and both share
// a third one: sections of one file lie next to each other, in reach of rcall and rjmp.
//
// int32_t fixedpoint_sqrt_q16_16_small(int32_t a)
// The result of fixedpoint_sqrt_q16_16: the integer nearest to sqrt(a 2^16); 0 if a <= 0.
//
// int32_t fixedpoint_reciprocal_sqrt_q16_16_small(int32_t a)
// 2^24 / sqrt(a) within 0.68 ulp; 2^31 - 1 if a = 0; 0 if a < 0.
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
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
// In       root = r24:r22, s = r30 < 16; carry clear, or the bit below the root if s = 0; r31 = 0
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
    brne .Lnormal
    mov_from_top m1, m0, 3
    mov m0, zero
    subi s, -4
    rjmp .Lbyte
.Ltwo_bits:
    lsl_bytes m0, 4
    lsl_bytes m0, 4
    inc s
.Lnormal:
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
    movw e0, m2
    rcall .Ltimes_y
    rcall .Ltimes_y
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
.Ltimes_y:
    mul e0, y1
    mov y0, r1
    mul e1, y1
    add r0, y0
    adc r1, zero
    movw e0, r0
    ret
    ENDFUNC fixedpoint_reciprocal_root_small

1:  lsr_bytes m0, 3
    ENTRY fixedpoint_shift_root_small
    dec s
    brpl 1b
    adc_each m0, zero, 3
    ldi m3, 0
    ret
    ENDFUNC fixedpoint_shift_root_small

#undef e0
#undef e1

// The square root. c, the upper half of M Y, is not above the root of M in units of 2^16. Nor is
// c + (M - c^2) Y / 2, which is less than 6 units of 2^-8 below it, since all truncated parts are
// positive. Shifted back by s bits and rounded, this root x of a 2^16 is thus correct or too small.
//
// x is too small while a 2^16 > x^2 + x. The lower half of the sum is not needed: the condition is
// a > floor((x^2 + x) / 2^16), and two bytes decide it, since both sides differ by less than 2^12.
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
    rcall fixedpoint_reciprocal_root_small
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
    fmul c0, c1
    sub m1, r0
    sbc m2, r1
    mul c1, c1
    sub m2, r0
    // c, followed by r0, += m2:m1 y / 2^16
    mul m1, y1
    movw m0, r0
    mul_add m2, y0, m0, m1
    sbc y0, y0          // minus the carry
    mul m2, y1
    sub r1, y0
    add r0, m1
    adc c0, r1
    adc c1, zero
    movw m0, c0
    ldi m2, 0
    sbrc s, 3
    rjmp .Lshift        // without rounding if s = 8
    mov m2, m1
    mov m1, m0
    mov m0, r0
.Lshift:
    andi s, 7
    rcall fixedpoint_shift_root_small
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

#undef behind

// The reciprocal. With e = 1 - M Y^2, from products truncated to units of 2^-30,
// Y + Y e / 2 + Y 3/8 e^2 has 24 bits; the square of the upper byte of e approximates the last
// term. One unit makes up for truncation, and 15 - s bits are rounded off.
//
// Error in ulp: up to 2 units of the 24 bits, weighted by 2^(s - 15), 0.18 at a = 37; rounding 0.5.
// 2^24, the result for 1, does not fit in 24 bits. Worst over all inputs: 0.67980, at 37.

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
    brmi .Lnegative
    brne .Lregular
    cpi r22, 2
    cpc r23, r1
    brsh .Lregular
    dec r22             // 1: 2^24; 0: 2^31 - 1
    rcall .Lfill
    lsr r25
    brcs .Lreturn
    inc r25
.Lreturn:
    ret
.Lnegative:
    ldi r22, 0
.Lfill:
    mov r23, r22
    movw r24, r22
    ret

.Lregular:
    rcall fixedpoint_reciprocal_root_small
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
    com s
    add r23, x1
    adc r24, zero       // no carry
    clr r1
    sbrs s, 3
    rjmp 1f
    lsl r22             // the carry is the last bit out, if none follows
    mov r22, r23
    mov r23, r24
    mov r24, zero
1:  andi s, 7           // 15 - s, or 7 - s
    rjmp fixedpoint_shift_root_small
    ENDFUNC fixedpoint_reciprocal_sqrt_q16_16_small
#endif
