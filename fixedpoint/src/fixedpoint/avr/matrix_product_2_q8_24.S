// SPDX-License-Identifier: MIT
// void fixedpoint_matrix_product_2_q8_24(int32_t* result, const int32_t* a, const int32_t* b)
// That of transform_32.S for Q8.24.
//
// In       result = r25:r24, a = r23:r22, b = r21:r20, in RAM; result must not overlap a or b
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    10 bytes and a call

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "upper_sum_q8_24.inc"

#define left r10

    SECTION fixedpoint_matrix_product_2_q8_24
    highest_products

    ENTRY fixedpoint_matrix_product_2_q8_24
    push_all left, r11, r12, r13, r14, r15, r16, r17, r28, r29
    movw r26, r24
    movw r28, r22
    movw r30, r20
    clr zero
    ldi q0, 4
    mov left, q0
2:  load_a 0
    load_b 0
    first_upper_rows
    upper_highest_bytes 0
    ldi q1, 0x80        // rounds
    load_a 4
    load_b 8
    upper_rows
    upper_highest_bytes 8
    branch_if_missing .Lmissing
3:  store_upper_sum
    dec left
    breq 5f
    sbrs left, 0
    rjmp 4f
    adiw r30, 4         // the other column
    rjmp 2b
4:  sbiw r30, 4
    adiw r28, 8
    rjmp 2b
5:  clr r1
    pop_all r29, r28, r17, r16, r15, r14, r13, r12, r11, left
    ret

.Lmissing:
    begin_missing
    ldd b0, Z + 8
    missing_bytes add, adc
    ldd a0, Y + 0
    ldd a1, Y + 1
    ldd b0, Z + 0
    ldd b1, Z + 1
    missing_bytes add, adc
    add_missing
    rjmp 3b
    ENDFUNC fixedpoint_matrix_product_2_q8_24

#endif
