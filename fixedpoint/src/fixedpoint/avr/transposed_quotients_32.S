// SPDX-License-Identifier: MIT
// void fixedpoint_transposed_quotients_q<32 - F>_<F>(int32_t* q, const int32_t* a, int32_t d, uint8_t n)
// The quotients q_ij = a_ji / d of a square matrix a of n rows. n must be 2 or 3, and d must not be 0.
// Each is the result of fixedpoint_divide_q<32 - F>_<F>. For every 32-bit format but Q16.16.
//
// In       q = r25:r24, a = r23:r22, in RAM, d = r21:r18, n = r16; q must not overlap a
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    20 bytes and a call
// Table    512 bytes, fixedpoint_reciprocal_table
//
// quotients_32.inc explains the method.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "quotients_32.inc"

#define left r12
#define rows r13
// The distance in bytes from an element of a to the next one in its column, minus the four read.
#define step r17

    SECTION fixedpoint_transposed_quotients_32
    other_quotients
.Ldivide:
    push_all r26, r27
    movw r30, r26
    sbiw r30, 4
    ld_each r22, Z+, 4
    divide_again
    pop_all r27, r26
    rising 0, 4, st, Y+, .Lr22 + \n
    rjmp .Lnext

    // r30 = 2^(F mod 8), r31 = floor(F / 8)
    ENTRY fixedpoint_transposed_quotients_32
    push_all r2, r3, r4, r5, r6, r7, r8, r9, r10, r11, r12, r13, r14, r15, r16, r17, r28, r29
    push_all r23, r22
    movw kept, r24
    mov rows, r16
    take_reciprocal
    pop_all r26, r27
    mov step, rows
    dec step
    lsl step
    lsl step
    mov left, rows

.Lelement:
    ld_each a0, X+, 4
    find_quotient
    st Y+, p5
    st Y+, p6
    st Y+, p7
    st Y+, p8
.Lnext:
    add r26, step
    adc r27, nothing
    dec left
    brne .Lelement_again
    dec rows
    breq 4f
    mov r24, step       // back by n rows, to the next column
    subi r24, 0xfc
    mov r0, r24
    lsr r24
    lsr r24
    mov left, r24
    mul r0, r24
    sub r26, r0
    sbc r27, nothing
    adiw r26, 4
.Lelement_again:
    rjmp .Lelement
.Lfar_divide:
    rjmp .Ldivide
4:  clr r1
    pop_all r29, r28, r17, r16, r15, r14, r13, r12, r11, r10, r9, r8, r7, r6, r5, r4, r3, r2
    ret
    ENDFUNC fixedpoint_transposed_quotients_32

    .macro kernels integer, fraction
    FUNCTION fixedpoint_transposed_quotients_q\integer\()_\fraction
    ldi r30, 1 << (\fraction % 8)
    ldi r31, \fraction / 8
    XJMP fixedpoint_transposed_quotients_32
    ENDFUNC fixedpoint_transposed_quotients_q\integer\()_\fraction
    .endm

#include "splits_32.inc"

#endif
