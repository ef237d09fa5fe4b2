// SPDX-License-Identifier: MIT
// uint32_t fixedpoint_multiply_u16_16(uint32_t a, uint32_t b)
// floor(a b / 2^16 + 1/2) modulo 2^32: the U16.16 product rounded to nearest, half up.
//
// In       a = r25:r22, b = r21:r18
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
//
// As for Q16.16 (multiply_q16_16.inc), without signs: 15 byte products are summed at the weights
// 2^8..2^47. a1 b1 <= 0xfe01 absorbs the carries of the columns below it; carries out of byte 5 are
// beyond the result. The top bit of byte 1 of the finished sum rounds.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define a0 r22
#define a1 r23
#define a2 r24
#define a3 r25
#define b0 r18
#define b1 r19
#define b2 r20
#define b3 r21
// Bytes 1..5 of the sum.
#define s1 r27
#define s2 r30
#define s3 r31
#define s4 r26
#define s5 r27
// A byte of a that is no longer needed.
#define zero a0

    FUNCTION fixedpoint_multiply_u16_16
    clr s4
    mul a0, b0
    mov s1, r1
    mul a1, b1
    movw s2, r0
    mul_add a0, b1, s1, s2, s4, s3
    mul_add a1, b0, s1, s2, s4, s3
    mul a0, b2
    lsl s1              // rounds
    adc s2, r0
    adc s3, r1
    rol s4
    clr s5
    mul_add a2, b0, s2, s3, s5, s4
    mul a0, b3
    add s3, r0
    adc s4, r1
    rol s5
    clr zero
    mul_add a3, b0, s3, s4, zero, s5
    mul_add a1, b2, s3, s4, zero, s5
    mul_add a2, b1, s3, s4, zero, s5
    mul_add a1, b3, s4, s5
    mul_add a2, b2, s4, s5
    mul_add a3, b1, s4, s5
    mul a2, b3
    add s5, r0
    mul a3, b2
    add s5, r0
    clr r1
    movw a0, s2
    movw a2, s4
    ret
    ENDFUNC fixedpoint_multiply_u16_16

#endif
