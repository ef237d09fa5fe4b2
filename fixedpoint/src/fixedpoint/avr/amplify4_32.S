// SPDX-License-Identifier: MIT
// void fixedpoint_amplify4_q<32 - F>_<F>(int32_t* a, int32_t b)
// a_i += floor(a_i b / 2^F + 1/2) modulo 2^32 for four numbers. For every 32-bit format but Q16.16.
//
// In       a = r25:r24, in RAM, b = r23:r20
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    5 bytes
//
// The products are those of columns_32.inc.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include "columns_32.inc"

#define count r15

    .macro amplify4 fraction
    push_all count, r16, r17, r28, r29
    movw r28, r24
    movw rB0, r20
    movw rB2, r22
    begin_products \fraction
    ldi r24, 4
    mov count, r24
2:  ldd_bytes a0, Y + 0, 2
    ldd_bytes a2, Y + 2, 2
    product_by_b \fraction
    each_sum shift, \fraction
    each_sum add_to_a, \fraction
    st Y+, a0
    st Y+, a1
    st Y+, a2
    st Y+, a3
    dec count
    breq 5f
    rjmp 2b
5:  clr r1
    pop_all r29, r28, r17, r16, count
    ret
    other_product \fraction
    .endm

    .macro kernels integer, fraction
    FUNCTION fixedpoint_amplify4_q\integer\()_\fraction
    amplify4 \fraction
    ENDFUNC fixedpoint_amplify4_q\integer\()_\fraction
    .endm

#include "splits_32.inc"

#endif
