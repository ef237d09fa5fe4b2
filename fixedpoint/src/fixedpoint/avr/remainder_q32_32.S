// SPDX-License-Identifier: MIT
// int64_t fixedpoint_remainder_q32_32(int64_t a, int64_t b)
//
// a - b trunc(a / b), exact, with the sign of a; a where b = 0. Scale-free: the same for every format of
// 64 bits.
//
// In       a = r25:r18, b = r17:r10
// Out      r25:r18
// Changes  r0, r18..r26, T
// Stack    8 bytes
//
// As remainder_q16_16.S: restoring division of the magnitudes that produces no quotient. The divisor
// moves up under the dividend, by whole bytes first, then by bits until it is larger, and comes down
// again bit by bit. r26 counts the bits; its cost follows the length of the quotient.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    // The operation, byte by byte: the first of the lowest bytes, the other with its carry.
    .macro bytewise first, other
    \first r18, r10
    \other r19, r11
    \other r20, r12
    \other r21, r13
    \other r22, r14
    \other r23, r15
    \other r24, r16
    \other r25, r17
    .endm
    .macro negate_dividend
    com r25
    com r24
    com r23
    com r22
    com r21
    com r20
    com r19
    neg r18
    sbci r19, 0xff
    sbci r20, 0xff
    sbci r21, 0xff
    sbci r22, 0xff
    sbci r23, 0xff
    sbci r24, 0xff
    sbci r25, 0xff
    .endm

    FUNCTION fixedpoint_remainder_q32_32
    push r10
    push r11
    push r12
    push r13
    push r14
    push r15
    push r16
    push r17
    bst r25, 7
    brtc 1f
    negate_dividend
1:  clr r26
    tst r17
    brpl .Lbytes
    com r10
    com r11
    com r12
    com r13
    com r14
    com r15
    com r16
    com r17
    // The last complement left a carry.
    adc r10, r26
    adc r11, r26
    adc r12, r26
    adc r13, r26
    adc r14, r26
    adc r15, r26
    adc r16, r26
    adc r17, r26

    // Bytes: while the divisor has a free top byte and 256 times it is not above the dividend.
.Lbytes:
    tst r17
    brne .Lbits
    cp r19, r10
    cpc r20, r11
    cpc r21, r12
    cpc r22, r13
    cpc r23, r14
    cpc r24, r15
    cpc r25, r16
    brlo .Lbits
    mov r17, r16
    mov r16, r15
    mov r15, r14
    mov r14, r13
    mov r13, r12
    mov r12, r11
    mov r11, r10
    clr r10
    subi r26, -8
    sbrs r26, 6         // no divisor but 0 moves up by eight bytes
    rjmp .Lbytes
    rjmp .Ldone

    // Bits: until the divisor is above the dividend.
.Lbits:
    bytewise cp, cpc
    brlo .Laligned
    inc r26
    lsl r10
    rol r11
    rol r12
    rol r13
    rol r14
    rol r15
    rol r16
    rol r17
    brcc .Lbits
    // The divisor has left the register by a bit. It was 2^63, as is the dividend: nothing is above
    // that. It goes back, the other bytes being 0.
    ror r17
    rjmp .Lsubtract

.Laligned:
    tst r26
    breq .Ldone
.Ldown:
    lsr r17
    ror r16
    ror r15
    ror r14
    ror r13
    ror r12
    ror r11
    ror r10
    bytewise cp, cpc
    brlo .Lnext
.Lsubtract:
    bytewise sub, sbc
.Lnext:
    dec r26
    brne .Ldown

.Ldone:
    brtc 1f
    negate_dividend
1:  pop r17
    pop r16
    pop r15
    pop r14
    pop r13
    pop r12
    pop r11
    pop r10
    ret
    ENDFUNC fixedpoint_remainder_q32_32
#endif
