// SPDX-License-Identifier: MIT
// int64_t fixedpoint_tan_of_rest(int64_t x, uint8_t inverse)
// The tangent of x 2^-56 in Q32.32 or, if `inverse` = 1, its cotangent, within 0.66 ulp. x must be at
// most 201.5 2^48, which is above pi/4, and for the cotangent at least 48 2^48, 3/16.
//
// In       x = r25:r18, inverse = r16
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    35 bytes
// Tables   1212 bytes, fixedpoint_tangent_64_table; those of divide_q32_32.S
//
// With A the multiple of 2^-8 nearest to x and t = x - A, |t| <= 2^-9, the tangent is N / D, N = tan A
// + tan t, D = 1 - tan A tan t. tan t = t + t^3 / 3: the upper 16 bits of t are enough for the cube,
// and the next term is below 2^-47.
//
// Error in units of 2^-40: N 0.5; D 3.5: 2 for the omitted parts of its product, 1 for those of
// tan t. The quotient of the tangent is 4.1 off, and a cotangent c c (3.5 + 0.5 c), 33 for 16/3, of
// 256 units in an ulp; and half an ulp for the rounding.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define zero r25
// t, from its sign on, and its upper 16 bits
#define sign r18
#define t0 r19
#define t1 r20
#define t2 r21
#define t3 r22
#define t4 r23
// tan A, later N
#define a0 r10
#define a1 r11
#define a2 r12
#define a3 r13
#define a4 r14
#define a5 r15
#define square0 r16
#define square1 r17
#define third0 r0
#define third1 r26
#define third2 r27
#define third3 r30
// tan A tan t in units of 2^-40, and the byte below
#define below r24
#define fall0 r26
#define fall1 r27
#define fall2 r30
#define fall3 r31

    FUNCTION fixedpoint_tan_of_rest
    push_all r10, r11, r12, r13, r14, r15, r16, r17
    bst r16, 0
    sbrc t4, 7
    inc r24             // A
    muls t4, t4
    movw square0, r0
    mul t3, t3
    movw r26, r0
    mulsu t4, t3
    lsl r0
    rol r1
    sbc square1, zero
    add r27, r0
    adc square0, r1
    adc square1, zero
    subi r27, 0x80
    sbci square0, 0xff
    sbci square1, 0xff
    mulsu t4, square1
    movw r30, r0
    mul t3, square0
    movw r26, r0
    mulsu t4, square0
    sbc r31, zero
    add r27, r0
    adc r30, r1
    adc r31, zero
    mul_add t3, square1, r27, r30, zero, r31
    subi r27, 0x80
    sbci r30, 0xff
    sbci r31, 0xff
    // The cube r31:r30 times 0x5555 = 0x55 * 257
    mov r17, r31
    ldi r16, 0x55
    mulsu r17, r16
    movw r26, r0
    mul r30, r16
    add r26, r1
    adc r27, zero
    mov third3, r27
    lsl third3
    sbc third3, third3
    add third0, r26
    adc third1, r27
    adc third2, third3
    mov sign, t4
    lsl sign
    sbc sign, sign
    add t0, third0
    adc t1, third1
    adc t2, third2
    adc t3, third3
    adc t4, third3
    ldi r30, 6
    mul r24, r30
    movw r30, r0
    subi r30, lo8(-(fixedpoint_tangent_64_table))
    sbci r31, hi8(-(fixedpoint_tangent_64_table))
    lpm_each a0, Z+, 6
    // Half a unit, and 1 for the products below byte 3
    ldi below, 0x80
    ldi fall0, 1
    clr fall1
    clr fall2
    clr fall3
    mul_add a5, t1, below, fall0, zero, fall1
    mul_add a4, t2, below, fall0, zero, fall1
    mul_add a3, t3, below, fall0, zero, fall1
    mul_add a2, t4, below, fall0, zero, fall1
    mul_add a5, t2, fall0, fall1, zero, fall2
    mul_add a4, t3, fall0, fall1, zero, fall2
    mul_add a3, t4, fall0, fall1, zero, fall2
    mul_add a5, t3, fall1, fall2, zero, fall3
    mul_add a4, t4, fall1, fall2, zero, fall3
    mul_add a5, t4, fall2, fall3
    // t has been multiplied as an unsigned number.
    sbrs sign, 0
    rjmp 1f
    sub fall0, a2
    sbc fall1, a3
    sbc fall2, a4
    sbc fall3, a5
1:  mov r16, fall3
    lsl r16
    sbc r16, r16
    add a0, t0
    adc a1, t1
    adc a2, t2
    adc a3, t3
    adc a4, t4
    adc a5, sign
    clr_bytes r18, 5
    sub r19, fall0
    sbc r20, fall1
    sbc r21, fall2
    sbc r22, fall3
    ldi r23, 0
    sbc r23, r16
    ldi r24, 1
    sbc r24, r16
    clr r1
    ldi r16, 0
    ldi r17, 0
    brts 2f
    .irp n, 0, 2, 4, 6
    movw r26, 10 + \n
    movw 10 + \n, 18 + \n
    movw 18 + \n, r26
    .endr
2:  XCALL fixedpoint_divide_q32_32
    pop_all r17, r16, r15, r14, r13, r12, r11, r10
    ret
    ENDFUNC fixedpoint_tan_of_rest
#endif
