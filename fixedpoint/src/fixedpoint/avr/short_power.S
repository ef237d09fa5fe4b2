// SPDX-License-Identifier: MIT
// uint32_t fixedpoint_short_power(uint32_t a, uint16_t n, int8_t exponent, bool reciprocal)
// x^n or its reciprocal for x = a 2^(exponent - 32), in units of 2^(exponent - 32), rounded to
// nearest and saturated to 2^32 - 1. Requires exponent in 0..32, a > 0 and 0 < n < 2^15.
//
// In:       a r25..r22, n r21:r20, exponent r18, reciprocal r16
// Out:      r25..r22
// Clobbers: r0, r18..r21, r26, r27, r30, r31
// Stack:    16 bytes, and those of fixedpoint_divide_q32_32.
//
// The mantissa has 48 bits, the highest set. Square and multiply from the first binary digit of n
// on: a square for each digit, and a product with x for each 1. A sentinel 1 after the last digit
// marks the end. From 2^46 on and below 2^-47, which is out of range in every format, the power is
// left as it is. The reciprocal is that of the mantissa as a number of Q32.32, a quotient of 39
// bits.
//
// The product is formed column by column: byte k is the sum of all a_i b_j with i + j = k and the
// carry of the previous column. The first four columns are omitted, and each column replaces a byte
// that is no longer needed.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define a0 r20
#define a1 r21
#define a2 r22
#define a3 r23
#define a4 r24
#define a5 r25
#define b0 r12
#define b1 r13
#define b2 r14
#define b4 r16
#define b5 r17
#define zero r27
#define exponent r10
#define exponent_of_x r11

    // The products of byte i of a and byte k - i of another number, for i = first..last.
    .macro column other, k, first, last, low, high, carry
    rising \first, (\last + 1), mul_add, .Lr20 + \n, .L\other + \k - \n, \low, \high, zero, \carry
    .endm

    SECTION fixedpoint_short_power

    // a = a b, normalised.
.Lproduct:
    // byte 4
    mul a0, b4
    movw r18, r0
    clr r26
    column b0, 4, 1, 4, r18, r19, r26
    // byte 5
    clr r18
    column b0, 5, 0, 5, r19, r26, r18
    // byte 6
    clr r20
    column b0, 6, 1, 5, r26, r18, r20
    // byte 7
    clr r21
    column b0, 7, 2, 5, r18, r20, r21
    // byte 8
    clr r22
    column b0, 8, 3, 5, r20, r21, r22
    // byte 9
    clr r23
    column b0, 9, 4, 5, r21, r22, r23
    // bytes 10 and 11
    mul_add a5, b5, r22, r23
    movw a4, r22
    movw a2, r20
    mov a1, r18
    mov a0, r26
.Lnormalise:
    tst a5
    brmi 1f
    dec exponent
    lsl r19
    rol_bytes a0, 6
1:  ret

    // a = a a, normalised: twice the products of different bytes, from byte 4 in r12 on, and the
    // squares of bytes.
.Lsquare:
    mul a0, a4
    movw r12, r0
    clr r14
    mul_add a1, a3, r12, r13, zero, r14
    clr r15
    column a0, 5, 0, 2, r13, r14, r15
    clr r16
    column a0, 6, 1, 2, r14, r15, r16
    clr r17
    column a0, 7, 2, 3, r15, r16, r17
    clr r18
    mul_add a3, a5, r16, r17, zero, r18
    clr r19
    mul_add a4, a5, r17, r18, zero, r19
    lsl_bytes r12, 8
    mul a2, a2
    movw a0, r0
    mul a3, a3
    movw a2, r0
    mul a4, a4
    movw r26, r0
    mul a5, a5
    add_bytes r12, a0, 4
    adc r16, r26
    adc r17, r27
    adc r18, r0
    adc r19, r1
    clr zero
    movw_from_top a0, r14, 6
    mov r19, r13
    lsl exponent
    rjmp .Lnormalise

    // C = 0 if the power is out of range in every format.
    .macro compare_with_limit
    mov r18, exponent
    subi r18, -46
    cpi r18, 93
    .endm

    ENTRY fixedpoint_short_power
    push_all r8, r9, r10, r11, r12, r13, r14, r15, r16, r17, r28, r29, r18, r16
    movw r30, r20
    clr a0
    clr a1
    clr zero
    rjmp 2f
1:  mov_from_top a3, a2, 3
    clr a2
    subi r18, 8
2:  tst a5
    breq 1b
    brmi 4f
3:  dec r18
    lsl_bytes a2, 4
    brpl 3b
4:  mov exponent, r18
    mov exponent_of_x, r18
    movw r8, a2
    movw r28, a4

    // The leading digit is shifted out.
    sec
    rol r30
    rol r31
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
    compare_with_limit
    brsh .Ldone
    rcall .Lsquare
    brtc .Ldigit
    compare_with_limit
    brsh .Ldone
    clr b0
    clr b1
    movw b2, r8
    movw b4, r28
    add exponent, exponent_of_x
    rcall .Lproduct
    rjmp .Ldigit

.Ldone:
    clr r1
    pop r26
    pop r18
    tst r26
    brne .Lreciprocal
    sub r18, exponent
    rjmp .Lround

.Lreciprocal:
    dec r18
    add r18, exponent
    mov r28, r18
    clr r10
    mov_bytes r11, a0, 6
    clr_bytes r17, 3
    movw r20, r18
    movw r22, r18
    clr r24
    ldi r25, 0x40
    XCALL fixedpoint_divide_q32_32
    lsl_bytes r18, 5
    mov_from_top a2, r19, 4
    mov r18, r28
    brcc .Lround
    ldi a2, 0xff
    ldi a3, 0xff
    movw a4, a2

    // a5..a2 / 2^r18
.Lround:
    tst r18
    brmi .Lbeyond
    breq .Lreturn
    cpi r18, 33
    brsh .Lzero
    dec r18
    rjmp 2f
1:  mov_bytes a2, a3, 3
    clr a5
2:  subi r18, 8
    brcc 1b
    subi r18, -8
    breq 4f
3:  lsr_bytes a2, 4
    dec r18
    brne 3b
4:  lsr_bytes a2, 4
    adc_each a2, r1, 4
.Lreturn:
    pop_all r29, r28, r17, r16, r15, r14, r13, r12, r11, r10, r9, r8
    ret

.Lzero:
    clr a2
    clr a3
    movw a4, a2
    rjmp .Lreturn
.Lbeyond:
    ldi a2, 0xff
    ldi a3, 0xff
    movw a4, a2
    rjmp .Lreturn
    ENDFUNC fixedpoint_short_power

#endif
