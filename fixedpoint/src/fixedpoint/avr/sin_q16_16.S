// SPDX-License-Identifier: MIT
// int32_t fixedpoint_sin_q16_16(int32_t angle)
// int32_t fixedpoint_cos_q16_16(int32_t angle)
// Sine and cosine of a Q16.16 angle in radians, for every input; within 0.67 ulp, in [-1, 1].
//
// void fixedpoint_sincos_q16_16(int32_t angle, int32_t* sine_and_cosine)
// Both, bit for bit as above: one reduction, two evaluations.
//
// In       angle = r25:r22; sine_and_cosine = r21:r20
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T unchanged; r1 is 0 again at return
// Cycles   call and ret included; cos takes 2 more than sin. Quadrants 0..3 of the angle:
//              0 <= angle < 256       103 105 110 112
//              -256 <= angle < 0      108 110 115 117
//              angle >= 256           133 135 140 142
//              angle < -256           136 138 143 145
//          sincos: sin + 79 or + 80 ... by quadrant
//
// The angle times 2/pi, of which 40 bits count (a2f9836e4e / 2^40, 2^-44 too small), gives quarter
// turns: byte 7 of the product is the quadrant, byte 6 the interval of the table, bytes 5 and 4 the
// fraction of it. Odd quadrants run backwards (one's complement), quadrants 2 and 3 are negated.
// The multiplier's byte times the angle's top byte is needed only outside +-256 rad.
//
// Error in ulp: chord 0.154; the products below byte 4 are cut, less than 6 units of 2^-24 quarter
// turns, 0.036; three low bytes cut from the rise, 1.5 units of 2^-7 around the mean that is in the
// table, 0.012; table entries 0.004 + 0.004. Rounding 0.5.

#ifdef __AVR__

#define a0 r22
#define a1 r23
#define a2 r24
#define a3 r25
// 2/pi from its second byte on; m0 is loaded where it is needed.
#define M0 0x4e
#define M1 0x6e
#define M2 0x83
#define M3 0xf9
#define M4 0xa2
#define m1 r18
#define m2 r19
#define m3 r20
#define m4 r21
#define m0 r18
#define zero r18
// Bytes 4..7 of the product.
#define b4 r26
#define b5 r27
#define b6 r30
#define b7 r31
#define quadrant r19
#define slope0 r20
#define slope1 r21
#define value0 r31
#define value1 r22
#define value2 r23
#define rise0 r24
#define rise1 r25

    .section .text.fixedpoint_sin_q16_16, "ax", @progbits

    .global fixedpoint_sincos_q16_16
    .type fixedpoint_sincos_q16_16, @function
fixedpoint_sincos_q16_16:
    push r28
    push r29
    movw r28, r20
    rcall fixedpoint_sin_q16_16
    std Y+0, r22
    std Y+1, r23
    std Y+2, r24
    std Y+3, r25
    // A quarter turn further: the next quadrant runs the other way.
    com b4
    com b5
    com b6
    inc quadrant
    rcall .Levaluate
    std Y+4, r22
    std Y+5, r23
    std Y+6, r24
    std Y+7, r25
    pop r29
    pop r28
    ret
    .size fixedpoint_sincos_q16_16, .-fixedpoint_sincos_q16_16

    .global fixedpoint_cos_q16_16
    .type fixedpoint_cos_q16_16, @function
fixedpoint_cos_q16_16:
    ldi b7, 1
    rjmp .Lreduce
    .size fixedpoint_cos_q16_16, .-fixedpoint_cos_q16_16

    .global fixedpoint_sin_q16_16
    .type fixedpoint_sin_q16_16, @function
fixedpoint_sin_q16_16:
    ldi b7, 0
.Lreduce:
    ldi m1, M1
    ldi m2, M2
    ldi m3, M3
    ldi m4, M4
    mul a0, m4
    movw b4, r0
    mul a2, m1
    add b4, r1
    clr zero            // m1 is used up; carry stays
    adc b5, zero
    mul a0, m3
    add b4, r1
    adc b5, zero
    mul a1, m2
    add b4, r1
    adc b5, zero        // at most 0xa1 + 3
    mul a1, m3
    add b4, r0
    adc b5, r1
    clr b6
    adc b6, zero
    mul a2, m2
    add b4, r0
    adc b5, r1
    adc b6, zero
    mul a1, m4
    add b5, r0
    adc b6, r1          // at most 2 + 0xa1 + 1
    mul a2, m3
    add b5, r0
    adc b6, r1
    adc b7, zero
    mul a2, m4
    add b6, r0
    adc b7, r1
    tst a3
    breq .Lreduced
    cpi a3, 0xff
    brne .Lfar
    // The angle is its low 24 bits less 2^24.
    subi b4, M1
    sbci b5, M2
    sbci b6, M3
    sbci b7, M4
.Lreduced:
    mov quadrant, b7
    lsr b7
    brcc .Levaluate
    com b4
    com b5
    com b6
.Levaluate:
    ldi r31, hi8(fixedpoint_sine_table)
    lpm slope0, Z
    inc r31
    lpm slope1, Z
    inc r31
    lpm value1, Z
    inc r31
    lpm value2, Z
    inc r31
    lpm value0, Z
    mul slope1, b5
    movw rise0, r0
    mul slope1, b4
    add rise0, r1
    adc rise1, zero
    mul slope0, b5
    add rise0, r1
    clr r1
    adc rise1, r1
    add value0, rise0
    adc value1, rise1
    adc value2, r1
    lsl value0          // the unit is 2^-7 ulp: result = value2:value1, 2^16 in the carry
    rol value1
    rol value2
    ldi r25, 0
    ldi r24, 0
    adc r24, r24
    sbrs quadrant, 1
    ret
    com r24
    com r23
    neg r22
    sbci r23, 0xff
    sbci r24, 0xff
    sbc r25, r25
    ret

    // All of the angle's top byte, as if unsigned.
.Lfar:
    ldi m0, M0
    mul a3, m0
    mov m0, r1
    mul a3, m2
    movw a0, r0
    mul a3, m4
    add b4, m0
    adc b5, a0
    adc b6, a1
    adc b7, r0
    ldi m1, M1
    mul a3, m1
    movw a0, r0
    mul a3, m3
    add b4, a0
    adc b5, a1
    adc b6, r0
    adc b7, r1
    clr zero
    sbrs a3, 7
    rjmp .Lreduced
    subi b4, M0         // and 2^32 times 2/pi less where it is negative
    sbci b5, M1
    sbci b6, M2
    sbci b7, M3
    rjmp .Lreduced
    .size fixedpoint_sin_q16_16, .-fixedpoint_sin_q16_16
#endif
