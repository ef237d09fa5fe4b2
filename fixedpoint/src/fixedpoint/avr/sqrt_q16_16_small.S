// SPDX-License-Identifier: MIT
// int32_t fixedpoint_sqrt_q16_16_small(int32_t a);
//
// What fixedpoint_sqrt_q16_16 returns, with no table: the integer nearest to sqrt(a 2^16); 0 where
// a < 0.
//
// a and the result in r25:r24:r23:r22. Changes r18-r27, r30, r31, r0; r1 is zero at entry and
// return.
//
// Technique. Restoring, two bits of a 2^16 for one of the root: the next bit is one where the
// remainder, or it with the next two bits of a, exceeds the root so far. Eight bits at a time, of
// which the first eight fit in one byte; leading zeros of a are skipped by 16.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define root0 r26
#define root1 r27
#define root2 r30
#define remainder0 r18
#define remainder1 r19
#define remainder2 r20
#define remainder3 r21
#define zero r1

    .macro next_bits
    lsl r24
    rol r25
    rol remainder0
    rol remainder1
    .endm

    FUNCTION fixedpoint_sqrt_q16_16_small
    clr r18
    clr r19
    movw r20, r18
    movw r26, r18
    clr r30
    ldi r31, 0x3f
    set
    sbiw r24, 0
    brpl 0f
    rjmp .Lnegative
0:  brne 1f
    clt
    movw r24, r22
    movw r22, r18
1:  ldi r21, 8
2:  cp r31, r25
    cpc root0, remainder0
    cpc zero, remainder1
    rol root0
    next_bits
    next_bits
    sbrs root0, 0
    rjmp 3f
    sub remainder0, root0
    sbc remainder1, zero
    dec root0
    sub remainder0, root0
    sbc remainder1, zero
    inc root0
3:  dec r21
    brne 2b

4:  movw r24, r22
    clr r22
    clr r23
    ldi r21, 8
    mov r0, r21
    clr r21
5:  cp r31, r25
    cpc root0, remainder0
    cpc root1, remainder1
    cpc root2, remainder2
    cpc zero, remainder3
    rol root0
    rol root1
    rol root2
    next_bits
    rol remainder2
    rol remainder3
    next_bits
    rol remainder2
    rol remainder3
    sbrs root0, 0
    rjmp 6f
    sub remainder0, root0
    sbc remainder1, root1
    sbc remainder2, root2
    sbc remainder3, zero
    dec root0
    sub remainder0, root0
    sbc remainder1, root1
    sbc remainder2, root2
    sbc remainder3, zero
    inc root0
6:  dec r0
    brne 5b
    brtc 7f
    clt
    rjmp 4b
    // Up where the remainder exceeds the root.
7:  cp root0, remainder0
    cpc root1, remainder1
    cpc root2, remainder2
    cpc zero, remainder3
    adc root0, zero
    adc root1, zero
    adc root2, zero
.Lnegative:
    movw r22, root0
    mov r24, root2
    clr r25
    ret
    ENDFUNC fixedpoint_sqrt_q16_16_small
#endif
