// SPDX-License-Identifier: MIT
// int64_t fixedpoint_exp2_q32_32_unsaturated(int64_t a)
// 2^a within 0.65 ulp. a must be in [-33, 31).
//
// In       a = r25:r18
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    13 bytes
// Table    4451 bytes, fixedpoint_exp_64_table
//
// Argument reduction: a = k - g with 0 <= g < 1, and r = g ln 2 to 72 bits, column by column; of
// the column below the lowest one only the upper bytes are included. exp_q32_32.S does the rest.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define zero r17
#define digit r23

    // g_i and the byte of ln 2 whose product belongs to a column.
    .macro product i
    .set j, column + 4 - \i
    .if j >= 0 && j < 9
    .if j == 0
    ldi digit, 0xca
    .elseif j < 5
    ldi digit, (0xd1cf79ab >> (8 * j - 8)) & 0xff
    .else
    ldi digit, (0xb17217f7 >> (8 * j - 40)) & 0xff
    .endif
    mul 18 + \i, digit
    .if column < 0
    add r8, r1
    adc r9, zero
    .else
    add 8 + column, r0
    .if column < 8
    adc 9 + column, r1
    .endif
    .if column < 7
    adc 10 + column, zero
    .endif
    .endif
    .endif
    .endm

    FUNCTION fixedpoint_exp2_q32_32_unsaturated
    push_all r8, r9, r10, r11, r12, r13, r14, r15, r16, r17, r28, r29
    clr zero
    com_bytes r18, 4
    increment_bytes r18, 4
    adc r22, zero       // the carry is set if g is not 0
    subi r22, -41
    push r22
    clr r8
    clr r9
    .set column, -1
    .rept 10
    .if column >= 0 && column < 7
    clr 10 + column
    .endif
    product 0
    product 1
    product 2
    product 3
    .set column, column + 1
    .endr
    clt
    XJMP fixedpoint_power_of_rest_q32_32
    ENDFUNC fixedpoint_exp2_q32_32_unsaturated
#endif
