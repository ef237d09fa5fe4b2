// SPDX-License-Identifier: MIT
// int64_t fixedpoint_multiply_q32_32(int64_t a, int64_t b)
// floor(a b / 2^32 + 1/2) modulo 2^64.
//
// In:       a r25..r18, b r17..r10
// Out:      r25..r18
// Clobbers: r0, r26, r27, r30, r31
// Stack:    4 bytes.
//
// Column by column: byte k of the product is the sum of all a_i b_j with i + j = k and the carry of
// the previous column, in three registers that change roles from column to column. Bytes 4..7 of
// the result are kept on the stack, since all of a and b is still needed; bytes 8..11 replace a0
// and a1 and other registers that have become free. The register of byte 3 starts from 0x80, which
// rounds.
//
// b7 is signed, and its products are sign-extended by one byte. Bytes 9 and 10 start from 1, which
// is subtracted at the end, so that no sum is negative and needs further extension: a_i b7 is above
// -2^15, so the sum of all columns up to 7 is above -2^72, and that up to 8 above -2^80. Byte 11 is
// the highest that counts. If a is negative, its unsigned product is 2^64 b too large.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define a0 r18
#define a1 r19
#define a2 r20
#define a3 r21
#define a4 r22
#define a5 r23
#define a6 r24
#define a7 r25
#define b0 r10
#define b1 r11
#define b2 r12
#define b3 r13
#define b4 r14
#define b5 r15
#define b6 r16
#define b7 r17
#define zero r31

    // The products of byte i of a and byte k - i of b, for i = first..last.
    .macro column k, first, last, low, high, carry
    rising \first, (\last + 1), mul_add, .Lr18 + \n, .Lr10 + \k - \n, \low, \high, zero, \carry
    .endm

    .macro signed_product p, q, low, high, carry
    mulsu \p, \q
    sbc \carry, zero
    add \low, r0
    adc \high, r1
    adc \carry, zero
    .endm

    FUNCTION fixedpoint_multiply_q32_32
    clr zero
    // byte 0
    mul a0, b0
    mov r30, r1
    // byte 1
    mul a0, b1
    add r30, r0
    mov r26, r1
    adc r26, zero
    ldi r27, 0x80
    mul_add a1, b0, r30, r26, zero, r27
    // byte 2
    clr r30
    column 2, 0, 2, r26, r27, r30
    // byte 3
    clr r26
    column 3, 0, 3, r27, r30, r26
    // byte 4
    clr r27
    column 4, 0, 4, r30, r26, r27
    push r30
    // byte 5
    clr r30
    column 5, 0, 5, r26, r27, r30
    push r26
    // byte 6
    clr r26
    column 6, 0, 6, r27, r30, r26
    push r27
    // byte 7
    ldi r27, 1
    signed_product b7, a0, r30, r26, r27
    column 7, 1, 7, r30, r26, r27
    push r30
    // byte 8
    ldi r18, 1
    signed_product b7, a1, r26, r27, r18
    column 8, 2, 7, r26, r27, r18
    // byte 9
    clr r19
    signed_product b7, a2, r27, r18, r19
    column 9, 3, 7, r27, r18, r19
    // byte 10
    mulsu_add b7, a3, r18, r19
    mul_add a4, b6, r18, r19
    mul_add a5, b5, r18, r19
    mul_add a6, b4, r18, r19
    mul_add a7, b3, r18, r19
    // byte 11
    mul a4, b7
    add r19, r0
    mul a5, b6
    add r19, r0
    mul a6, b5
    add r19, r0
    mul a7, b4
    add r19, r0
    sbrs a7, 7
    rjmp 1f
    sub r26, b0
    sbc r27, b1
    sbc r18, b2
    sbc r19, b3
1:  subi r27, 1
    sbci r18, 1
    sbci r19, 0
    clr r1
    movw r22, r26
    movw r24, r18
    pop_all r21, r20, r19, r18
    ret
    ENDFUNC fixedpoint_multiply_q32_32

#endif
