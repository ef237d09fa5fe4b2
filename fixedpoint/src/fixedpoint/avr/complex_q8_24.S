// SPDX-License-Identifier: MIT
// void fixedpoint_complex_product_q8_24(int32_t* result, const int32_t* a, const int32_t* b)
// That of complex_32.S for Q8.24.
//
// In       result = r25:r24, a = r23:r22, b = r21:r20, in RAM; result must not be a or b
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    9 bytes and a call

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "upper_sum_q8_24.inc"

    SECTION fixedpoint_complex_product_q8_24
    highest_products

    ENTRY fixedpoint_complex_product_q8_24
    push_all r11, r12, r13, r14, r15, r16, r17, r28, r29
    movw r26, r24
    movw r28, r22
    movw r30, r20
    clr zero
    load_a 4            // the imaginary part
    set                 // T: of the real part
2:  load_b 4
    first_upper_rows
    upper_highest_bytes 4
    ldi q1, 0x80        // rounds
    brtc 3f
    // Minus the product less 3 units, so that what is missing is not negative: com is 1 too low.
    com u2
    com u3
    com u4
    com u5
    com u6
    ldi q1, 0x80 - 3 + 1
3:  load_a 0            // the other part
    load_b 0
    upper_rows
    upper_highest_bytes 0
    branch_if_missing .Lmissing
4:  store_upper_sum
    brtc 5f
    clt
    adiw r28, 4
    rjmp 2b
5:  clr r1
    pop_all r29, r28, r17, r16, r15, r14, r13, r12, r11
    ret

.Lmissing:
    begin_missing
    ldd b0, Z + 0
    missing_bytes add, adc
    brts 1f
    sbiw r28, 8
1:  ldd a0, Y + 4
    ldd a1, Y + 5
    ldd b0, Z + 4
    ldd b1, Z + 5
    brts 1f
    adiw r28, 8
    missing_bytes add, adc
    rjmp 3f
1:  missing_bytes sub, sbc
    ldi a0, 3
    add b2, a0
3:  add_missing
    load_a 0
    rjmp 4b
    ENDFUNC fixedpoint_complex_product_q8_24

#endif
