// SPDX-License-Identifier: MIT
// int32_t fixedpoint_sin_q16_16(int32_t angle)
// int32_t fixedpoint_cos_q16_16(int32_t angle)
// Sine and cosine of a Q16.16 angle in radians, for every input; within 0.67 ulp, in [-1, 1].
//
// void fixedpoint_sincos_q16_16(int32_t angle, int32_t* sine_and_cosine)
// Both, bit for bit as above: one argument reduction, two evaluations.
//
// int32_t fixedpoint_sine_of_phase_q16_16(int32_t phase)
// The sine of phase / 2^32 turns; as above, but without the error of the reduction.
//
// int32_t fixedpoint_sine_of_turns_q16_16(int32_t turns)
// The sine of turns / 2^16 turns, that of the phase turns 2^16.
//
// In       angle, phase, turns = r25:r22; sine_and_cosine = r21:r20
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
//
// Byte 6 of the quarter turns is the interval of the table, and bytes 5 and 4 are its fraction. In
// odd quadrants the position runs backwards (one's complement); in quadrants 2 and 3 the result is
// negated.
//
// Error in ulp: chord 0.154; quarter turns 0.036; three low bytes truncated from the rise, 1.5
// units of 2^-7 around the mean, which the table includes, 0.012; table entries 0.008. Rounding
// 0.5. The largest error over all 2^32 angles is 0.66588, at -1103431490.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include "quarter_turns_q16_16.inc"

#define quadrant r19
#define slope0 r20
#define slope1 r21
#define value0 r31
#define value1 r22
#define value2 r23
#define rise0 r24
#define rise1 r25

    SECTION fixedpoint_sin_q16_16

    ENTRY fixedpoint_sincos_q16_16
    push r28
    push r29
    movw r28, r20
    rcall fixedpoint_sin_q16_16
    std_bytes Y + 0, r22, 4
    // A quarter turn further: the next quadrant runs the other way.
    com b4
    com b5
    com b6
    inc quadrant
    rcall .Levaluate
    std_bytes Y + 4, r22, 4
    pop r29
    pop r28
    ret
    ENDFUNC fixedpoint_sincos_q16_16

    ENTRY fixedpoint_cos_q16_16
    ldi b7, 1
    rjmp .Lreduce
    ENDFUNC fixedpoint_cos_q16_16

    ENTRY fixedpoint_sin_q16_16
    ldi b7, 0
.Lreduce:
    quarter_turns
    mov quadrant, b7
    lsr b7
    brcc .Levaluate
    com b4
    com b5
    com b6
.Levaluate:
    ldi r31, hi8(fixedpoint_sine_table)
    lpm_pages slope0, slope1, value1, value2, value0
    mul slope1, b5
    movw rise0, r0
    mul_add_upper slope1, b4, rise0, zero, rise1
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
    negate_bytes r22, 3
    sbc r25, r25
    ret

    quarter_turns_far
    ENDFUNC fixedpoint_sin_q16_16

    // In a section of its own, so that programs with sines of radians do not include it.
    FUNCTION fixedpoint_sine_of_phase_q16_16
    ldi b7, 0
    .rept 2             // the quadrant
    lsl_bytes r22, 4
    rol b7
    .endr
    mov b4, r23
    mov b5, r24
    mov b6, r25
    clr zero
    XJMP .Lreduced
    ENDFUNC fixedpoint_sine_of_phase_q16_16

    FUNCTION fixedpoint_sine_of_turns_q16_16
    clr quadrant
    .rept 2
    lsl r22
    rol r23
    rol quadrant
    .endr
    mov b5, r22
    mov b6, r23
    mov b4, quadrant
    lsr b4
    sbc b4, b4          // the complement of 0 in odd quadrants
    eor b5, b4
    eor b6, b4
    clr zero
    XJMP .Levaluate
    ENDFUNC fixedpoint_sine_of_turns_q16_16
#endif
