// SPDX-License-Identifier: MIT
// int32_t fixedpoint_multiply_q16_16_saturating(int32_t a, int32_t b)
// floor(a b / 2^16 + 1/2), saturated: the Q16.16 product rounded to nearest, half up.
//
// In       a = r25:r22, b = r21:r18
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
//
// The sum of byte products is carried to byte 6, and the result is in range if byte 6 is the sign
// extension of byte 5.
// - |a|, |b| <= 2^24, both highest bytes 0 or -1: 9 unsigned products of the lower three bytes,
//   minus the other operand times 2^24 if one is negative.
// - One is beyond that, the other is small, -2^23 <= x < 2^23, and has three bytes: 12 products;
//   those with a highest byte are signed, and `mulsu` sets the carry to the sign.
// - One is beyond, the other is not small: |a b| >= 2^47 overflows.
// Rounding adds 2^15, which carries into byte 2 exactly when byte 1 has its top bit set: `lsl` of
// it is the carry of the next chain. Bytes 2 and 3 start as a1 b1 <= 0xfe01, which absorbs the
// carries of the columns below.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define s1 r26
#define s2 r30
#define s3 r31

    // Sets Z if the number is small; otherwise `brlt` and `brge` test its sign. Destroys x3;
    // r1 = 0.
    .macro test_small x2, x3
    mov r0, \x2
    lsl r0
    adc \x3, r1
    .endm

    // s3:s1 = the products of rA1, rA0, rB2..rB0 up to rA0 rB2, rounded; s4 takes the carry.
    .macro multiply_low s4
    clr \s4
    mul rA0, rB0
    mov s1, r1
    mul rA1, rB1
    movw s2, r0
    mul_add rA0, rB1, s1, s2, \s4, s3
    mul_add rA1, rB0, s1, s2, \s4, s3
    mul rA0, rB2
    lsl s1              // rounds
    adc s2, r0
    adc s3, r1
    rol \s4
    .endm

    SECTION fixedpoint_multiply_q16_16_saturating

    // a is beyond 2^24: swaps the operands if b is small.
.La_beyond:
    test_small rB2, rB3
    brne .Lbeyond
    movw r26, rA0
    movw rA0, rB0
    movw rB0, r26
    movw r26, rA2
    movw rA2, rB2
    movw rB2, r26
    rjmp .La_small
    // b is beyond 2^24.
.Lb_beyond:
    test_small rA2, rA3
    brne .Lbeyond
    rjmp .La_small
.Lbeyond:
    // r26 is one more than the highest byte of the other.
    brge 1f
    neg r26             // the complement of the byte
    inc r26
1:  dec r26
    mov r27, r26
    rjmp .Lsaturate

    ENTRY fixedpoint_multiply_q16_16_saturating
    mov r26, rA3
    inc r26
    cpi r26, 2
    brsh .La_beyond
    mov r26, rB3
    inc r26
    cpi r26, 2
    brsh .Lb_beyond

    // Bytes 2..6: r30, r31, r27, r26, r0.
    multiply_low r27
    clr r26
    mul rA1, rB2
    add r31, r0
    adc r27, r1         // at most 1 + 0xfe + 1
    mul_add rA2, rB2, r27, r26
    mul_add rA2, rB1, r31, r27
    clr r1
    adc r26, r1
    mul_add rA2, rB0, r30, r31
    clr r1
    adc r27, r1
    adc r26, r1
    and rA0, rB3
    and rA1, rB3
    and rA2, rB3
    sub r31, rA0
    sbc r27, rA1
    sbc r26, rA2
    sbc r0, r0
    and rB0, rA3
    and rB1, rA3
    and rB2, rA3
    sub r31, rB0
    sbc r27, rB1
    sbc r26, rB2
    sbc r0, r1
    and rA3, rB3          // 2^48 if both are negative
    sub r0, rA3
    mov rA3, r26
    mov rA2, r27
    movw rA0, r30
    lsl r26
    adc r0, r1
    brne 1f
    ret
1:  mov r27, r0
    rjmp .Lsaturate

    // Bytes 2..6: r30, r31, r25, r26, r27. An operand byte that is no longer needed takes the sign
    // of its last product.
.La_small:
    multiply_low r25
    muls rB3, rA2
    movw r26, r0
    mulsu rB3, rA0
    sbc rA0, rA0
    add r31, r0
    adc r25, r1
    adc r26, rA0
    adc r27, rA0
    mul rA1, rB2
    clr rA0
    add r31, r0
    adc r25, r1
    adc r26, rA0
    adc r27, rA0
    mulsu rB3, rA1
    sbc rA1, rA1
    add r25, r0
    adc r26, r1
    adc r27, rA1
    mov rA1, rA2          // mulsu wants it below r24
    mulsu rA1, rB2
    sbc rB2, rB2
    add r25, r0
    adc r26, r1
    adc r27, rB2
    mulsu rA1, rB1
    sbc rB1, rB1
    add r31, r0
    adc r25, r1
    adc r26, rB1
    adc r27, rB1
    mulsu rA1, rB0
    sbc rB0, rB0
    add r30, r0
    adc r31, r1
    adc_each r25, rB0, 3
    clr r1
    mov r0, r26
    lsl r0
    adc r27, r1
    brne .Lsaturate
    movw r22, r30
    mov r24, r25
    mov r25, r26
    ret
    // Saturates to the limit with the sign of r27.
.Lsaturate:
    cpi r27, 0x80
    sbc r22, r22
    mov r23, r22
    movw r24, r22
    subi r25, 0x80
    ret
    ENDFUNC fixedpoint_multiply_q16_16_saturating

#endif
