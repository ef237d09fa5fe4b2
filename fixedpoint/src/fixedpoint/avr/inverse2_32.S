// SPDX-License-Identifier: MIT
// The end of invert2_32.S in all formats; invert2_32.S has saved the registers. If the determinant
// d = r21:r18 is not 0, writes the inverse of the matrix whose last element is at X to Y and returns
// 1; otherwise only returns 0. quotients_32.inc computes the quotients. A negated cofactor changes
// the sign of the quotient; only the smallest number, its own negative, is negated and divided.
//
// Table    512 bytes, fixedpoint_reciprocal_table

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "quotients_32.inc"

// The elements left, 4 to 1; bit 1 is set if the cofactor is negated.
#define left r12

    .macro change_sign
    sbrc left, 1
    com r0
    .endm

    SECTION fixedpoint_inverse2_32
    other_quotients
.Ldivide:
    push_all r26, r27
    movw r30, r26
    sbiw r30, 4
    ld_each r22, Z+, 4
    sbrs left, 1
    rjmp 1f
    negate_bytes r22, 4
1:  divide_again
    pop_all r27, r26
    rising 0, 4, st, Y+, .Lr22 + \n
    rjmp .Lnext

    // r30 = 2^(F mod 8), r31 = floor(F / 8)
    ENTRY fixedpoint_inverse2_32
    or_bytes r0, d0, 4
    brne 1f
    mov r24, r0
    rjmp .Lreturn
1:  movw left, r26
    movw kept, r28
    take_reciprocal
    movw r26, left
    ldi r24, 4
    mov left, r24
.Lelement:
    ld_each a0, X+, 4
    find_quotient change_sign
    st Y+, p5
    st Y+, p6
    st Y+, p7
    st Y+, p8
.Lnext:
    sbrc left, 0        // simavr would skip `sbiw` as if it had two words
    rjmp 1f
    sbiw r26, 12        // the element above
1:  dec left
    breq 4f
    rjmp .Lelement
.Lfar_divide:
    rjmp .Ldivide
4:  ldi r24, 1
.Lreturn:
    clr r1
    pop_all r29, r28, r17, r16, r15, r14, r13, r12, r11, r10, r9, r8, r7, r6, r5, r4, r3, r2
    ret
    ENDFUNC fixedpoint_inverse2_32

#endif
