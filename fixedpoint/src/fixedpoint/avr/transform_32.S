// SPDX-License-Identifier: MIT
// void fixedpoint_transform_q<32 - F>_<F>(int32_t* result, const int32_t* v, const int32_t* m,
//                                         uint8_t n)
// The matrix m of n rows times the column v; n must be 2, 3 or 4. Each component is floor(sum m_ij
// v_j / 2^F + 1/2) modulo 2^32, one rounding. For every 32-bit format.
//
// void fixedpoint_matrix_product_q<32 - F>_<F>(the same)
// The matrix v of n rows times the matrix m, each element rounded in the same way.
//
// In       result = r25:r24, v = r23:r22, m = r21:r20, n = r18; result must not overlap v or m
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    21 bytes
//
// void fixedpoint_matrix_product_2_q<32 - F>_<F>(int32_t* result, const int32_t* a, const int32_t* b)
// The same of two rows: the matrix a = r23:r22 times b = r21:r20; for Q8.24 see
// matrix_product_2_q8_24.S. It takes 11 or 12 bytes of stack.
//
// The cost of the call and of saving registers is paid once, not per component or row.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define b1 r17
#define b2 r7
#include "product_sum_32.inc"

#define v r2
#define m r4
#define step r6
#define next r7
#define end r8
#define left r9

    // r26 = the distance in bytes from one product of a component to the next, r27 = that from the
    // first product of one component to that of the next, r19 = the bytes of a row of v; T is set
    // if v has n.
    .macro transform fraction, top
1:  set_short \fraction
    push_all r2, r3, r4, r5, r6, r7, r8, r9, r28, r29
    push_sum \top
    push r18
    movw r28, r24
    movw v, r22
    movw m, r20
    mov step, r26
    .if !is_short
    mov next, r27
    .endif
    mov end, r22
    add end, r19
    mov left, r18
    clr zero
2:  movw r26, v
    movw r30, m
    .if is_short
    ld_each a0, X+, 4
    begin_product \fraction, \top
    add r30, step
    adc r31, zero
    .else
    begin \fraction, \top
    .endif
4:  ld_each a0, X+, 4
    add_product \fraction, \top
    cp r26, end
    breq 5f
    add r30, step
    adc r31, zero
    rjmp 4b
5:  finish \fraction
    .if is_short
    ldi r24, 4
    brts 1f
    mov r24, end
    sub r24, v
1:  add m, r24
    .else
    add m, next
    .endif
    adc r5, zero
    dec left
    breq 7f
6:  rjmp 2b
7:  brtc 8f
    pop r18
    dec r18
    push r18
    breq 8f
    mov left, step
    lsr left
    lsr left
    sub m, step
    sbc r5, zero
    add v, step
    adc r3, zero
    add end, step
    rjmp 6b
8:  clr r1
    pop r18
    pop_sum \top
    pop_all r29, r28, r9, r8, r7, r6, r5, r4, r3, r2
    ret
    .endm

    .macro product_2 fraction, top
    set_short \fraction
    push_all r28, r29, left
    .if is_short
    push b2
    .endif
    push_sum \top
    movw r28, r24
    movw r26, r22
    movw r30, r20
    clr zero
    ldi q0, 4
    mov left, q0
6:  ld_each a0, X+, 4
    begin_product \fraction, \top
    ld_each a0, X+, 4
    add_product \fraction, \top, at=8
    finish \fraction
    dec left
    breq 8f
    sbrs left, 0
    rjmp 7f
    sbiw r26, 8         // the row again, and the other column
    adiw r30, 8
7:  sbiw r30, 4
    rjmp 6b
8:  clr r1
    pop_sum \top
    .if is_short
    pop b2
    .endif
    pop_all left, r29, r28
    ret
    .endm

    .macro bytes_of_v
    mov r19, r18
    lsl r19
    lsl r19
    .endm

    .macro kernels integer, fraction
    SECTION fixedpoint_transform_q\integer\()_\fraction
    ENTRY fixedpoint_transform_q\integer\()_\fraction
    bytes_of_v
    ldi r26, 4
    mov r27, r19
    clt
    rjmp 1f
    ENDFUNC fixedpoint_transform_q\integer\()_\fraction

    ENTRY fixedpoint_matrix_product_q\integer\()_\fraction
    bytes_of_v
    mov r26, r19
    ldi r27, 4
    set
    transform \fraction, ((\fraction - 1) / 8 + 4)
    ENDFUNC fixedpoint_matrix_product_q\integer\()_\fraction

    .if \fraction != 24    // matrix_product_2_q8_24.S
    FUNCTION fixedpoint_matrix_product_2_q\integer\()_\fraction
    product_2 \fraction, ((\fraction - 1) / 8 + 4)
    ENDFUNC fixedpoint_matrix_product_2_q\integer\()_\fraction
    .endif
    .endm

#include "splits_32.inc"
    kernels 16, 16

#endif
