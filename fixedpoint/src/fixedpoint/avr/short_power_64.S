// SPDX-License-Identifier: MIT
// uint64_t fixedpoint_short_power_64(uint64_t a, uint16_t n, int8_t exponent, bool reciprocal)
// x^n or its reciprocal for x = a 2^(exponent - 64), in units of 2^(exponent - 64), rounded to
// nearest and saturated to 2^64 - 1. Requires exponent in 0..64, 0 < a <= 2^63 and n > 0.
//
// In:       a r25..r18, n r17:r16, exponent r14, reciprocal r12
// Out:      r25..r18
// Clobbers: r0, r26, r27, r30, r31
// Stack:    30 bytes, and those of fixedpoint_divide_q32_32.
//
// The mantissa has 88 bits, the highest set. Square and multiply from the first binary digit of n
// on: a square for each digit, and a product with x for each 1. A sentinel 1 after the last digit
// marks the end. If digits remain and the power is at least 2^63 or below 2^-64, the result is out
// of range in every format.
//
// The product is formed column by column: byte k is the sum of all a_i b_j with i + j = k and the
// carry of the previous column. The first ten columns are omitted, and each column replaces a byte
// that is no longer needed. x is kept on the stack; its 64 bits are bytes 3 to 10 of the mantissa.
//
// The reciprocal of the mantissa m, as digits 2^63 / m, starts from y = 2^39 / m, a quotient of 40
// bits. With e = m y - 2^39, which is between -1 and 1, it is 2^24 y - y e / 2^15. The omitted
// parts of the products, less than 10 units of y e, where a digit has 2^15, are less than the
// initial value of y e, so the digits are never too large.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define zero r2
#define behind r3       // byte 10 of a product, the first below the mantissa
#define exponent r5
#define exponent_of_x r6
#define a0 r7
#define a1 r8
#define a2 r9
#define a3 r10
#define a4 r11
#define a5 r12
#define a6 r13
#define a7 r14
#define a8 r15
#define a9 r16
#define a10 r17
#define SPL 0x3d
#define SPH 0x3e

    .macro product p, q, low, high, carry
    mul_add \p, \q, \low, \high, zero, \carry
    .endm

    // The first `count` products in column `place`, from byte `first` of the number in r(p) on.
    .macro column place, first, count, p, q, low, high, carry
    clr \carry
    .set byte, \first
    .rept \count
    product \p+byte, \q+\place-byte, \low, \high, \carry
    .set byte, byte + 1
    .endr
    .endm

    SECTION fixedpoint_short_power_64

    // a = a x, normalised, with x in r25..r18 as bytes 10 to 3.
.Lproduct:
    ldd_bytes r18, Y + 1, 8
    clr behind
    clr r4
    column 10, 0, 8, 7, 15, behind, r4, r26
    column 11, 1, 8, 7, 15, r4, r26, a0
    column 12, 2, 8, 7, 15, r26, a0, a1
    column 13, 3, 8, 7, 15, a0, a1, a2
    column 14, 4, 7, 7, 15, a1, a2, a3
    column 15, 5, 6, 7, 15, a2, a3, a4
    column 16, 6, 5, 7, 15, a3, a4, a5
    column 17, 7, 4, 7, 15, a4, a5, a6
    column 18, 8, 3, 7, 15, a5, a6, a7
    column 19, 9, 2, 7, 15, a6, a7, a8
    mul_add a10, r25, a7, a8
    movw_from_top a3, a1, 8
    mov a2, a0
    mov a1, r26
    mov a0, r4
.Lnormalise:
    tst a10
    brmi 1f
    dec exponent
    lsl behind
    rol_bytes a0, 11
1:  ret

    // a = a a, normalised: twice the products of different bytes, and the squares of bytes.
.Lsquare:
    clr behind
    clr r4
    column 10, 0, 5, 7, 7, behind, r4, r18
    column 11, 1, 5, 7, 7, r4, r18, r19
    column 12, 2, 4, 7, 7, r18, r19, r20
    column 13, 3, 4, 7, 7, r19, r20, r21
    column 14, 4, 3, 7, 7, r20, r21, r22
    column 15, 5, 3, 7, 7, r21, r22, r23
    column 16, 6, 2, 7, 7, r22, r23, r24
    column 17, 7, 2, 7, 7, r23, r24, r25
    column 18, 8, 1, 7, 7, r24, r25, r26
    column 19, 9, 1, 7, 7, r25, r26, r27
    mul a5, a5
    movw a1, r0
    mul a6, a6
    movw a3, r0
    mul a7, a7
    movw a5, r0
    mul a8, a8
    movw a7, r0
    mul a9, a9
    mov a0, r0
    mov zero, r1
    mul a10, a10
    lsl behind
    rol r4
    rol_bytes r18, 10
    add behind, a1
    adc r4, a2
    adc_bytes r18, a3, 6
    adc r24, a0
    adc r25, zero
    adc r26, r0
    adc r27, r1
    clr zero
    mov a0, r4
    movw_bytes a1, r18, 10
    lsl exponent
    rjmp .Lnormalise

    // Leaves if the power is out of range in every format.
    .macro stop_beyond
    mov r18, exponent
    subi r18, -63
    cpi r18, 127
    brlo 1f
    rjmp .Lstop
