// SPDX-License-Identifier: MIT
// int16_t fixedpoint_sin_q8_8(int16_t angle)
// int16_t fixedpoint_cos_q8_8(int16_t angle)
// void fixedpoint_sincos_q8_8(int16_t angle, int16_t* sine_and_cosine)
// The sine and the cosine of any angle in radians within 0.546 ulp (exact), never beyond +-1.
//
// In:       angle r25:r24, sine_and_cosine r23:r22
// Out:      r25:r24; of sincos, two numbers in memory
// Clobbers: r0, r18..r27, r30, r31, T
// Stack:    0 bytes.
//
// The angle times 2^16 / 2 pi is a phase of 16 bits, of which two say the quarter turn, six the
// interval and eight the position in it. Even quarter turns run forward, odd ones backward, which
// is the complement; the second half turn is negative. The sine is a chord of sin_q8_8.py: whole
// ulps, and units of 2^-5 ulp, to which the slope adds without a carry. The phase is cut, by half a
// unit in the mean, and so is its complement. portable/sin_q8_8.hpp is the same, bit for bit.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

// 2^16 / 2 pi = 40.74 as numbers are in units of 2^-8, with 16 bits behind the point.
#define UNITS_PER_ULP_0 0x61
#define UNITS_PER_ULP_1 0xbe
#define UNITS_PER_ULP_2 0x28

#define factor0 r18
#define factor1 r19
#define factor2 r22
#define angle0 r20
#define angle1 r21
#define cut r23
#define zero r31
#define position r24
#define quarters r25
#define units r18
#define slope r19

    // quarters:position = the phase of the angle in r25:r24.
    .macro phase_of_angle
    ldi factor0, UNITS_PER_ULP_0
    ldi factor1, UNITS_PER_ULP_1
    ldi factor2, UNITS_PER_ULP_2
    clr zero
    movw angle0, r24
    mul angle0, factor2
    movw position, r0
    mulsu angle1, factor1
    add position, r0
    adc quarters, r1
    mul angle1, factor2
    add quarters, r0
    mul angle0, factor1
    mov cut, r0
    add position, r1
    adc quarters, zero
    mulsu angle1, factor0
    sbc quarters, zero
    add cut, r0
    adc position, r1
    adc quarters, zero
    .endm

    // high:low = the sine at the position in the interval of r30. Leaves r1 alone.
    .macro chord low, high
    ldi r31, hi8(fixedpoint_sin_q8_8_table)
    lpm \low, Z
    subi r30, -64
    lpm units, Z
    subi r30, -64
    lpm slope, Z
    mul slope, position
    add units, r1
    swap units
    lsr units
    andi units, 0x07
    clr \high
    add \low, units
    rol \high
    .endm

    .macro negate low, high
    com \high
    neg \low
    sbci \high, 0xff
    .endm

    SECTION fixedpoint_sin_q8_8
    ENTRY fixedpoint_cos_q8_8
    ldi r26, 0x40
    rjmp 1f
    ENTRY fixedpoint_sin_q8_8
    clr r26
1:  phase_of_angle
    add quarters, r26
    bst quarters, 7
    sbrc quarters, 6
    com position
    sbrc quarters, 6
    com quarters
    mov r30, quarters
    andi r30, 0x3f
    chord r20, r25
    mov r24, r20
    clr r1
    brts 1f
    ret
1:  negate r24, r25
    ret
    ENDFUNC fixedpoint_sin_q8_8
    .size fixedpoint_cos_q8_8, .-fixedpoint_cos_q8_8

    FUNCTION fixedpoint_sincos_q8_8
    movw r26, r22
    phase_of_angle
    bst quarters, 7
    mov r22, quarters
    sbrc quarters, 6
    com position
    sbrc quarters, 6
    com quarters
    mov r30, quarters
    andi r30, 0x3f
    chord r20, r21
    brtc 1f
    negate r20, r21
1:  st X+, r20
    st X+, r21
    // The cosine is a quarter turn ahead, hence in the same interval the other way round.
    subi r22, -0x40
    com position
    mov r30, quarters
    com r30
    andi r30, 0x3f
    chord r20, r21
    clr r1
    sbrs r22, 7
    rjmp 1f
    negate r20, r21
1:  st X+, r20
    st X, r21
    ret
    ENDFUNC fixedpoint_sincos_q8_8

#endif
