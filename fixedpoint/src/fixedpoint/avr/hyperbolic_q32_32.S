// SPDX-License-Identifier: MIT
// int64_t fixedpoint_sinh_q32_32_unsaturated(int64_t a)
// int64_t fixedpoint_cosh_q32_32_unsaturated(int64_t a)
// Hyperbolic sine and cosine within 0.65 ulp. a must be in [0, 32 ln 2).
//
// int64_t fixedpoint_exp_q32_32_fine(int64_t a)
// e^a in units of 2^-40, rounded downward. a must be in [-23, 15].
//
// In       a = r25:r18
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    15 bytes, sinh and cosh 32
// Table    4451 bytes, fixedpoint_exp_64_table
//
// Both powers have a guard byte; half of their sum is rounded once.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    .macro half_of_powers operation, with_carry
    push_all r8, r9, r10, r11, r12, r13, r14, r15, r16, r18, r19, r20, r21, r22
    set
    XCALL fixedpoint_unrounded_exp_q32_32
    movw_bytes r8, r18, 8
    mov r16, r26
    pop_all r22, r21, r20, r19, r18
    com_bytes r18, 5    // the power takes nothing beyond r22
    increment_bytes r18, 5
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
    movw_bytes r18, r8, 8
    increment_bytes r18, 8
    lsr_bytes r18, 8
    pop_all r16, r15, r14, r13, r12, r11, r10, r9, r8
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
    mov_from_top r19, r18, 7
    mov r18, r26
    ret
    ENDFUNC fixedpoint_exp_q32_32_fine
#endif
