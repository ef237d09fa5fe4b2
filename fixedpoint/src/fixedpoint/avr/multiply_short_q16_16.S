// SPDX-License-Identifier: MIT
// int32_t fixedpoint_multiply_short_q16_16(int32_t a, int32_t b)
// floor(a b / 2^16 + 1/2), which fits in two bytes. Requires -2^15 <= a < 2^15, 0 <= b < 2^17 and
// |a b| < 2^31.
//
// In       a = r25:r22, b = r21:r18
// Out      r25:r22
// Changes  r0, r18..r27; r1 is 0 again at return

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define s1 r26
#define zero r27
#define s2 r24
#define s3 r25

    FUNCTION fixedpoint_multiply_short_q16_16
    clr zero
    mul rA0, rB0
    mov s1, r1
    mulsu rA1, rB1
    movw s2, r0
    mulsu rA1, rB0
    sbc s3, zero
    add s1, r0
    adc s2, r1
    adc s3, zero
    mul_add rA0, rB1, s1, s2, zero, s3
    sbrs rB2, 0
    rjmp 1f
    add s2, rA0
    adc s3, rA1
1:  lsl s1              // rounds
    adc s2, zero
    adc s3, zero
    movw rA0, s2
    lsl s3
    sbc rA2, rA2        // the sign
    mov rA3, rA2
    clr r1
    ret
    ENDFUNC fixedpoint_multiply_short_q16_16

#endif
