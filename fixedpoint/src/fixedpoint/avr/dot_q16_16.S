// SPDX-License-Identifier: MIT
// int32_t fixedpoint_dot2_q16_16(const int32_t* a, const int32_t* b)
// int32_t fixedpoint_dot3_q16_16(const int32_t* a, const int32_t* b)
// floor(sum a_i b_i / 2^16 + 1/2) modulo 2^32 of 2 or 3 components: one rounding.
//
// In       a = r25:r24, b = r23:r22, in RAM
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    6 bytes
//
// Bytes 0..5 of the exact sum are formed, since 2^48 is beyond the result: component by component,
// and byte by byte of b, so that only one byte of b is in a register. The even products of a byte
// of b are adjacent, and so are the odd ones: each set is added to the sum in one carry chain.
// `mulsu` sets the carry to the sign of its product, which is subtracted from the bytes above the
// product. Rounding adds 2^15, which carries into byte 2 exactly when byte 1 has its top bit set:
// in the last component `lsl` of it is the carry of the first chain that begins at byte 2.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define a0 r18
#define a1 r19
#define a2 r20
#define a3 r21
#define digit r22
#define zero r23
#define s0 r14
#define s1 r15
#define s2 r16
#define s3 r17
#define s4 r24
#define s5 r25
#define q0 r28
#define q1 r29

    // a1 b0 and a3 b0
    .macro add_odd_row_0
    mulsu a3, digit
    sbc s5, zero
    movw q0, r0
    mul a1, digit
    add s1, r0
    adc s2, r1
    adc s3, q0
    adc s4, q1
    adc s5, zero
    .endm

    .macro add_row_1 offset
    ldd digit, Z + 4 * \offset + 1
    mul a2, digit
    movw q0, r0
    mul a0, digit
    add s1, r0
    adc s2, r1
    adc s3, q0
    adc s4, q1
    adc s5, zero
    mulsu a3, digit
    movw q0, r0
    mul a1, digit
    add s2, r0
    adc s3, r1
    adc s4, q0
    adc s5, q1
    .endm

    // a1 b2 and the low byte of a3 b2
    .macro add_odd_row_2
    mul a3, digit
    mov q0, r0
    mul a1, digit
    add s3, r0
    adc s4, r1
    adc s5, q0
    .endm

    .macro add_row_3 offset
    ldd digit, Z + 4 * \offset + 3
    mul a2, digit
    mov q0, r0
    mulsu digit, a0
    sbc s5, zero
    add s3, r0
    adc s4, r1
    adc s5, q0
    mulsu_add digit, a1, s4, s5
    .endm

    // s = a_0 b_0
    .macro first_product
    ld_each a0, X+, 4
    ldd digit, Z + 2
    mul a0, digit
    movw s2, r0
    mul a2, digit
    movw s4, r0
    add_odd_row_2
    ld digit, Z
    mul a0, digit
    movw s0, r0
    mul_add a2, digit, s2, s3, zero, s4, s5
    add_odd_row_0
    add_row_1 0
    add_row_3 0
    .endm

    // s += a_i b_i; the last component rounds.
    .macro add_product offset, last
    ld_each a0, X+, 4
    ldd digit, Z + 4 * \offset
    mul a2, digit
    movw q0, r0
    mul a0, digit
    add s0, r0
    adc s1, r1
    adc s2, q0
    adc s3, q1
    adc s4, zero
    adc s5, zero
    add_odd_row_0
    add_row_1 \offset
    ldd digit, Z + 4 * \offset + 2
    mul a2, digit
    movw q0, r0
    mul a0, digit
    .if \last
    lsl s1
    adc s2, r0
    .else
    add s2, r0
    .endif
    adc s3, r1
    adc s4, q0
    adc s5, q1
    add_odd_row_2
    add_row_3 \offset
    .endm

    SECTION fixedpoint_dot_q16_16
    ENTRY fixedpoint_dot2_q16_16
    clt
    rjmp 1f
    ENDFUNC fixedpoint_dot2_q16_16

    ENTRY fixedpoint_dot3_q16_16
    set
1:  push_all s0, s1, s2, s3, q0, q1
    movw r26, r24
    movw r30, r22
    clr zero
    first_product
    brts 2f
    sbiw r30, 4
    rjmp 3f
2:  add_product 1, 0
3:  add_product 2, 1
    pop q1
    pop q0
    movw r22, s2
    pop_all s3, s2, s1, s0
    clr r1
    ret
    ENDFUNC fixedpoint_dot3_q16_16

#endif
