// SPDX-License-Identifier: MIT
// void fixedpoint_cross_q<32 - F>_<F>(int32_t* result, const int32_t* a, const int32_t* b)
// void fixedpoint_twice_cross_q<32 - F>_<F>(the same)
// The cross product of two vectors of three components, and twice that.
//
// void fixedpoint_quaternion_times_vector_q<32 - F>_<F>(the same)
// The vector part of the quaternion a times the vector b.
//
// void fixedpoint_quaternion_product_q<32 - F>_<F>(the same)
// The product of two quaternions, the scalar part first.
//
// Each component is an exact sum of products, some of them negated, divided by 2^F, rounded half up
// and taken modulo 2^32. For every 32-bit format.
//
// In       result = r25:r24, a = r23:r22, b = r21:r20; result must not overlap a or b
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    18 bytes and a call
//
// a, often a rotation, is the operand that product_sum_32.inc takes byte by byte.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

// X is free once a is read.
#define b1 r26
#define number_of_b1 26
#define b2 r27
#include "product_sum_32.inc"

// The quaternions a and b, or where they would begin if a vector is the rest of one.
#define a r2
#define b r4
// The byte offsets of the components i, j, k in cyclic order: 4, 8 and 12.
#define i r6
#define j r7
#define k r8
// Bit 0: add the scalar of a times b; bit 1: add a times the scalar of b; bit 2: double the sum.
#define options r9

    // X and Z point to the components of b and a at the places q and p; then s += a b.
    .macro take_components p, q
    movw r26, b
    add r26, \q
    adc r27, zero
    movw r30, a
    add r30, \p
    adc r31, zero
    .endm
    .macro add_components p, q
    take_components \p, \q
    rcall 9f
    .endm

    // r19, r26 = how far before a and b their quaternions begin.
    .macro cross fraction, top
1:  set_short \fraction
    push_all r2, r3, r4, r5, r6, r7, r8, r9, r28, r29
    push_sum \top
    movw r28, r24
    movw a, r22
    movw b, r20
    mov options, r18
    clr zero
    sub a, r19
    sbc r3, zero
    sub b, r26
    sbc r5, zero
    ldi r24, 4
    mov i, r24
    ldi r24, 8
    mov j, r24
    ldi r24, 12
    mov k, r24
    sbrs options, 1
    rjmp 2f
    begin \fraction, \top, 0xff
    movw r30, a
    .irp place, 4, 8, 12
    adiw r30, 4
    .if is_short || \place == 4
    movw r26, b
    adiw r26, \place
    .endif
    rcall 9f
    .endr
    com_bytes s0, (\top + 1)
    movw r26, b
    movw r30, a
    rcall 9f
    finish \fraction
2:  .if is_short
    take_components k, j
    ld_each a0, X+, 4
    begin_subtracted_product \fraction, \top
    .else
    begin \fraction, \top, 0xff
    add_components k, j
    com_bytes s0, (\top + 1)
    .endif
    add_components j, k
    sbrc options, 2
    rjmp 3f
    sbrs options, 0
    rjmp 4f
    movw r26, b
    add r26, i
    adc r27, zero
    movw r30, a
    rcall 9f
    sbrs options, 1
    rjmp 4f
    movw r26, b
    movw r30, a
    add r30, i
    adc r31, zero
    rcall 9f
    rjmp 4f
3:  double_sum \fraction, \top
4:  finish \fraction
    mov r24, i
    mov i, j
    mov j, k
    mov k, r24
    sbrc i, 3           // not back at 4
    rjmp 2b
    clr r1
    pop_sum \top
    pop_all r29, r28, r9, r8, r7, r6, r5, r4, r3, r2
    ret
9:  ld_each a0, X+, 4
    add_product \fraction, \top
    ret
    .endm

    .macro kernels integer, fraction
    SECTION fixedpoint_cross_q\integer\()_\fraction
    ENTRY fixedpoint_cross_q\integer\()_\fraction
    ldi r18, 0
    ldi r19, 4
    ldi r26, 4
    rjmp 1f
    ENDFUNC fixedpoint_cross_q\integer\()_\fraction

    ENTRY fixedpoint_twice_cross_q\integer\()_\fraction
    ldi r18, 4
    ldi r19, 4
    ldi r26, 4
    rjmp 1f
    ENDFUNC fixedpoint_twice_cross_q\integer\()_\fraction

    ENTRY fixedpoint_quaternion_times_vector_q\integer\()_\fraction
    ldi r18, 1
    ldi r19, 0
    ldi r26, 4
    rjmp 1f
    ENDFUNC fixedpoint_quaternion_times_vector_q\integer\()_\fraction

    ENTRY fixedpoint_quaternion_product_q\integer\()_\fraction
    ldi r18, 3
    ldi r19, 0
    ldi r26, 0
    cross \fraction, ((\fraction - 1) / 8 + 4)
    ENDFUNC fixedpoint_quaternion_product_q\integer\()_\fraction
    .endm

#include "splits_32.inc"
    kernels 16, 16

#endif
