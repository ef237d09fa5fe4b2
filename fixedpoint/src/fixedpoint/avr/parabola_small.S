// SPDX-License-Identifier: MIT
// What log_q16_16_small.S and atan2_q16_16_small.S share: a function on [0, 1) by 16 parabolas.
//
// In       x = r25:r23, a fraction of 24 bits; Z = the table; a sum = r21:r18
// Out      sum + function(x), in units of 2^-24
// Changes  r0, r1, r22..r27, r30, r31
//
// The upper four bits of x are the cell, whose entry of the table has six bytes, the other 20 the
// distance d into it: value + d (slope - bend d). The products count down to the upper byte of those
// below 2^-24. tables/parabolas_small.py makes the tables.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define sum0 r18
#define sum1 r19
#define sum2 r20
#define sum3 r21
// The distance: four bits and two bytes.
#define d2 r25
#define d1 r24
#define d0 r23
#define slope0 r22
#define slope1 r26
#define zero r27
// The product of distance and slope.
#define p0 r23
#define p1 r30
#define p2 r31

    FUNCTION fixedpoint_parabola_small
    ldi zero, 0
    mov r22, d2
    andi r22, 0xf0
    ldi r26, 96         // 6 / 16 of 2^8
    mul_add_upper r22, r26, r30, zero, r31
    andi d2, 15
    lpm r22, Z+
    mul d1, r22
    mov r26, r1
    mul d2, r22
    add r26, r0
    adc r1, zero
    lpm r22, Z+
    sub slope0, r26
    lpm r26, Z+
    sbc slope1, r1
    lpm r0, Z+
    add sum0, r0
    lpm r0, Z+
    adc sum1, r0
    lpm r0, Z+
    adc sum2, r0
    adc sum3, zero
    mul d2, slope1
    movw p1, r0
    mul d0, slope1
    mov p0, r1
    mul_add_upper d1, slope0, p0, zero, p1, p2
    mul_add d2, slope0, p0, p1, zero, p2
    mul_add d1, slope1, p0, p1, zero, p2
    add sum0, p0
    adc sum1, p1
    adc sum2, p2
    adc sum3, zero
    ret
    ENDFUNC fixedpoint_parabola_small
#endif
