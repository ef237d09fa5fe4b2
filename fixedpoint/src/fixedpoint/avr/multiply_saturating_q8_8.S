// SPDX-License-Identifier: MIT
// int16_t fixedpoint_multiply_saturating_q8_8(int16_t a, int16_t b)
// floor(a b / 2^8 + 1/2), saturated: the Q8.8 product rounded to nearest, half up.
//
// In       a = r25:r24, b = r23:r22
// Out      r25:r24
// Changes  r0, r18..r21, r26; r1 is 0 again at return
//
// The exact product, of which bit 7 rounds; it is in range if byte 3 is the sign extension of byte
// 2.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define a0 r20
#define a1 r21
#define s0 r18
#define s1 r19
#define s2 r24
#define s3 r25
#define zero r26

    FUNCTION fixedpoint_multiply_saturating_q8_8
    movw a0, r24
    clr zero
    muls a1, r23
    movw s2, r0
    mul a0, r22
    movw s0, r0
    mulsu a1, r22
    sbc s3, zero
    add s1, r0
    adc s2, r1
    adc s3, zero
    mulsu r23, a0
    sbc s3, zero
    add s1, r0
    adc s2, r1
    adc s3, zero
    clr r1
    lsl s0              // rounds
    adc s1, r1
    adc s2, r1
    adc s3, r1
    mov r0, s2
    lsl r0
    adc s3, r1
    brne 1f
    mov r25, s2
    mov r24, s1
    ret
    // Saturates to the limit with the sign of s3.
1:  lsl s3
    sbc r24, r24
    com r24
    mov r25, r24
    subi r25, 0x80
    ret
    ENDFUNC fixedpoint_multiply_saturating_q8_8

#endif
