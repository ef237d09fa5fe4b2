// SPDX-License-Identifier: MIT
// uint64_t fixedpoint_short_power_64(uint64_t a, uint16_t n, int8_t exponent, bool reciprocal)
// x^n or its reciprocal of x = a 2^(exponent - 64), in units of 2^(exponent - 64), rounded to
// nearest; 2^64 - 1 where it is more. Needs exponent from 0 to 64, 0 < a <= 2^63 and n > 0.
//
// In:       a r25..r18, n r17:r16, exponent r14, reciprocal r12
// Out:      r25..r18
// Clobbers: r0, r26, r27, r30, r31
// Stack:    30 bytes, and those of fixedpoint_divide_q32_32.
//
// The mantissa has 88 bits, the highest set. The digits of n are taken from the first on: a square
// for each, and one product with x for a 1. A 1 behind the last digit tells the end. Where digits
// are left of a power from 2^63 on or below 2^-64, all of it is beyond every format.
//
// The product goes column by column: byte k is the sum of all a_i b_j with i + j = k and what the
// column before left over. The first ten columns are left out, and each column takes the place of
// what is used up. x waits on the stack; its 64 bits are bytes 3 to 10 of the mantissa.
//
// The reciprocal of the mantissa m, as digits 2^63 / m, begins with y = 2^39 / m, a quotient of 40
// bits. With e = m y - 2^39, which is above -1 and below 1, it is 2^24 y - y e / 2^15. All that is left
// out of the products, less than 10 of a y e of which a digit has 2^15, is less than what y e begins
// with, so that the digits are never too large.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define zero r2
#define behind r3       // byte 10 of a product, the one behind the mantissa
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
    mul \p, \q
    add \low, r0
    adc \high, r1
    adc \carry, zero
    .endm

    // The first `count` products of byte `place`, from byte `first` of the number in r(p) on.
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
    ldd r18, Y+1
    ldd r19, Y+2
    ldd r20, Y+3
    ldd r21, Y+4
    ldd r22, Y+5
    ldd r23, Y+6
    ldd r24, Y+7
    ldd r25, Y+8
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
    mul a10, r25
    add a7, r0
    adc a8, r1
    movw a9, a7
    movw a7, a5
    movw a5, a3
    movw a3, a1
    mov a2, a0
    mov a1, r26
    mov a0, r4
.Lnormalise:
    tst a10
    brmi 1f
    dec exponent
    lsl behind
    rol a0
    rol a1
    rol a2
    rol a3
    rol a4
    rol a5
    rol a6
    rol a7
    rol a8
    rol a9
    rol a10
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
    rol r18
    rol r19
    rol r20
    rol r21
    rol r22
    rol r23
    rol r24
    rol r25
    rol r26
    rol r27
    add behind, a1
    adc r4, a2
    adc r18, a3
    adc r19, a4
    adc r20, a5
    adc r21, a6
    adc r22, a7
    adc r23, a8
    adc r24, a0
    adc r25, zero
    adc r26, r0
    adc r27, r1
    clr zero
    mov a0, r4
    movw a1, r18
    movw a3, r20
    movw a5, r22
    movw a7, r24
    movw a9, r26
    lsl exponent
    rjmp .Lnormalise

    // Leaves where the power is beyond every format.
    .macro stop_beyond
    mov r18, exponent
    subi r18, -63
    cpi r18, 127
    brlo 1f
    rjmp .Lstop
1:
    .endm

    ENTRY fixedpoint_short_power_64
    push r2
    push r3
    push r4
    push r5
    push r6
    push r7
    push r8
    push r9
    push r10
    push r11
    push r12
    push r13
    push r14
    push r15
    push r16
    push r17
    push r28
    push r29
    push r12
    push r14
    movw r30, r16
    mov r26, r14
    clr zero
    rjmp 2f
1:  mov r25, r24
    mov r24, r23
    mov r23, r22
    mov r22, r21
    mov r21, r20
    mov r20, r19
    mov r19, r18
    clr r18
    subi r26, 8
2:  tst r25
    breq 1b
    brmi 4f
3:  dec r26
    lsl r18
    rol r19
    rol r20
    rol r21
    rol r22
    rol r23
    rol r24
    rol r25
    brpl 3b
4:  mov exponent, r26
    mov exponent_of_x, r26
    clr a0
    clr a1
    clr a2
    movw a3, r18
    movw a5, r20
    movw a7, r22
    movw a9, r24
    push r25
    push r24
    push r23
    push r22
    push r21
    push r20
    push r19
    push r18
    in r28, SPL
    in r29, SPH

    // The leading digit moves out.
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
    movw r18, a3
    movw r20, a5
    movw r22, a7
    movw r24, a9
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
    movw r8, a3
    movw r10, a5
    movw r12, a7
    movw r14, a9
    clr r16
    clr r17
    clr r18
    clr r19
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
    // r13..r8 = y e, and a byte behind it
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
    sub r8, r18
    sbc r9, r19
    sbc r10, r20
    sbc r11, r21
    sbc r12, r22
    sbc r13, zero
    // r25..r18 = (2^40 y - 2 y e) / 2^16
2:  lsl r7
    rol r8
    rol r9
    rol r10
    rol r11
    rol r12
    rol r13
    clr r14
    sbrc r13, 7
    com r14
    mov r25, r22
    mov r24, r21
    mov r23, r20
    mov r22, r19
    mov r21, r18
    clr r18
    clr r19
    clr r20
    cp zero, r7
    cpc zero, r8
    cpc zero, r9
    sbc r18, r10
    sbc r19, r11
    sbc r20, r12
    sbc r21, r13
    sbc r22, r14
    sbc r23, r14
    sbc r24, r14
    sbc r25, r14
    mov r26, exponent
    clr r1
    rjmp .Lround

.Lzero:
    clr r18
    rjmp 1f
.Lbeyond:
    ldi r18, 0xff
1:  mov r19, r18
    movw r20, r18
    movw r22, r18
    movw r24, r18
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
1:  mov r18, r19
    mov r19, r20
    mov r20, r21
    mov r21, r22
    mov r22, r23
    mov r23, r24
    mov r24, r25
    clr r25
2:  subi r26, 8
    brcc 1b
    subi r26, -8
    breq 4f
3:  lsr r25
    ror r24
    ror r23
    ror r22
    ror r21
    ror r20
    ror r19
    ror r18
    dec r26
    brne 3b
4:  lsr r25
    ror r24
    ror r23
    ror r22
    ror r21
    ror r20
    ror r19
    ror r18
    adc r18, r1
    adc r19, r1
    adc r20, r1
    adc r21, r1
    adc r22, r1
    adc r23, r1
    adc r24, r1
    adc r25, r1
.Lreturn:
    .rept 10
    pop r0
    .endr
    pop r29
    pop r28
    pop r17
    pop r16
    pop r15
    pop r14
    pop r13
    pop r12
    pop r11
    pop r10
    pop r9
    pop r8
    pop r7
    pop r6
    pop r5
    pop r4
    pop r3
    pop r2
    ret
    ENDFUNC fixedpoint_short_power_64

#endif
