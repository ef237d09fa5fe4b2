// SPDX-License-Identifier: MIT
// void fixedpoint_cofactors_q<32 - F>_<F>(const int32_t* m, int32_t* result)
// The cofactors of a 3x3 matrix: row i is the cross product of the two rows after row i in cyclic
// order. Each is the exact difference of two products, divided by 2^F, rounded half up and taken
// modulo 2^32. For every 32-bit format.
//
// In       m = r25:r24, result = r23:r22, in RAM; result must not be m
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    18 bytes

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

// X is free once a is read.
#define b1 r26
#define number_of_b1 26
#define b2 r27
#include "product_sum_32.inc"

// The two rows, and the byte offsets of their components in cyclic order.
#define p r2
#define q r4
#define i r6
#define j r7
#define k r8
#define left r9

    // a = p_x, and Z points to q_z.
    .macro take_components x, z
    movw r26, p
    add r26, \x
    adc r27, zero
    movw r30, q
    add r30, \z
    adc r31, zero
    ld_each a0, X+, 4
    .endm

    .macro cofactors fraction, top
    set_short \fraction
    push_all r2, r3, r4, r5, r6, r7, r8, r9, r28, r29
    push_sum \top
    movw r28, r22
    adiw r24, 12
    movw p, r24
    adiw r24, 12
    movw q, r24
    clr zero
    clr i
    ldi r24, 4
    mov j, r24
    ldi r24, 8
    mov k, r24
    ldi r24, 3
    mov left, r24
2:  take_components k, j
    begin_subtracted_product \fraction, \top, 1
    take_components j, k
    add_product \fraction, \top, 1
    finish \fraction
    mov r24, i
    mov i, j
    mov j, k
    mov k, r24
    tst i
    brne 4f
    dec left
    breq 5f
    movw r24, p
    movw p, q
    sbiw r24, 12
    movw q, r24
4:  rjmp 2b
5:  clr r1
    pop_sum \top
    pop_all r29, r28, r9, r8, r7, r6, r5, r4, r3, r2
    ret
    .endm

    .macro kernels integer, fraction
    FUNCTION fixedpoint_cofactors_q\integer\()_\fraction
    cofactors \fraction, ((\fraction - 1) / 8 + 4)
    ENDFUNC fixedpoint_cofactors_q\integer\()_\fraction
    .endm

#include "splits_32.inc"
    kernels 16, 16

#endif
