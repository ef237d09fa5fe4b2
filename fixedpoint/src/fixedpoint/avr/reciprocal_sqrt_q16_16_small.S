// SPDX-License-Identifier: MIT
// int32_t fixedpoint_reciprocal_sqrt_q16_16_small(int32_t a);
//
// The integer nearest to 2^24 / sqrt(a), with no table; 2^31 - 1 where a = 0; 0 where a < 0.
//
// a and the result in r25:r24:r23:r22. Changes r18-r27, r30, r31, r0; r1 is zero at entry and
// return.
//
// Technique. 2^48 / a by restoring division, then its root like that of sqrt_q16_16_small.S. The
// quotient is rounded so that its root rounds like that of the ratio x: x is beyond (r + 1/2)^2
// where x + 3/4 reaches the integer r^2 + r + 1, so floor(x + 3/4) is taken.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define zero r1
#define count r28

    .macro double_quotient
    lsl r16
    rol r17
    rol r26
    rol r27
    rol r30
    rol r31
    .endm
    .macro double_remainder
    rol r18
    rol r19
    rol r20
    rol r21
    .endm

    FUNCTION fixedpoint_reciprocal_sqrt_q16_16_small
    // 0 below zero, 2^24 and 2^31 - 1 for 1 and 0
    clr r18
    clr r19
    movw r20, r18
    sbiw r24, 0
    brmi 2f
    brne 3f
    cpi r22, 2
    cpc r23, zero
    brsh 3f
    ldi r21, 1
    sbrc r22, 0
    rjmp 2f
    ldi r18, 0xff
    mov r19, r18
    mov r20, r18
    ldi r21, 0x7f
2:  movw r22, r18
    movw r24, r20
    ret

3:  push r16
    push r17
    push count
    movw r16, r18
    movw r26, r18
    movw r30, r18
    inc r18
    ldi count, 48
4:  double_quotient
    lsl r18
    rol r19
    rol r20
    rol r21
    cp r18, r22
    cpc r19, r23
    cpc r20, r24
    cpc r21, r25
    brcs 5f
    sub r18, r22
    sbc r19, r23
    sbc r20, r24
    sbc r21, r25
    inc r16
5:  dec count
    brne 4b
    // One more where 4 remainder >= a, which is 2 remainder >= (a + 1) / 2, rounded down.
    lsl r18
    rol r19
    rol r20
    rol r21
    subi r22, 0xff
    sbci r23, 0xff
    sbci r24, 0xff
    sbci r25, 0xff
    lsr r25
    ror r24
    ror r23
    ror r22
    cp r18, r22
    cpc r19, r23
    cpc r20, r24
    cpc r21, r25
    brcs 6f
    sec
    adc r16, zero
    adc r17, zero
    adc r26, zero
    adc r27, zero
    adc r30, zero
    adc r31, zero

6:  clr r18
    clr r19
    movw r20, r18
    movw r22, r18
    clr r24
    ldi r25, 0x3f
    ldi count, 24
7:  cp r25, r31
    cpc r22, r18
    cpc r23, r19
    cpc r24, r20
    cpc zero, r21
    rol r22
    rol r23
    rol r24
    double_quotient
    double_remainder
    double_quotient
    double_remainder
    sbrs r22, 0
    rjmp 8f
    sub r18, r22
    sbc r19, r23
    sbc r20, r24
    sbc r21, zero
    dec r22
    sub r18, r22
    sbc r19, r23
    sbc r20, r24
    sbc r21, zero
    inc r22
8:  dec count
    brne 7b
    clr r25
    cp r22, r18
    cpc r23, r19
    cpc r24, r20
    cpc r25, r21
    adc r22, zero
    adc r23, zero
    adc r24, zero
    pop count
    pop r17
    pop r16
    ret
    ENDFUNC fixedpoint_reciprocal_sqrt_q16_16_small
#endif
