// SPDX-License-Identifier: MIT
// int64_t fixedpoint_remainder_q32_32(int64_t a, int64_t b)
// a - b trunc(a / b), exact, with the sign of a; a if b = 0.
//
// void fixedpoint_divrem_q32_32(int64_t a, int64_t b, int64_t* quotient_and_remainder)
// trunc(a / b), saturated, and the remainder. If b = 0: the limit with the sign of a, or 0, and a.
//
// void fixedpoint_divmod_q32_32(int64_t a, int64_t b, int64_t* quotient_and_remainder)
// The same for floor(a / b), with a remainder that has the sign of b.
//
// The fraction bits cancel: the same for every 64-bit format.
//
// In       a = r25:r18, b = r17:r10, the results' address = r9:r8
// Out      r25:r18, the remainder
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    8 bytes, with a quotient 12; a remainder of |a| < |b| or |a| < 2^40 none
//
// As remainder_q16_16.S; a remainder first checks whether |a| < |b|, then whether five bytes are
// enough. r26 counts the bits by which the divisor has been shifted left, r27 is the sign of the
// quotient, and r7:r4, r31:r30:r1:r0 are the complement of its magnitude.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

// The remainder of |a| < 2^40: the divisor is a copy of five bytes, and r25 counts.
    .macro divisor first, next
    \first r26
    \next r27
    \next r30
    \next r31
    \next r0
    .endm
    .macro halve_divisor first
    \first r0
    ror r31
    ror r30
    ror r27
    ror r26
    .endm
    .macro of_dividend first, next
    \first r18, r26
    \next r19, r27
    \next r20, r30
    \next r21, r31
    \next r22, r0
    .endm
    .macro copy_divisor
    or_bytes r0, r23, 3
    brne .Lto_long
    movw r26, r10
    movw r30, r12
    mov r0, r14
    .endm
    // The carry of a sum, which is lost.
    .macro carry_of instruction, to, from
    mov r0, \to
    \instruction r0, \from
    .endm

    FUNCTION fixedpoint_remainder_q32_32
    bst r25, 7
    brtc 1f
    negate_bytes r18, 8
1:  tst r17
    brmi 2f
    cp_bytes r18, r10, 8
    brlo .Lsign
    copy_divisor
    rjmp 3f
.Lto_long:
    rjmp .Llong
.Lsign:
    brtc 1f
    negate_bytes r18, 8
1:  ret
2:  carry_of add, r18, r10
    rising 1, 8, carry_of, adc, .Lr18 + \n, .Lr10 + \n
    brcc .Lsign
    copy_divisor
    divisor com, com
    // The last complement left a carry.
    .irp byte, r26, r27, r30, r31, r0
    adc \byte, r25
    .endr

    // By bytes, while the top byte of the divisor is free and 256 times the divisor does not exceed
    // the dividend.
3:  tst r0
    brne 4f
    cp r19, r26
    cpc r20, r27
    cpc r21, r30
    cpc r22, r31
    brlo 4f
    mov r0, r31
    mov r31, r30
    mov r30, r27
    mov r27, r26
    clr r26
    subi r25, -8
    sbrs r25, 5
    rjmp 3b
    tst r0
    brne 4f
    clr r25             // no divisor but 0
    rjmp .Lsign
    // By bits, until the divisor exceeds the dividend or is one bit too long for the register.
4:  inc r25
    divisor lsl, rol
    brcs 5f
    of_dividend cp, cpc
    brsh 4b
    clc
5:  halve_divisor ror
6:  of_dividend sub, sbc
7:  dec r25
    breq 8f
    halve_divisor lsr
    of_dividend cp, cpc
    brsh 6b
    rjmp 7b
8:  rjmp .Lsign

    .macro kernel name, quotient, floored
    .if \quotient
    FUNCTION fixedpoint_\name\()_q32_32
    push_all r4, r5, r6, r7
    mov r27, r25
    eor r27, r17
    ldi r30, 0xff
    ldi r31, 0xff
    movw r0, r30
    movw r4, r30
    movw r6, r30
    .else
