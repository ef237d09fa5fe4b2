// SPDX-License-Identifier: MIT
// int32_t fixedpoint_sin_q16_16_small(int32_t angle)
// int32_t fixedpoint_cos_q16_16_small(int32_t angle)
// Sine and cosine of a Q16.16 angle in radians, for every input; within 0.74 ulp, in [-1, 1].
// Without a table: about a sixth of the flash of fixedpoint_sin_q16_16, but slower.
//
// In       angle = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
//
// With x the distance from the next peak in quarter turns and y = x^2, the magnitude of the sine is
// 1 - y - y (1 - y) b, where b = c0 - c1 y - c2 y (1 - y); fixedpoint/tables/sine_small.py fits c0
// and c1 for c2 = 2^-10. The last term is below 1/16: in it, 16 bits of y, 1 - y and 4 b are enough;
// the other terms have 24.
//
// Error in ulp: squares, bracket and its product 0.2, quarter turns 0.045; rounding 0.5.
//
// Truncated products lower the amount below 1 by a mean of BIAS units of 2^-24, which are added to
// the half ulp for rounding.
//
// The quarter turns are the product with 2/pi = (a3 - 7/2^8 + 836e4e/2^24) / 2^8, in units of 2^-24.
// Byte products below the unit are omitted; one with 4e is computed as one with 51. The upper byte of
// the angle becomes positive by adding 2^31; START subtracts the product of that.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "sin_polynomial.inc"

#define a0 r22
#define a1 r23
#define a2 r24
#define a3 r25
// The digits of 2/pi, M3 being negative; m1 is not needed for long.
#define M1 0x6e
#define M2 0x83
#define M3 7
#define M4 0xa3
// Minus 2^31 times 2/pi, and 3 units that centre the error.
#define START 0x833e48d6
#define m1 r18
#define m2 r19
#define m3 r20
#define m4 r21
#define zero r18
// The fraction, which becomes x, and above it the quadrant.
#define x0 r26
#define x1 r27
#define x2 r30
#define quadrant r31
#define y0 r21
#define y1 r22
#define y2 r23
// 1 - y, and its product with y.
#define z1 r24
#define z2 r25
#define s0 r30
#define s1 r31
#define s2 r20
// The bracket b, and a factor of it.
#define b1 r26
#define b2 r27
#define c r24
#define p0 r19
#define p1 r24
#define p2 r25

    FUNCTION fixedpoint_cos_q16_16_small
    ldi quadrant, hhi8(START + (1 << 24))
    rjmp .Lreduce
    ENDFUNC fixedpoint_cos_q16_16_small

    FUNCTION fixedpoint_sin_q16_16_small
    ldi quadrant, hhi8(START)
.Lreduce:
    ldi m1, M1
    ldi m2, M2
    ldi m3, M3
    ldi m4, M4
    subi a3, 0x80
    // No carry out of x1: the sum is between 0x41dd and 0xb758.
    mul a3, m1
    movw x0, r0
    subi_bytes x0, (-START), 2
    mul a2, m1
    add x0, r1
    clr zero            // replaces m1; keeps the carry
    adc x1, zero
    mul_add_upper a1, m2, x0, zero, x1
    mul a1, m3
    sub x0, r0
    sbc x1, r1
    // No carry out of x2: it is between START / 2^16 - 7 and START / 2^16 + 0xa5.
    ldi x2, hlo8(START)
    mul_add a0, m4, x0, x1, zero, x2
    mul_add a2, m2, x0, x1, zero, x2
    mul_add a1, m4, x1, x2
    mul a2, m3
    sub x1, r0
    sbc x2, r1
    // M0 a3 / 2^8 is near half the upper byte of M4 a3.
    mul a3, m2
    movw a0, r0
    mul a3, m4
    lsr r1
    add x0, r1
    adc x1, a0
    adc x2, a1
    adc quadrant, r0
    mul_add a2, m4, x2, quadrant
    mul a3, m3
    sub x2, r0
    sbc quadrant, r1

    bst quadrant, 1
    sbrc quadrant, 0
    rjmp .Lsquare
    com x0
    com x1
    com x2
.Lsquare:
    mul x2, x2
    movw y1, r0
    mul x1, x1
    mov y0, r1
    mul x2, x0
    mov p0, r1
    mul x2, x1
    add p0, r0
    adc r1, zero
    lsl p0
    rol r1
    adc y2, zero
    add y0, p0
    adc y1, r1
    adc y2, zero

    movw z1, y1
    com z1
    com z2
    mul y2, z1
    movw s0, r0
    mul y1, z2
    add s0, r0
    adc s1, r1          // no carry: both are at most 255^2 in sum
    clr s2
    mul_add y2, z2, s1, s2

    ldi b1, lo8(C0)
    ldi b2, hi8(C0)
    ldi c, hi8(C1)
    mul y1, c
    sub b1, r1          // does not borrow
    mul y2, c
    sub b1, r0
    sbc b2, r1
    ldi c, lo8(C1)
    mul y2, c
    add r1, s2          // no carry
    sub b1, r1
    sbc b2, zero

    mul s2, b2
    movw p1, r0
    mul s1, b1
    mov p0, r1
    mul_add_upper s0, b2, p0, zero, p1, p2
    mul_add s2, b1, p0, p1, zero, p2
    mul_add s1, b2, p0, p1, zero, p2
1:  lsr p2              // twice: `zero` is 0 again after the second time
    ror p1
    ror p0
    com zero
    brmi 1b
    add y0, p0
    adc y1, p1
    adc y2, p2

    // y is 1 minus the magnitude; rounded, y - 1 is the sine in the lower half turn.
    subi y0, 128 - BIAS
    sbci y1, 0xff
    sbci y2, 0xff
    sbc r24, r24        // 0 if y has become 1
    mov r25, r24
    brts .Lreturn
    negate_bytes y1, 3
    ldi r25, 0
.Lreturn:
    clr r1
    ret
    ENDFUNC fixedpoint_sin_q16_16_small

#endif
