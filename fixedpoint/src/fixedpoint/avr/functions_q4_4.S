// SPDX-License-Identifier: MIT
// int8_t fixedpoint_sin_q4_4(int8_t angle)
// int8_t fixedpoint_cos_q4_4(int8_t angle)
// void fixedpoint_sincos_q4_4(int8_t angle, int8_t* sine_and_cosine)
// int8_t fixedpoint_atan_q4_4(int8_t a)
// int8_t fixedpoint_exp_q4_4(int8_t a)
// int8_t fixedpoint_log_q4_4(int8_t a)
// int8_t fixedpoint_sqrt_q4_4(int8_t a)
// int8_t fixedpoint_reciprocal_sqrt_q4_4(int8_t a)
// The result rounded to nearest (there are no ties) and saturated; the smallest number for the
// logarithm of a <= 0; 0 for the roots of a < 0; the largest number for 1 / sqrt(0).
//
// In:       r24, sine_and_cosine r23:r22
// Out:      r24; of sincos, two numbers in memory
// Clobbers: r30, r31; sincos also r0, r26, r27
// Stack:    0 bytes.
//
// The tables contain the result for every number: no arithmetic is faster than one load.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    .macro lookup operation
    FUNCTION fixedpoint_\operation\()_q4_4
    mov r30, r24
    ldi r31, hi8(fixedpoint_\operation\()_q4_4_table)
    lpm r24, Z
    ret
    ENDFUNC fixedpoint_\operation\()_q4_4
    .endm

    lookup sin
    lookup cos
    lookup atan
    lookup exp
    lookup log
    lookup sqrt
    lookup reciprocal_sqrt

    FUNCTION fixedpoint_sincos_q4_4
    movw r26, r22
    mov r30, r24
    ldi r31, hi8(fixedpoint_sin_q4_4_table)
    lpm r0, Z
    st X+, r0
    ldi r31, hi8(fixedpoint_cos_q4_4_table)
    lpm r0, Z
    st X, r0
    ret
    ENDFUNC fixedpoint_sincos_q4_4

#endif
