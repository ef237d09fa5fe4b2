// SPDX-License-Identifier: MIT
// int32_t fixedpoint_dot2_q<32 - F>_<F>(const int32_t* a, const int32_t* b)
// int32_t fixedpoint_dot3_q<32 - F>_<F>(const int32_t* a, const int32_t* b)
// floor(sum a_i b_i / 2^F + 1/2) modulo 2^32 of 2 or 3 components, one rounding: of each split of
// 32 bits but Q16.16, whose own is faster.
//
// In       a = r25:r24, b = r23:r22, in RAM
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    11 bytes

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include "product_sum_32.inc"

#define count r28

    .macro dot fraction, top
1:  push_sum \top
    push count
    mov count, r26
    movw r26, r24
    movw r30, r22
    clr zero
    begin \fraction, \top
2:  ld_each a0, X+, 4
    add_product \fraction, \top
    adiw r30, 4
    dec count
    breq 5f
    rjmp 2b
5:  result \fraction, take_result
    clr r1
    pop count
    pop_sum \top
    ret
    .endm

    .macro kernels integer, fraction
    SECTION fixedpoint_dot_q\integer\()_\fraction
    ENTRY fixedpoint_dot2_q\integer\()_\fraction
    ldi r26, 2
    rjmp 1f
    ENDFUNC fixedpoint_dot2_q\integer\()_\fraction

    ENTRY fixedpoint_dot3_q\integer\()_\fraction
    ldi r26, 3
    dot \fraction, ((\fraction - 1) / 8 + 4)
    ENDFUNC fixedpoint_dot3_q\integer\()_\fraction
    .endm

#include "splits_32.inc"

#endif
