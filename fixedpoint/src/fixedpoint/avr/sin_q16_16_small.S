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
// Truncating products adds a mean of BIAS units of 2^-24 to the magnitude: the half ulp for
// rounding is less by BIAS if the sine is positive, and more if it is negative.
//
// The quarter turns are the product with the 40 bits a2f9836e4e / 2^40 of 2/pi, in units of 2^-24.
// Byte products below the unit are omitted; one with f9 is computed as one with 100, and one with 4e
// as one with 51.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "sin_polynomial.inc"

#define a0 r22
#define a1 r23
#define a2 r24
#define a3 r25
// 2/pi; m1 is not needed for long.
#define M1 0x6e
#define M2 0x83
#define M3 0xf9
#define M4 0xa2
// 2^31 times 2/pi, and 2 units that centre the error.
#define HALF 0x7cc1b729
#define m r24
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
#define half r20

    SECTION fixedpoint_sin_q16_16_small

    ENTRY fixedpoint_cos_q16_16_small
    ldi quadrant, 1
    rjmp .Lreduce
    ENDFUNC fixedpoint_cos_q16_16_small

    ENTRY fixedpoint_sin_q16_16_small
    ldi quadrant, 0
.Lreduce:
    ldi m1, M1
    ldi m2, M2
    ldi m3, M3
    ldi m4, M4
    ldi x1, M4 + 1      // including M3 a0 / 2^8
    mul a0, x1
    movw x0, r0
    mul a2, m1
    add x0, r1
    clr zero            // replaces m1; keeps the carry
    adc x1, zero
    mul_add_upper a1, m2, x0, zero, x1  // x1 is at most 0xa2 + 2
    mul_add a1, m3, x0, x1
    clr x2
    adc x2, zero
    mul_add a2, m2, x0, x1, zero, x2
    mul a1, m4
    add x1, r0
    adc x2, r1          // at most 2 + 0xa1 + 1
    mul_add a2, m3, x1, x2, zero, quadrant
    mul_add a2, m4, x2, quadrant
    tst a3
    breq .Lreduced
    // 256 rad or more, or negative: 2^31 times 2/pi is added and subtracted. M0 a3 / 2^8 is near half
    // the upper byte of M4 a3.
    subi a3, 0x80
    mul a3, m2
    movw a0, r0
    mul a3, m4
    lsr r1
    add x0, r1
    adc x1, a0
    adc x2, a1
    adc quadrant, r0
    ldi m, M1
    mul a3, m
    movw a0, r0
    mul a3, m3
    add x0, a0
    adc x1, a1
    adc x2, r0
    adc quadrant, r1
    subi_bytes x0, HALF, 2
    sbci x2, hlo8(HALF)
    sbci quadrant, hhi8(HALF)
.Lreduced:
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

    // y is 1 minus the magnitude; y - 1 is the sine in the lower half turn.
    ldi half, 128 + BIAS
    ldi r24, 0xff
    brts .Lround
    ldi half, 129 - BIAS
    com_bytes y0, 3
    com r24
.Lround:
    add y0, half
    adc y1, zero
    adc y2, zero
    adc r24, zero
    mov r25, r24        // 0 or 1, or -1
    asr r25
    clr r1
    ret
    ENDFUNC fixedpoint_sin_q16_16_small

#endif