1:
    .endm

    ENTRY fixedpoint_short_power_64
    push_all r2, r3, r4, r5, r6, r7, r8, r9, r10, r11, r12, r13, r14, r15, r16, r17, r28, r29, r12, r14
    movw r30, r16
    mov r26, r14
    clr zero
    rjmp 2f
1:  mov_from_top r19, r18, 7
    clr r18
    subi r26, 8
2:  tst r25
    breq 1b
    brmi 4f
3:  dec r26
    lsl_bytes r18, 8
    brpl 3b
4:  mov exponent, r26
    mov exponent_of_x, r26
    clr_bytes a0, 3
    movw_bytes a3, r18, 8
    push_all r25, r24, r23, r22, r21, r20, r19, r18
    in r28, SPL
    in r29, SPH

    // The leading digit is shifted out.
    sec
    rol r30
    rol r31
    brcs .Ldigit
    brne 5f
    mov r31, r30
    clr r30
5:  lsl r30
    rol r31
    brcc 5b

.Ldigit:
    bst r31, 7
    lsl r30
    rol r31
    mov r0, r30
    or r0, r31
    breq .Ldone
    stop_beyond
    rcall .Lsquare
    brtc .Ldigit
    stop_beyond
    add exponent, exponent_of_x
    rcall .Lproduct
    rjmp .Ldigit

.Lstop:
    ldd r26, Y+10
    sbrc exponent, 7
    subi r26, -1
    clr r1
    sbrc r26, 0
    rjmp .Lzero
    rjmp .Lbeyond

.Ldone:
    clr r1
    ldd r26, Y+9
    ldd r27, Y+10
    tst r27
    brne .Lreciprocal
    movw_bytes r18, a3, 8
    sub r26, exponent
    brvs 1f
    rjmp .Lround
1:  rjmp .Lzero

.Lreciprocal:
    dec r26
    add exponent, r26
    brvc 1f
    rjmp .Lzero
    // Byte i of m, from the first one on, is r(5 + i): so the highest six are the divisor.
1:  mov r6, a1
    mov r7, a2
    movw_bytes r8, a3, 8
    clr_bytes r16, 4
    movw r20, r18
    movw r22, r18
    ldi r24, 0x80
    clr r25
    XCALL fixedpoint_divide_q32_32
    sbrs r23, 0
    rjmp 1f
    ldi r18, 0xff
    ldi r19, 0xff
    movw r20, r18
    mov r22, r18
    // e, its integer in r17 and its fraction in r16, r31, r30, r27, r26
1:  clr r24
    clr r26
    column 5, 1, 5, 5, 18, r24, r26, r27
    column 6, 2, 5, 5, 18, r26, r27, r30
    column 7, 3, 5, 5, 18, r27, r30, r31
    column 8, 4, 5, 5, 18, r30, r31, r16
    column 9, 5, 5, 5, 18, r31, r16, r17
    column 10, 6, 5, 5, 18, r16, r17, r6
    mul r12, r22
    add r17, r0
    mul r13, r21
    add r17, r0
    mul r14, r20
    add r17, r0
    mul r15, r19
    add r17, r0
    // r13..r8 = y e, and the byte below it
    ldi r24, 16
    clr r7
    mov r8, r24
    clr r9
    product r16, r18, r7, r8, r9
    product r31, r19, r7, r8, r9
    product r30, r20, r7, r8, r9
    product r27, r21, r7, r8, r9
    product r26, r22, r7, r8, r9
    clr r10
    product r16, r19, r8, r9, r10
    product r31, r20, r8, r9, r10
    product r30, r21, r8, r9, r10
    product r27, r22, r8, r9, r10
    clr r11
    product r16, r20, r9, r10, r11
    product r31, r21, r9, r10, r11
    product r30, r22, r9, r10, r11
    clr r12
    product r16, r21, r10, r11, r12
    product r31, r22, r10, r11, r12
    clr r13
    product r16, r22, r11, r12, r13
    sbrs r17, 0
    rjmp 2f
    sub_bytes r8, r18, 5
    sbc r13, zero
    // r25..r18 = (2^40 y - 2 y e) / 2^16
2:  lsl_bytes r7, 7
    clr r14
    sbrc r13, 7
    com r14
    mov_from_top r21, r18, 5
    clr_bytes r18, 3
    cp zero, r7
    cpc zero, r8
    cpc zero, r9
    sbc_bytes r18, r10, 5
    sbc_each r23, r14, 3
    mov r26, exponent
    clr r1
    rjmp .Lround

.Lzero:
    clr r18
    rjmp 1f
.Lbeyond:
    ldi r18, 0xff
1:  mov r19, r18
    movw_each r20, r18, 6
    rjmp .Lreturn

    // r25..r18 / 2^r26
.Lround:
    tst r26
    brmi .Lbeyond
    breq .Lreturn
    cpi r26, 65
    brsh .Lzero
    dec r26
    rjmp 2f
1:  mov_bytes r18, r19, 7
    clr r25
2:  subi r26, 8
    brcc 1b
    subi r26, -8
    breq 4f
3:  lsr_bytes r18, 8
    dec r26
    brne 3b
4:  lsr_bytes r18, 8
    adc_each r18, r1, 8
.Lreturn:
    .rept 10
    pop r0
    .endr
    pop_all r29, r28, r17, r16, r15, r14, r13, r12, r11, r10, r9, r8, r7, r6, r5, r4, r3, r2
    ret
    ENDFUNC fixedpoint_short_power_64

#endif
