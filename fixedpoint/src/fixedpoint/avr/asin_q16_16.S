// SPDX-License-Identifier: MIT
// int32_t fixedpoint_asin_q16_16(int32_t a), fixedpoint_acos_q16_16(int32_t a)
// asin a and acos a in Q16.16, within 0.6 ulp; arguments outside [-1, 1] count as the nearer end.
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
//
// Argument reduction: below 1/2 the arc sine is s + (asin s - s); above, it is pi/2 - 2 asin s with
// s = sqrt((1 - |a|) / 2), which is at most 1/2. Two tables of parabolas on intervals of 1/64 give
// asin s - s and the root, whose argument is normalised by powers of 4. The height of a parabola
// above or below its chord is the bend times t (1 - t), for which 8 bits of the fraction t are
// enough. s has 22 fraction bits, and the result has 23 before it is rounded: an error of the root
// counts 2 times 1.15, the slope of the arc sine at 1/2.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

// The argument of a table: its interval and 16 bits of fraction.
#define interval r23
#define fraction1 r22
#define fraction0 r21
// The number of bits by which the root is shifted back.
#define shift r20
#define slope0 r18
#define slope1 r19
#define bend r23
#define rest r18 // bits of the interval, below the fraction
#define rise0 r30
#define rise1 r31
#define sum0 r26
#define sum1 r27
#define sum2 r24
#define zero r25

#define HALF_PI 13176795 // 2^-23

#include "rise_q16_16.inc"

// interval:fraction of the 16-bit number in r23:r22, in units of 2^-16.
    .macro take_interval
    ldi fraction0, 0
    .rept 2
    lsr interval
    ror fraction1
    ror fraction0
    .endr
    .endm

// The value of the record at `start` + 6 interval; Z points to the rest.
    .macro find_value start
    ldi r18, 6
    mul interval, r18
    movw r30, r0
    subi r30, lo8(-(fixedpoint_arc_sine_table + \start))
    sbci r31, hi8(-(fixedpoint_arc_sine_table + \start))
    lpm sum0, Z+
    lpm sum1, Z+
    lpm sum2, Z+
    .endm

// Adds the chord's rise from the value, and the height of the parabola above the chord by `bent`.
    .macro add_parabola bent, bent_carry
    lpm slope0, Z+
    lpm slope1, Z+
    lpm bend, Z
    find_rise
    add sum0, rise0
    adc sum1, rise1
    adc sum2, zero
    mov rest, fraction1
    com rest
    fmul rest, fraction1
    mov rest, r1
    fmul rest, bend
    \bent sum0, r1
    \bent_carry sum1, zero
    \bent_carry sum2, zero
    .endm

    SECTION fixedpoint_arc_sine_q16_16
.Lfrom_one:
    ldi r22, lo8(HALF_PI + 64)
    ldi r23, hi8(HALF_PI + 64)
    ldi r24, hlo8(HALF_PI + 64)
    ldi r25, 0
    ret

// asin |a| 2^23 + 64, half an ulp, in r25:r22; T is the sign of a.
    ENTRY fixedpoint_arc_sine_q16_16
    bst rA3, 7
    brtc 1f
    negate_bytes rA0, 4
1:  or rA2, rA3
    brne .Lfrom_one
    tst rA1
    brmi .Lfrom_half
    take_interval
// asin s 2^23 + 64 of s = interval:fraction, in units of 2^-22.
.Larc:
    find_value 0
    add sum0, fraction0
    adc sum1, fraction1
    adc sum2, interval
    add sum0, fraction0
    adc sum1, fraction1
    adc sum2, interval
    add_parabola sub, sbc
    movw r22, sum0
    clr r1
    ret

.Lfrom_half:
    // 2^16 - |a|, from 1 to 2^15
    com r23
    neg r22
    sbci r23, 0xff
    ldi shift, 0
    rjmp 2f
1:  lsl r22
    rol r23
    lsl r22
    rol r23
    inc shift
2:  cpi r23, 0x40
    brlo 1b
    take_interval
    find_value (33 - 16) * 6 // the roots begin at interval 16, after 33 arcs
    add_parabola add, adc
    mov fraction0, sum0
    mov fraction1, sum1
    mov interval, sum2
    rjmp 2f
1:  lsr interval
    ror fraction1
    ror fraction0
2:  dec shift
    brpl 1b
    rcall .Larc
    // pi/2 - 2 asin s
    lsl_bytes r22, 3
    com_bytes r22, 3
    subi_bytes r22, -(HALF_PI + 3 * 64 + 1), 3
    ret
    ENDFUNC fixedpoint_arc_sine_q16_16

    FUNCTION fixedpoint_asin_q16_16
    XCALL fixedpoint_arc_sine_q16_16
    lsl_bytes r22, 3
    mov r22, r23
    mov r23, r24
    ldi r24, 0
    rol r24
    brtc 1f
    negate_bytes rA0, 4
1:  ret
    ENDFUNC fixedpoint_asin_q16_16

    FUNCTION fixedpoint_acos_q16_16
    XCALL fixedpoint_arc_sine_q16_16
    brts 1f
    // pi/2 - asin |a|
    com_bytes r22, 3
    subi_bytes r22, -(HALF_PI + 2 * 64 + 1), 3
    rjmp 2f
1:  subi r22, lo8(-(HALF_PI))
    sbci r23, hi8(-(HALF_PI))
    sbci r24, hlo8(-(HALF_PI))
    sbci r25, 0xff
2:  lsl_bytes r22, 4
    mov_bytes r22, r23, 3
    ldi r25, 0
    ret
    ENDFUNC fixedpoint_acos_q16_16
#endif
