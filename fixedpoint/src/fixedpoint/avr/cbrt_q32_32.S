// SPDX-License-Identifier: MIT
// int64_t fixedpoint_cbrt_q32_32(int64_t a)
// The cube root of a, with its sign, within 0.55 ulp.
//
// In       a = r25:r18
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    17 bytes
// Table    3349 bytes, fixedpoint_cbrt_64_table
//
// |a| = m 2^e, 1 <= m < 2. The core gives y, the cube root of m, within 2^-34, and one Newton step,
// y + (m - y^3) / (3 y^2), is within 2^-47. Only the bytes of m - y^3 from 2^-40 to 2^-56 are
// computed, since those above are all zeros or all ones; 1 / (3 y^2) is the slope in the core's record. The
// result is multiplied by the cube root of 2^(e mod 3) and shifted into place.
//
// Error in ulp for the largest results: the truncated slope 0.06, the rounding 0.5.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "cubic_64.inc"
#include "exp_64.inc"

#define half_roots fixedpoint_cbrt_64_table + 256 * 13

// u is r21:r18, r26, the lowest byte first: byte i of it.
    .macro with_byte_of_u operation, i, other
    .if \i == 0
    \operation \other, r26
    .else
    \operation \other, 17 + \i
    .endif
    .endm
// Adds a product of bytes of u to r15:r8 in column `column`.
    .macro product_of_u i, j, column
    with_byte_of_u mov, \i, r25
    with_byte_of_u mul, \j, r25
    add 8 + \column, r0
    adc 9 + \column, r1
    .set byte, 10 + \column
    .rept 6 - \column
    adc byte, zero
    .set byte, byte + 1
    .endr
    .endm
// Byte i of the square and byte 5 + column - i of u to the cube.
    .macro product_of_square i, column
    with_byte_of_u mul, 5 + \column - \i, 8 + \i
    .if \column == 0
    add r22, r0
    adc r25, r1
    adc r27, zero
    adc r29, zero
    .elseif \column == 1
    add r25, r0
    adc r27, r1
    adc r29, zero
    .elseif \column == 2
    add r27, r0
    adc r29, r1
    .else
    add r29, r0
    .endif
    .endm
    .macro add_twice_u
    .rept 2
    add r11, r26
    adc_bytes r12, r18, 4
    .endr
    .endm

    FUNCTION fixedpoint_cbrt_q32_32
    or_bytes r0, r18, 8
    brne 1f
    ret
1:  bst r25, 7
    brtc 1f
    negate_bytes r18, 8
1:  push_all r8, r9, r10, r11, r12, r13, r14, r15, r16, r17, r28, r29
    clr zero
    ldi r28, 64
    drop_leading_one r28
    push_all r19, r20, r21
    mov r30, r25
    mov_from_top r22, r21, 4
    find_record_64 fixedpoint_cbrt_64_table, r26
    XCALL fixedpoint_cubic_64
    // r24:r23 = 2^15 / (3 y^2), which follows the record
    sbiw r30, 10
    lpm r22, Z
    mul r22, r25
    lsl r0
    rol r1
    adiw r30, 3
    lpm r23, Z+
    lpm r24, Z
    sub r23, r1
    sbc r24, zero
    // u = (y - 1) 2^40, r15:r8 = the square of 2^40 + u from byte 2 on, less 2^80
    lsl r26
    rol_bytes r18, 4
    clr r8
    clr r9
    movw_each r10, r8, 6
    product_of_u 0, 2, 0
    product_of_u 0, 3, 1
    product_of_u 1, 2, 1
    product_of_u 0, 4, 2
    product_of_u 1, 3, 2
    product_of_u 1, 4, 3
    product_of_u 2, 3, 3
    product_of_u 2, 4, 4
    product_of_u 3, 4, 5
    lsl_bytes r8, 8
    product_of_u 1, 1, 0
    product_of_u 2, 2, 2
    product_of_u 3, 3, 4
    mul_add r21, r21, r14, r15
    add_twice_u
    // r29, r27, r25 = bytes 10 to 8 of the cube
    mov r22, r8
    mov r25, r9
    mov r27, r10
    mov r29, r11
    add r29, r26
    .irp i, 1, 2, 3, 4, 5
    product_of_square \i, 0
    .endr
    .irp i, 2, 3, 4, 5, 6
    product_of_square \i, 1
    .endr
    .irp i, 3, 4, 5, 6, 7
    product_of_square \i, 2
    .endr
    .irp i, 4, 5, 6, 7
    product_of_square \i, 3
    .endr
    // r22, r9, r8 = m - y^3 2^56, of 24 bits; r15:r13 = it times 2^15 / (3 y^2)
    pop_all r22, r9, r8
    sub r8, r25
    sbc r9, r27
    sbc r22, r29
    clr_bytes r13, 3
    mul r8, r23
    mov r12, r1
    mul_add r8, r24, r12, r13
    mul_add r9, r23, r12, r13, zero, r14
    mul_add r9, r24, r13, r14
    mul_add r22, r23, r13, r14, zero, r15
    mul_add r22, r24, r14, r15
    cpi r22, 0x40
    brlo 1f
    sub r14, r23
    sbc r15, r24
1:  // r24:r18 = y 2^55
    lsr_bytes r18, 4
    ror r26
    mov_from_top r21, r18, 4
    mov r20, r26
    ori r24, 0x80
    mov r18, r13
    mov r19, r14
    mov r25, r15
    lsl r25
    sbc r25, r25
    add r20, r15
    adc_each r21, r25, 4
    // r15 = floor(r28 / 3), r28 the rest
    ldi r30, 171
    mul r28, r30
    mov r15, r1
    lsr r15
    sub r28, r15
    sub r28, r15
    sub r28, r15
    find half_roots, r28, 7
    load 8, 7
    fraction_product 24, 14, 7, 25
    ldi r24, 32
    sub r24, r15
1:  cpi r24, 8
    brlo 2f
    mov_bytes r25, r26, 6
    clr r31
    subi r24, 8
    rjmp 1b
2:  lsr_bytes r25, 7
    dec r24
    brpl 2b
    mov_bytes r18, r25, 6
    clr r24
    clr r25
    adc_each r18, zero, 6
    brtc 3f
    negate_bytes r18, 8
3:  clr r1
    pop_all r29, r28, r17, r16, r15, r14, r13, r12, r11, r10, r9, r8
    ret
    ENDFUNC fixedpoint_cbrt_q32_32
#endif
