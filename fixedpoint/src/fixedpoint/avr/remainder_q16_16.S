// SPDX-License-Identifier: MIT
// int32_t fixedpoint_remainder_q16_16(int32_t a, int32_t b)
// a - b trunc(a / b), exact, with the sign of a; a if b = 0.
//
// void fixedpoint_divrem_q16_16(int32_t a, int32_t b, int32_t* quotient_and_remainder)
// trunc(a / b), saturated, and the remainder. If b = 0: the limit with the sign of a, or 0, and a.
//
// void fixedpoint_divmod_q16_16(int32_t a, int32_t b, int32_t* quotient_and_remainder)
// The same for floor(a / b), with a remainder that has the sign of b.
//
// The fraction bits cancel: the same for every 32-bit format.
//
// A remainder with |a| < |b| is a. Otherwise, if |a| < 2^24 and |b| >= 2^8, the bytes of its quotient
// are estimated: both magnitudes are multiplied by the power of two that moves the leading one of
// |b| to the top of its highest byte, and v = floor(2^16 / D) - 2^8, at most 255, D being that byte
// plus 1. With h:l the bytes of the dividend above and at its place, h + floor((h v + l) / 2^8) is
// not above the quotient. |b| is subtracted as often as that is too small.
//
// In all other cases, and if the quotient is requested, restoring division of the magnitudes: the
// divisor is shifted left, by whole bytes first and then by bits, until it exceeds the dividend, and
// then right again bit by bit. The cost is proportional to the length of the quotient. The carry of
// each comparison, the complement of a quotient bit, is shifted into ones.
//
// In:        r25:r22 a, r21:r18 b, r17:r16 the results' address
// Out:       r25:r22, the remainder
// Clobbers:  r0, r18..r21, r26, r27, r30, r31, T; r1 is 0 again at return
//   r25:r22  the dividend's magnitude, finally the remainder
//   r21:r18  the divisor's magnitude, shifted left
//   r26      bits by which the divisor has been shifted left, finally 0
//   T        the sign of a
// If the quotient is requested:
//   r31:r30:r1:r0  the complement of its magnitude
//   r27      its sign

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define power r26
#define reciprocal r27
#define digit r21

    // power and reciprocal for a divisor with the bytes high:low, of which high is not 0.
    .macro find_reciprocal high, low
    mov r30, \high
    ldi r31, hi8(fixedpoint_long_division_table)
    lpm power, Z
    sbrc \high, 7
    ldi power, 1
    mul \high, power
    mov r30, r0
    mul \low, power
    or r30, r1
    inc r30
    lpm reciprocal, Z
    .endm
    // digit = h + floor((h v + l) / 2^8), h:l = r31:r30.
    .macro estimate_digit
    mul r31, reciprocal
    add r0, r30
    adc r1, r31
    mov digit, r1
    .endm
    // The same for h:l from the product of r24:r23 and the power.
    .macro estimate_upper_digit
    mul r24, power
    movw r30, r0
    mul r23, power
    or r30, r1
    estimate_digit
    .endm

    .macro both_negative
.Lboth_negative:
    cp_bytes r18, r22, 4
    brsh 1f
    ret
1:  negate_bytes r22, 4
    negate_bytes r18, 4
    set
    rjmp .Lmagnitudes
.Ltwo_digits:
    estimate_upper_digit
    mul digit, r18
    sub r23, r0
    sbc r24, r1
    mul digit, r19
    sub r24, r0
1:  sub_bytes r23, r18, 2
    brcc 1b
    add_bytes r23, r18, 2
    rjmp .Lone_digit
    .endm

    // Returns the remainder, or goes on with the magnitudes and the sign of a in T.
    .macro short_remainder
    mov r26, r25
    eor r26, r21
    brpl 1f
    negate_bytes r18, 4  // b has the sign of a
1:  tst r25
    brmi .Lboth_negative
    cp_bytes r22, r18, 4
    brsh 2f
    ret
2:  clt
.Lmagnitudes:
    tst r25
    brne .Lto_restoring
    tst r20
    brne .Lthree_bytes
    tst r19
    breq .Lto_restoring
    find_reciprocal r19, r18
    cp_bytes r23, r18, 2
    brsh .Ltwo_digits
.Lone_digit:
    mul r24, power
    mov r31, r0
    mul r23, power
    or r31, r1
    mov r30, r0
    estimate_digit
