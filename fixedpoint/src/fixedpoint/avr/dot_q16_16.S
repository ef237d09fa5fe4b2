// SPDX-License-Identifier: MIT
// int32_t fixedpoint_dot2_q16_16(const int32_t* a, const int32_t* b)
// int32_t fixedpoint_dot3_q16_16(const int32_t* a, const int32_t* b)
// floor(sum a_i b_i / 2^16 + 1/2) modulo 2^32 of 2 or 3 components: one rounding.
//
// In       a = r25:r24, b = r23:r22, in RAM
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    7 bytes
//
// Bytes 0..5 of the exact sum are formed, since 2^48 is beyond the result. As in
// multiply_q16_16.inc, the lower two bytes of a component of a and the lower three of b begin, and
// of the upper bytes, which are mostly the sign only, 0 adds nothing and -1 subtracts the other
// operand. Two products whose bytes do not overlap are added in one carry chain. Rounding adds 2^15,
// which carries into byte 2 exactly when byte 1 has its top bit set: in the last component `lsl` of
// it is the carry of the first chain that begins at byte 2.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define a0 r18
#define a1 r19
#define a2 r20
#define b0 r16
#define b1 r17
#define b2 r13
// The highest byte of an operand; it is zero in between.
#define top r21
#define zero r21
#define s0 r14
#define s1 r15
#define s2 r22
#define s3 r23
#define s4 r24
#define s5 r25
#define q0 r28
#define q1 r29

    .macro load_component
    ld_each a0, X+, 3
    ld b0, Z+
    ld b1, Z+
    ld b2, Z+
    .endm

    // s5:s0 = (a1:a0) (b2:b0). a1 b1 absorbs the carries of the columns below it, and the product
    // has five bytes.
    .macro first_lower_products
    mul a0, b0
    movw s0, r0
    mul a1, b1
    movw s2, r0
    clr s4
    clr s5
    mul_add a0, b1, s1, s2, s5, s3
    mul_add a1, b0, s1, s2, s5, s3
    mul_add a0, b2, s2, s3, s5, s4
    mul_add a1, b2, s3, s4
    .endm

    // s5:s0 += (a1:a0) (b2:b0), and 2^15 if `last`.
    .macro add_lower_products last
    mul a1, b1
    movw q0, r0
    mul a0, b0
    add s0, r0
    adc s1, r1
    adc s2, q0
    adc s3, q1
    adc s4, zero
    adc s5, zero
    mul a1, b2
    movw q0, r0
    mul a0, b1
    add s1, r0
    adc s2, r1
    adc s3, q0
    adc s4, q1
    adc s5, zero
    mul_add a1, b0, s1, s2, zero, s3, s4, s5
    mul a0, b2
    .if \last
    lsl s1
    adc s2, r0
    .else
    add s2, r0
    .endif
    adc s3, r1
    adc s4, zero
    adc s5, zero
    .endm

    // s5:s0 += the other products.
    .macro add_upper_products
    ld top, Z+          // of b
    tst top
    breq 2f
    cpi top, 0xff
    brne 1f
    sub s3, a0
    sbc s4, a1
    sbc s5, a2
    rjmp 2f
1:  mulsu top, a0
    sbc s5, q0          // the sign; q0 is added again with the carry
    add s3, r0
    adc s4, r1
    adc s5, q0
    mulsu_add top, a1, s4, s5
    mul top, a2
    add s5, r0
2:  ld top, X+          // of a
    tst top
    breq 5f
    cpi top, 0xff
    brne 3f
    clr zero
    cpi a2, 0xff
    breq 4f
    sub s3, b0
    sbc s4, b1
    sbc s5, b2
    rjmp 6f
3:  mulsu top, b0
    sbc s5, q0
    add s3, r0
    adc s4, r1
    adc s5, q0
    mulsu_add top, b1, s4, s5
    mul top, b2
    add s5, r0
    clr zero
    rjmp 6f
4:  sub s2, b0          // -2^16 b
    sbc s3, b1
    sbc s4, b2
    sbc s5, zero
    rjmp 7f
5:  tst a2
    breq 7f
6:  mul a2, b2
    movw q0, r0
    mul a2, b0
    add s2, r0
    adc s3, r1
    adc s4, q0
    adc s5, q1
    mul_add a2, b1, s3, s4, zero, s5
7:
    .endm

    SECTION fixedpoint_dot_q16_16
    ENTRY fixedpoint_dot2_q16_16
    clt
    rjmp 1f
    ENDFUNC fixedpoint_dot2_q16_16

    ENTRY fixedpoint_dot3_q16_16
    set
1:  push_all b2, s0, s1, b0, b1, q0, q1
    movw r26, r24
    movw r30, r22
    load_component
    first_lower_products
    add_upper_products
    brts 8f
    rjmp 9f
8:  load_component
    add_lower_products 0
    add_upper_products
9:  load_component
    add_lower_products 1
    add_upper_products
    pop_all q1, q0, b1, b0, s1, s0, b2
    clr r1
    ret
    ENDFUNC fixedpoint_dot3_q16_16

#endif
