// SPDX-License-Identifier: MIT
// int64_t fixedpoint_exp_q32_32(int64_t a)
// e^a within 0.65 ulp; saturated to the largest number.
//
// Not C functions, but entries for other functions of powers:
// fixedpoint_unrounded_exp_q32_32  r25:r18, r26 = e^a in units of 2^-40, rounded downward. Requires
//                                  T = 1 and a in [-23, 32 ln 2); T is kept.
// fixedpoint_power_of_rest_q32_32  2^k e^-r. Requires r8..r17, r28, r29 and k + 41 pushed in that
//                                  order, r in r16:r8, r17 = 0, T = 0.
//
// In       a = r25:r18
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    13 bytes
// Table    4451 bytes, fixedpoint_exp_64_table
//
// Argument reduction: a = k ln 2 - r with 0 <= r < 0.779. k + 41 comes from the upper bytes of a,
// with 185/128 = 1.4453 for 1/ln 2 and a constant that covers the error of that; r has 72 bits. The
// first byte of r looks up e^-i/256, the second f = 1 - e^-i/65536; for the rest t, below 2^-16,
// q = 1 - e^-t = t - (t^2 - t^3/3)/2 up to t^4/24. Then e^-r = e^-i/256 (1 - (f + q - f q)), which
// is shifted into place by less than a byte, by a product with a power of 2, and by whole bytes.
// Products are formed column by column; of the columns below the result only the upper bytes of the
// next one are included.
//
// Error in units of 2^-72, where an ulp of the largest results is at least 256 units: t^4/24 11,
// the square of t 5, its cube 2, the products 11 and, with the opposite sign, 15, the tables 2.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define zero r17
#include "exp_64.inc"
#define fine fixedpoint_exp_64_table
#define coarse fixedpoint_exp_64_table + 0x800

    SECTION fixedpoint_exp_q32_32
.Lbeyond:
    sbrc r25, 7
    rjmp .Lnothing
.Llargest:
    ldi r18, 0xff
    ldi r19, 0xff
    movw r20, r18
    movw r22, r18
    ldi r24, 0xff
    ldi r25, 0x7f
    ret
.Lnothing:
    ldi r18, 0
    ldi r19, 0
    movw_each r20, r18, 6
    ret

    ENTRY fixedpoint_exp_q32_32
    mov r26, r22
    lsl r26
    sbc r26, r26
    cp_each r23, r26, 3
    brne .Lbeyond
    cpi r22, -23
    brlt .Lnothing
    // 31 ln 2
    cpi r18, 0x03
    ldi r26, 0xe7
    cpc r19, r26
    ldi r26, 0xd0
    cpc r20, r26
    ldi r26, 0x7c
    cpc r21, r26
    ldi r26, 0x15
    cpc r22, r26
    brge .Llargest
    clt
    ENTRY fixedpoint_unrounded_exp_q32_32
    push_all r8, r9, r10, r11, r12, r13, r14, r15, r16, r17, r28, r29
    clr zero
    multiple_of_ln2 r22, r21, r27
    sub_bytes r13, r18, 4
    ENTRY fixedpoint_power_of_rest_q32_32
    // r14:r8 = t 2^72, r30:r26 = t^2 2^72
    fraction_product 14, 14, 5
    // Minus t^3/3, where r20:r18 is three times that
    fraction_product 30, 14, 3, 18
    ldi r21, 0x55
    mul r20, r21
    mov r23, r0
    mov r24, r0
    mov r25, r1
    add r23, r1
    adc r24, r1
    adc r25, zero
    mul_add r19, r21, r23, r24, zero, r25
    add r23, r1
    adc r24, zero
    adc r25, zero
    sub_bytes r26, r23, 3
    sbc r29, zero
    sbc r30, zero
    lsr_bytes r26, 5
    sub_bytes r8, r26, 5
    sbc r13, zero
    sbc r14, zero
    // f in r25:r18, f q in r31:r26, f + q - f q in r25:r18
    find fine, r15, 8
    load 18, 8
    fraction_product 25, 14, 6
    add_bytes r18, r8, 7
    adc r25, zero
    sub_bytes r18, r26, 6
    sbc r24, zero
    sbc r25, zero
    find coarse, r16, 9
    load 8, 9
    fraction_product 16, 25, 8
    sub_bytes r8, r26, 6
    sbc r14, r18
    sbc r15, r19
    sbc r16, zero
    // Shifted right by r31 + 1 bits, 7 to 73; r26 is the byte below r8
    clr r26
    pop r30
    ldi r31, 80
    sub r31, r30
    sbrs r31, 6
    rjmp 1f
    mov r26, r15
    mov r8, r16
    clr r9
    movw r10, r8
    clr r10
    movw r12, r10
    clr r12
    movw r14, r12
    clr r16
1:  sbrs r31, 5
    rjmp 1f
    mov r26, r11
    movw r8, r12
    movw r10, r14
    mov r12, r16
    clr_bytes r13, 4
1:  sbrs r31, 4
    rjmp 1f
    mov r26, r9
    movw_bytes r8, r10, 6
    mov r14, r16
    clr r15
    clr r16
1:  sbrs r31, 3
    rjmp 1f
    mov r26, r8
    mov_bytes r8, r9, 8
    clr r16
1:  ldi r30, 128
    sbrc r31, 1
    ldi r30, 32
    sbrc r31, 0
    lsr r30
    sbrc r31, 2
    swap r30
    mul r26, r30
    mov r26, r1
    mul r8, r30
    or r26, r0
    mov r18, r1
    mul r9, r30
    or r18, r0
    mov r19, r1
    mul r10, r30
    or r19, r0
    mov r20, r1
    mul r11, r30
    or r20, r0
    mov r21, r1
    mul r12, r30
    or r21, r0
    mov r22, r1
    mul r13, r30
    or r22, r0
    mov r23, r1
    mul r14, r30
    or r23, r0
    mov r24, r1
    mul r15, r30
    or r24, r0
    mov r25, r1
    mul r16, r30
    or r25, r0
    brts 1f
    lsl r26
    adc_each r18, zero, 8
1:  clr r1
    pop_all r29, r28, r17, r16, r15, r14, r13, r12, r11, r10, r9, r8
    ret
    ENDFUNC fixedpoint_exp_q32_32
#endif