.Llong:
    .endif
    push_all r10, r11, r12, r13, r14, r15, r16, r17
    .if \quotient
    bst r25, 7
    brtc 1f
    negate_bytes r18, 8
1:
    .endif
    clr r26
    tst r17
    brpl .Lbytes_\name
    com_bytes r10, 8
    // The last complement left a carry.
    adc_each r10, r26, 8

    // By bytes, while the top byte of the divisor is free and 256 times the divisor does not exceed
    // the dividend.
.Lbytes_\name\():
    tst r17
    brne .Lbits_\name
    cp_bytes r19, r10, 7
    brlo .Lbits_\name
    mov_from_top r11, r10, 7
    clr r10
    subi r26, -8
    sbrs r26, 6         // only a divisor of 0 is shifted by eight bytes
    rjmp .Lbytes_\name
    .if \quotient
    // 2^63, which the sign turns into the limit, unless a is 0 like the divisor.
    clr r26
    cp_bytes r18, r10, 8
    breq 1f
    lsr r7
1:  rjmp .Lsigned_\name
    .else
    rjmp .Ldone_\name
    .endif

    // By bits, until the divisor exceeds the dividend.
.Lbits_\name\():
    cp_bytes r18, r10, 8
    brlo .Laligned_\name
    inc r26
    lsl_bytes r10, 8
    brcc .Lbits_\name
    // The divisor is one bit too long for the register. It was 2^63, and so is the dividend, since
    // nothing exceeds that. It is shifted back; its other bytes are 0.
    ror r17
    rjmp .Lsubtract_\name

.Laligned_\name\():
    .if \quotient
    tst r26
    brne .Ldown_\name
    rjmp .Ldone_\name
    .endif
.Ldown_\name\():
    lsr_bytes r10, 8
    cp_bytes r18, r10, 8
    brlo .Lnext_\name
.Lsubtract_\name\():
    sub_bytes r18, r10, 8
.Lnext_\name\():
    .if \quotient
    rol r0
    rol r1
    rol r30
    rol r31
    rol_bytes r4, 4
    .endif
    dec r26
    brne .Ldown_\name

.Ldone_\name\():
    .if \quotient
    .if \floored
    // If the signs differ: -(q + 1), which is the complement, and the remainder minus |b|.
    tst r27
    brpl .Lsigned_\name
    cp_each r18, r26, 8
    breq .Lsigned_\name
    sub_bytes r18, r10, 8
    rjmp .Lremainder_\name
    .endif
.Lsigned_\name\():
    tst r27
    brmi .Lnegative_\name
1:  com r0
    com r1
    com r30
    com r31
    com_bytes r4, 4
    brmi 1b             // 2^63 saturates to 2^63 - 1
    rjmp .Lremainder_\name
.Lnegative_\name\():
    sec
    adc r0, r26
    adc r1, r26
    adc r30, r26
    adc r31, r26
    adc_each r4, r26, 4
.Lremainder_\name\():
    .endif
    brtc 1f
    negate_bytes r18, 8
1:  pop_all r17, r16, r15, r14, r13, r12, r11, r10
    .if \quotient
    movw r26, r8
    st X+, r0
    st X+, r1
    st X+, r30
    st X+, r31
    st X+, r4
    st X+, r5
    st X+, r6
    st X+, r7
    st X+, r18
    st X+, r19
    st X+, r20
    st X+, r21
    st X+, r22
    st X+, r23
    st X+, r24
    st X, r25
    clr r1
    pop_all r7, r6, r5, r4
    .endif
    ret
    ENDFUNC fixedpoint_\name\()_q32_32
    .endm

    kernel remainder, 0, 0
    kernel divrem, 1, 0
    kernel divmod, 1, 1
#endif