.Lsubtract:
    mul digit, r18
    sub r22, r0
    sbc r23, r1
    sbci r24, 0
    mul digit, r19
    sub r23, r0
    sbc r24, r1
3:  sub_bytes r22, r18, 3
    brcc 3b
    add_bytes r22, r18, 3
    clr r1
    brts 4f
    ret
4:  negate_bytes r22, 3
    sbc r25, r25
    ret
.Lto_restoring:
    rjmp .Lrestoring
.Lthree_bytes:
    find_reciprocal r20, r19
    estimate_upper_digit
    mul digit, r20
    sub r24, r0
    rjmp .Lsubtract
.Lrestoring:
    .endm

    .macro kernel name, quotient, floored
    SECTION fixedpoint_\name\()_q16_16
    .if !\quotient
    both_negative
    .endif
    ENTRY fixedpoint_\name\()_q16_16
    .if \quotient
    mov r27, r25
    eor r27, r21
    ldi r30, 0xff
    ldi r31, 0xff
    movw r0, r30
    bst r25, 7
    brtc .Ldividend_positive_\name
    negate_bytes r22, 4
.Ldividend_positive_\name\():
    tst r21
    brpl .Ldivisor_positive_\name
    negate_bytes r18, 4
.Ldivisor_positive_\name\():
    .else
    short_remainder
    .endif
    clr r26

    // By bytes, while the top byte of the divisor is free and 256 times the divisor does not exceed
    // the dividend.
.Lbytes_\name\():
    tst r21
    brne .Lbits_\name
    cp_bytes r23, r18, 3
    brlo .Lbits_\name
    mov_from_top r19, r18, 3
    clr r18
    subi r26, -8
    sbrs r26, 5  // only a divisor of 0 is shifted by four bytes
    rjmp .Lbytes_\name
    .if \quotient
    // 2^31, which the sign turns into the limit, unless a is 0 like the divisor.
    clr r26
    cp_bytes r22, r18, 4
    breq 1f
    lsr r31
1:  rjmp .Lsigned_\name
    .else
    rjmp .Ldone_\name
    .endif

    // By bits, until the divisor exceeds the dividend.
.Lbits_\name\():
    cp_bytes r22, r18, 4
    brlo .Laligned_\name
    inc r26
    lsl_bytes r18, 4
    brcc .Lbits_\name
    // The divisor is one bit too long for the register. It was 2^31, and so is the dividend, since
    // nothing exceeds that. It is shifted back; its other bytes are 0.
    ror r21
    rjmp .Lsubtract_\name

.Laligned_\name\():
    tst r26
    breq .Ldone_\name
.Ldown_\name\():
    lsr_bytes r18, 4
    cp_bytes r22, r18, 4
    brlo .Lnext_\name
.Lsubtract_\name\():
    sub_bytes r22, r18, 4
.Lnext_\name\():
    .if \quotient
    rol r0
    rol r1
    rol r30
    rol r31
    .endif
    dec r26
    brne .Ldown_\name

.Ldone_\name\():
    .if \quotient
    .if \floored
    // If the signs differ: -(q + 1), which is the complement, and the remainder minus |b|.
    tst r27
    brpl .Lsigned_\name
    cp_each r22, r26, 4
    breq .Lsigned_\name
    sub_bytes r22, r18, 4
    rjmp .Lremainder_\name
    .endif
.Lsigned_\name\():
    tst r27
    brmi .Lnegative_\name
1:  com r0
    com r1
    com r30
    com r31
    brmi 1b             // 2^31 saturates to 2^31 - 1
    rjmp .Lremainder_\name
.Lnegative_\name\():
    sec
    adc r0, r26
    adc r1, r26
    adc r30, r26
    adc r31, r26
.Lremainder_\name\():
    .endif
    brtc .Lpositive_\name
    negate_bytes r22, 4
.Lpositive_\name\():
    .if \quotient
    movw r26, r16
    st X+, r0
    st X+, r1
    st X+, r30
    st X+, r31
    st X+, r22
    st X+, r23
    st X+, r24
    st X, r25
    clr r1
    .endif
    ret
    ENDFUNC fixedpoint_\name\()_q16_16
    .endm

    kernel remainder, 0, 0
    kernel divrem, 1, 0
    kernel divmod, 1, 1
#endif
