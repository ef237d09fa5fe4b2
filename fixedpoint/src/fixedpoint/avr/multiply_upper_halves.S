// SPDX-License-Identifier: MIT
// uint64_t fixedpoint_multiply_upper_halves(uint64_t a, uint64_t b)
// a b / 2^64, or up to 2^18 less: a1 b1 of the upper words plus, for an upper and a lower word, the
// product of their upper halves.
//
// In       a = r25:r18, b = r17:r10
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    3 bytes
//
// The products of the halves and a1 b1 are aligned with the lowest byte of the result. a1 b1 is
// computed row by row as in multiply_words.S, except that the second chain of a row may leave a
// carry.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

// Bytes 2 and 3 of the lower words, 4 to 7 of the upper ones.
#define a2 r20
#define a3 r21
#define a4 r22
#define a5 r23
#define a6 r24
#define a7 r25
#define b2 r12
#define b3 r13
#define b4 r14
#define b5 r15
#define b6 r16
#define b7 r17
#define t0 r30
#define t1 r31
#define zero r11
#define s0 r18
#define s1 r19
#define s2 r26
#define s3 r27
#define s4 r28
#define s5 r29
#define s6 r20
#define s7 r21

    // s4:s0 += p1:p0 q1:q0
    .macro pair p0, p1, q0, q1
    mul_add \p0, \q1, s1, s2, zero, s3, s4
    mul_add \p1, \q0, s1, s2, zero, s3, s4
    mul \p1, \q1
    movw t0, r0
    mul \p0, \q0
    add s0, r0
    adc s1, r1
    adc s2, t0
    adc s3, t1
    adc s4, zero
    .endm
    .macro row b, low0, low1, low2, low3, top, next
    mul a6, \b
    movw t0, r0
    mul a4, \b
    add \low0, r0
    adc \low1, r1
    adc \low2, t0
    adc \low3, t1
    adc \top, zero
    mul a7, \b
    movw t0, r0
    mul a5, \b
    add \low1, r0
    adc \low2, r1
    adc \low3, t0
    adc \top, t1
    .ifnb \next
    adc \next, zero
    .endif
    .endm

    FUNCTION fixedpoint_multiply_upper_halves
    push_all zero, r28, r29
    clr zero
    ldi s4, 0
    mul a2, b6
    movw s0, r0
    mul a3, b7
    movw s2, r0
    mul_add a2, b7, s1, s2, zero, s3, s4
    mul_add a3, b6, s1, s2, zero, s3, s4
    pair b2, b3, a6, a7
    ldi s5, 0
    ldi s6, 0
    ldi s7, 0
    row b4, s0, s1, s2, s3, s4, s5
    row b5, s1, s2, s3, s4, s5, s6
    row b6, s2, s3, s4, s5, s6, s7
    row b7, s3, s4, s5, s6, s7
    movw r24, s6
    movw r22, s4
    movw r20, s2
    clr r1
    pop_all r29, r28, zero
    ret
    ENDFUNC fixedpoint_multiply_upper_halves
#endif
