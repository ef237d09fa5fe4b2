// SPDX-License-Identifier: MIT
// uint8_t fixedpoint_invert2_q<32 - F>_<F>(const int32_t* a, int32_t* inverse)
// Writes the inverse of a 2x2 matrix (blocks/matrix.hpp) and returns 1; if the rounded determinant
// is 0, only returns 0. For every 32-bit format but Q16.16.
//
// In       a = r25:r24, inverse = r23:r22, in RAM; inverse must not be a
// Out      r24
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    20 bytes and a call
//
// The determinant is the sum of -a10 a01 and a00 a11; inverse2_32.S divides by it and returns.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

// X is free.
#define b1 r26
#define number_of_b1 26
#define b2 r27
#include "product_sum_32.inc"

#define inverse r2

    .macro take_determinant number
    mov_bytes r18, \number, 4
    .endm

    .macro invert2 fraction, top
    set_short \fraction
    push_all r2, r3, r4, r5, r6, r7, r8, r9, r10, r11, r12, r13, r14, r15, r16, r17, r28, r29
    movw r28, r24
    movw inverse, r22
    movw r30, r24
    clr zero
    ldd_bytes a0, Y + 8, 4
    negate_bytes a0, 4
    begin_product \fraction, \top, 4
    ldd_bytes a0, Y + 0, 4
    add_signed_product \fraction, \top, 0, 12   // mostly not below 1
    result \fraction, take_determinant
    movw r26, r28
    adiw r26, 12
    movw r28, inverse
    ldi r30, 1 << (\fraction % 8)
    ldi r31, \fraction / 8
    XJMP fixedpoint_inverse2_32
    .endm

    .macro kernels integer, fraction
    FUNCTION fixedpoint_invert2_q\integer\()_\fraction
    invert2 \fraction, ((\fraction - 1) / 8 + 4)
    ENDFUNC fixedpoint_invert2_q\integer\()_\fraction
    .endm

#include "splits_32.inc"

#endif
