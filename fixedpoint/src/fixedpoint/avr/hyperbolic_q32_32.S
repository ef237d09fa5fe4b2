// SPDX-License-Identifier: MIT
// int64_t fixedpoint_sinh_q32_32_unsaturated(int64_t a)
// int64_t fixedpoint_cosh_q32_32_unsaturated(int64_t a)
// Hyperbolic sine and cosine within 0.65 ulp. Needs a from 0 to below 32 ln 2.
//
// int64_t fixedpoint_exp_q32_32_fine(int64_t a)
// e^a in units of 2^-40, rounded downward. Needs a from -23 to 15.
//
// In       a = r25:r18
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    15 bytes, sinh and cosh 32
// Table    4451 bytes, fixedpoint_exp_64_table
//
// Both powers have a byte behind an ulp; half of their sum is rounded once.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    .macro half_of_powers operation, with_carry
    push r8
    push r9
    push r10
    push r11
    push r12
    push r13
    push r14
    push r15
    push r16
    push r18
    push r19
    push r20
    push r21
    push r22
    set
    XCALL fixedpoint_unrounded_exp_q32_32
    movw r8, r18
    movw r10, r20
    movw r12, r22
    movw r14, r24
    mov r16, r26
    pop r22
    pop r21
    pop r20
    pop r19
    pop r18
    com r18             // the power takes nothing beyond r22
    com r19
    com r20
    com r21
    com r22
    subi r18, 0xff
    sbci r19, 0xff
    sbci r20, 0xff
    sbci r21, 0xff
    sbci r22, 0xff
    XCALL fixedpoint_unrounded_exp_q32_32
    \operation r16, r26
    \with_carry r8, r18
    \with_carry r9, r19
    \with_carry r10, r20
    \with_carry r11, r21
    \with_carry r12, r22
    \with_carry r13, r23
    \with_carry r14, r24
    \with_carry r15, r25
    movw r18, r8
    movw r20, r10
    movw r22, r12
    movw r24, r14
    subi r18, 0xff
    sbci r19, 0xff
    sbci r20, 0xff
    sbci r21, 0xff
    sbci r22, 0xff
    sbci r23, 0xff
    sbci r24, 0xff
    sbci r25, 0xff
    lsr r25
    ror r24
    ror r23
    ror r22
    ror r21
    ror r20
    ror r19
    ror r18
    pop r16
    pop r15
    pop r14
    pop r13
    pop r12
    pop r11
    pop r10
    pop r9
    pop r8
    ret
    .endm

    FUNCTION fixedpoint_sinh_q32_32_unsaturated
    half_of_powers sub, sbc
    ENDFUNC fixedpoint_sinh_q32_32_unsaturated

    FUNCTION fixedpoint_cosh_q32_32_unsaturated
    half_of_powers add, adc
    ENDFUNC fixedpoint_cosh_q32_32_unsaturated

    FUNCTION fixedpoint_exp_q32_32_fine
    set
    XCALL fixedpoint_unrounded_exp_q32_32
    mov r25, r24
    mov r24, r23
    mov r23, r22
    mov r22, r21
    mov r21, r20
    mov r20, r19
    mov r19, r18
    mov r18, r26
    ret
    ENDFUNC fixedpoint_exp_q32_32_fine
#endif
