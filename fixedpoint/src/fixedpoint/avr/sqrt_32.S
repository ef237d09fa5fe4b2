// SPDX-License-Identifier: MIT
// int32_t fixedpoint_sqrt_q<32 - F>_<F>(int32_t a)
// The integer nearest to sqrt(a 2^F), which is never half-way between two, at most 2^31 - 1; 0 if
// a < 0. The square root in every 32-bit format except Q16.16, which has a faster kernel of its
// own.
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    6 bytes
//
// a 2^F is passed like a sum of squares to length_root.S if it is below 3 * 2^46, and otherwise to
// length_long.S.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    // r26:r25..r22 = r25..r22 2^left
    .macro shift_left left
    .if \left == 0
    clr r26
    .else
    ldi r27, 1 << \left
    mul r25, r27
    mov r26, r1
    mov r25, r0
    mul_or_bytes r22, r27, r22, 3
    clr r1
    .endif
    .endm

    .macro long_root
    push_all r28, r29, r17, r16, r15, r14
    clr r29
    .endm

    // The root of r26:r25..r22 2^(8 bytes)
    .macro root bytes
    .if \bytes == 0
    movw r18, r22
    movw r20, r24
    mov r22, r26
    clr r23
    XJMP fixedpoint_length_root
    .elseif \bytes == 1
    clr r18
    mov_bytes r19, r22, 5
    XJMP fixedpoint_length_root
    .elseif \bytes == 2
    movw r20, r22
    clr r18
    clr r19
    movw r22, r24
    tst r26
    brne 1f
    cpi r23, 0xc0
    brsh 1f
    XJMP fixedpoint_length_root
1:  long_root
    clr r17
    mov r16, r26
    XJMP fixedpoint_root_long
    .elseif \bytes == 3
    clr_bytes r18, 3
    mov_bytes r21, r22, 3
    mov r0, r25
    or r0, r26
    brne 1f
    cpi r23, 0xc0
    brsh 1f
    XJMP fixedpoint_length_root
1:  long_root
    mov r16, r25
    mov r17, r26
    XJMP fixedpoint_root_long
    .else
    clr r18
    clr r19
    movw r20, r18
    sbiw r24, 0
    brne 1f
    cpi r23, 0xc0
    brsh 1f
    XJMP fixedpoint_length_root
1:  long_root
    movw r16, r24
    XJMP fixedpoint_root_long
    .endif
    .endm

    .macro kernels integer, fraction
    FUNCTION fixedpoint_sqrt_q\integer\()_\fraction
    tst r25
    brpl 2f
    clr r22
    clr r23
    movw r24, r22
    ret
2:  shift_left (\fraction % 8)
    root (\fraction / 8)
    ENDFUNC fixedpoint_sqrt_q\integer\()_\fraction
    .endm

#include "splits_32.inc"

#endif
