// SPDX-License-Identifier: MIT
// int32_t fixedpoint_remainder_q16_16(int32_t a, int32_t b)
//
// a - b trunc(a / b), exact, with the sign of a; a where b = 0. Scale-free: the same for every
// 32-bit format.
//
// Restoring division of the magnitudes that produces no quotient: the divisor is moved up under the
// dividend, by whole bytes first, then by bits until it is larger, and comes down again bit by bit.
// Its cost follows the length of the quotient.
//
// In:        r25:r22 a, r21:r18 b
// Out:       r25:r22
// Clobbers:  r18..r21, r26, T
//   r25:r22  the dividend's magnitude, at last the remainder
//   r21:r18  the divisor's magnitude, moved up
//   r26      bits that the divisor has been moved up by
//   T        the sign of a

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    .macro negate r0, r1, r2, r3
    com \r3
    com \r2
    com \r1
    neg \r0
    sbci \r1, 0xff
    sbci \r2, 0xff
    sbci \r3, 0xff
    .endm

    FUNCTION fixedpoint_remainder_q16_16
    bst r25, 7
    brtc .Ldividend_positive
    negate r22, r23, r24, r25
.Ldividend_positive:
    tst r21
    brpl .Ldivisor_positive
    negate r18, r19, r20, r21
.Ldivisor_positive:
    clr r26

    // Bytes: while the divisor has a free top byte and 256 times it is not above the dividend.
.Lbytes:
    tst r21
    brne .Lbits
    cp r23, r18
    cpc r24, r19
    cpc r25, r20
    brlo .Lbits
    mov r21, r20
    mov r20, r19
    mov r19, r18
    clr r18
    subi r26, -8
    sbrs r26, 5  // no divisor but 0 moves up by four bytes
    rjmp .Lbytes
    rjmp .Ldone

    // Bits: until the divisor is above the dividend.
.Lbits:
    cp r22, r18
    cpc r23, r19
    cpc r24, r20
    cpc r25, r21
    brlo .Laligned
    inc r26
    lsl r18
    rol r19
    rol r20
    rol r21
    brcc .Lbits
    // The divisor has left the register by a bit. It was 2^31, as is the dividend: nothing is above
    // that. It goes back, the other bytes being 0.
    ror r21
    rjmp .Lsubtract

.Laligned:
    tst r26
    breq .Ldone
.Ldown:
    lsr r21
    ror r20
    ror r19
    ror r18
    cp r22, r18
    cpc r23, r19
    cpc r24, r20
    cpc r25, r21
    brlo .Lnext
.Lsubtract:
    sub r22, r18
    sbc r23, r19
    sbc r24, r20
    sbc r25, r21
.Lnext:
    dec r26
    brne .Ldown

.Ldone:
    brtc .Lpositive
    negate r22, r23, r24, r25
.Lpositive:
    ret
    ENDFUNC fixedpoint_remainder_q16_16
#endif
