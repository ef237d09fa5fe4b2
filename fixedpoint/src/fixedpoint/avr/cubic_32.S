// SPDX-License-Identifier: MIT
// The cores of every 32-bit function: a piecewise cubic on 256 intervals,
//
//     value + t (slope - t (bend + t twist)),
//
// where t in [0, 1) is the position in the interval. Not C functions: r21 is zero instead of r1.
//
// fixedpoint_cubic_32    in units of 2^-31, within 5.7 units (cubic_core_32.inc), modulo 2^32
// fixedpoint_cubic_40    in units of 2^-39, modulo 2^40; within 57 units, 2^-33.1
//
// In       r31:r30 = address of the interval's record (tables/cubic.py), r20:r18 = 2^24 t, r21 = 0
// Out      r25:r22; r27:r23, and r22 = the slope there, in units of 2^-15
// Changes  r0, r1, r22..r27, r30, r31; cubic_40 changes r18, too
//
// The twelve bytes of a record are in the order of use. The twist is multiplied by the upper byte
// of t only. Products below the unit are omitted, and of those that reach it only the upper byte is
// kept. By that alone, cubic_32 subtracts up to 2.8 units too little and adds up to 5.3 units too
// little.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "cubic_32.inc"
#include "cubic_core_32.inc"

    FUNCTION fixedpoint_cubic_32
    cubic_32
    ret
    ENDFUNC fixedpoint_cubic_32

    FUNCTION fixedpoint_cubic_40
#define bend0 r23
#define bend1 r24
#define bend2 r25
#define fall0 r22
#define fall1 r26
#define fall2 r27
#define slope0 r23
#define slope1 r24
#define slope2 r25
#define slope3 r22
#define rise0 r23
#define rise1 r26
#define rise2 r27
#define rise3 r18
    lpm r22, Z+
    mulsu r22, t2       // the carry is the sign
    lpm bend1, Z+
    lpm bend2, Z+
    sbc bend2, zero
    mov bend0, r0
    add bend1, r1
    adc bend2, zero
    mul bend0, t2
    mov fall0, r1
    ldi fall1, 0
    ldi fall2, 0
    mul_add_upper bend1, t1, fall0, zero, fall1
    mul_add_upper bend2, t0, fall0, zero, fall1
    mul_add bend2, t1, fall0, fall1, zero, fall2
    mul_add bend1, t2, fall0, fall1, zero, fall2
    mul_add bend2, t2, fall1, fall2
    lpm slope0, Z+
    sub slope0, fall0
    lpm slope1, Z+
    sbc slope1, fall1
    lpm slope2, Z+
    sbc slope2, fall2
    lpm slope3, Z+
    sbc slope3, zero
    mul slope0, t2
    mov rise0, r1
    ldi rise1, 0
    ldi rise2, 0
    mul_add_upper slope1, t1, rise0, zero, rise1
    mul_add_upper slope2, t0, rise0, zero, rise1
    mul slope3, t0
    ldi rise3, 0        // t0 is used up
    add rise0, r0
    adc rise1, r1
    adc rise2, zero
    mul_add slope2, t1, rise0, rise1, zero, rise2
    mul_add slope1, t2, rise0, rise1, zero, rise2
    mul_add slope3, t1, rise1, rise2, zero, rise3
    mul_add slope2, t2, rise1, rise2, zero, rise3
    mul_add slope3, t2, rise2, rise3
    lpm r0, Z+
    add r23, r0
    lpm r24, Z+
    adc r24, rise1
    lpm r25, Z+
    adc r25, rise2
    lpm r26, Z+
    adc r26, rise3
    lpm r27, Z+
    adc r27, zero
    ret
    ENDFUNC fixedpoint_cubic_40
#endif
