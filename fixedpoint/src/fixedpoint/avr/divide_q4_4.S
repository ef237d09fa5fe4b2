// SPDX-License-Identifier: MIT
// int8_t fixedpoint_divide_q4_4(int8_t a, int8_t b)
// floor(2^4 a / b + 1/2), saturated. If b = 0: the largest number if a > 0, the smallest if a < 0,
// 0 if a = 0.
//
// In:       a r24, b r22
// Out:      r24
// Clobbers: r0, r18..r21, r23, r25, r30, r31
// Stack:    0 bytes.
//
// The quotient is a times a signed 16-bit reciprocal R from a table with an entry for every b. R is
// the integer nearest to 2^19 / b if |b| > 16, with the quotient at bit 15 of a R, and to 2^16 / b
// if 2 <= |b| <= 16, with the quotient at bit 12 (2^16 / 2 is one too large for R, and one less
// does not matter). a R is off by less than 64 units, since |a| <= 128 and R is off by at most half
// a unit; 64 units are added. So the error is in [0, 128) units. It must not bridge the step from
// one possible fraction of a quotient to the next, which is 2^15 / 2 |b| >= 128 units if |b| > 16,
// and 2^12 / 2 |b| >= 128 units otherwise. Hence ties, and nothing else, round half up.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    SECTION fixedpoint_divide_q4_4

    // r25:r24 = (a R + 64) >> 8, r1 = 0. Both halves of the product fit: |a R| < 2^22.
    .macro multiply_by_reciprocal
    mov r30, r22
    ldi r31, hi8(fixedpoint_divide_q4_4_table)
    lpm_pages r18, r19
    mov r20, r24
    ldi r21, 64
    muls r20, r19
    movw r24, r0
    mulsu r20, r18
    sbci r25, 0
    add r0, r21
    adc r24, r1
    clr r1
    adc r25, r1
    .endm

    ENTRY fixedpoint_divide_q4_4
    mov r23, r22
    subi r23, -16
    cpi r23, 33
    brlo .Lsmall_divisor

    multiply_by_reciprocal
    lsl r24
    rol r25
    lsl r24
    adc r25, r1
    mov r24, r25
    ret

.Lsmall_divisor:
    subi r23, 15
    cpi r23, 3
    brlo .Lunit_or_zero
    multiply_by_reciprocal
    subi r24, -8
    sbci r25, -1
    mov r23, r25
    subi r23, -8
    cpi r23, 16
    brsh .Lsaturate_to_sign_of_r25
    andi r24, 0xf0
    andi r25, 0x0f
    or r24, r25
    swap r24
    ret

.Lunit_or_zero:
    mov r25, r24
    dec r23
    breq .Lzero
    brmi .Lminus_one
    subi r24, -8
    cpi r24, 16
    brsh .Lsaturate_to_sign_of_r25
    subi r24, 8
    swap r24
    andi r24, 0xf0
    ret

    // 16 a fits for -7 <= a <= 8, and is negated.
.Lminus_one:
    com r25
    subi r24, -7
    cpi r24, 16
    brsh .Lsaturate_to_sign_of_r25
    subi r24, 7
    swap r24
    andi r24, 0xf0
    neg r24
    ret

.Lzero:
    tst r24
    breq .Lreturn
.Lsaturate_to_sign_of_r25:
    ldi r24, 0x7f
    sbrc r25, 7
    inc r24
.Lreturn:
    ret
    ENDFUNC fixedpoint_divide_q4_4

#endif
