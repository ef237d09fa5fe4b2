// SPDX-License-Identifier: MIT
// The core of every function of Q32.32 whose results have at most 39 significant bits: a piecewise
// cubic on 256 intervals,
//
//     value + t (slope - t (bend + t twist)),
//
// where t in [0, 1) is the position in the interval. Not a C function: r17 is zero instead of r1.
//
// In       r31:r30 = address of the interval's record (tables/cubic.py), r25:r22 = 2^32 t, r17 = 0
// Out      r21:r18, r26 = the function in units of 2^-39, modulo 2^40, including half an ulp of
//          Q32.32 for rounding; the tables state its error
// Changes  r0, r1, r18..r22, r26, r27, r30, r31
//
// The thirteen bytes of a record are in the order of use. The twist is multiplied by the upper two
// bytes of t only. Products below the unit are omitted, and of those that reach it only the upper
// byte is kept; the table compensates for the mean of that truncation.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "cubic_64.inc"

#define t0 r22
#define t1 r23
#define t2 r24
#define t3 r25
#define twist r21
#define bend0 r26
#define bend1 r18
#define bend2 r27
#define fall0 r19
#define fall1 r20
#define fall2 r21
#define slope0 r26
#define slope1 r18
#define slope2 r27
#define slope3 r19
#define rise0 r26
#define rise1 r20
#define rise2 r21
#define rise3 r22

    FUNCTION fixedpoint_cubic_64
    lpm twist, Z+
    lpm bend0, Z+
    lpm bend1, Z+
    lpm bend2, Z+
    mov r19, t3         // mulsu does not take registers above r23
    mulsu twist, r19    // the carry is the sign
    sbc bend2, zero
    add bend0, r0
    adc bend1, r1
    adc bend2, zero
    mov r19, t2
    mulsu twist, r19
    sbc bend1, zero
    sbc bend2, zero
    add bend0, r1
    adc bend1, zero
    adc bend2, zero
    mul bend0, t3
    mov fall0, r1
    ldi fall1, 0
    ldi fall2, 0
    mul_add_upper bend1, t2, fall0, zero, fall1
    mul_add_upper bend2, t1, fall0, zero, fall1
    mul_add bend2, t2, fall0, fall1, zero, fall2
    mul_add bend1, t3, fall0, fall1, zero, fall2
    mul_add bend2, t3, fall1, fall2
    lpm slope0, Z+
    sub slope0, fall0
    lpm slope1, Z+
    sbc slope1, fall1
    lpm slope2, Z+
    sbc slope2, fall2
    lpm slope3, Z+
    sbc slope3, zero
    mul slope0, t3
    mov rise0, r1
    ldi rise1, 0
    ldi rise2, 0
    mul_add_upper slope1, t2, rise0, zero, rise1
    mul_add_upper slope2, t1, rise0, zero, rise1
    mul slope3, t0
    ldi rise3, 0        // t0 is used up
    add rise0, r1
    adc rise1, zero
    mul_add slope1, t3, rise0, rise1, zero, rise2
    mul_add slope2, t2, rise0, rise1, zero, rise2
    mul_add slope3, t1, rise0, rise1, zero, rise2
    mul_add slope2, t3, rise1, rise2, zero, rise3
    mul_add slope3, t2, rise1, rise2, zero, rise3
    mul_add slope3, t3, rise2, rise3
    lpm r0, Z+
    add r26, r0
    lpm r18, Z+
    adc r18, rise1
    lpm r19, Z+
    adc r19, rise2
    lpm r20, Z+
    adc r20, rise3
    lpm r21, Z+
    adc r21, zero
    ret
    ENDFUNC fixedpoint_cubic_64
#endif
