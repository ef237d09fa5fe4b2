// SPDX-License-Identifier: MIT
// int32_t fixedpoint_log_q16_16_small(int32_t a)
// ln a in Q16.16, within 0.74 ulp for every a > 0; the smallest number if a <= 0.
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Table    80 bytes, fixedpoint_log_small_table
//
// a is shifted left until its leading one is shifted out; for every bit, ln 2 is subtracted from
// 16 ln 2, in units of 2^-24. What remains of a is the fraction of a number from 1 to 2, whose
// logarithm is given by one of 16 parabolas: the upper four bits select the cell, an entry of five
// bytes; the other 20 are the distance d into it: value + d (slope - bend d). The bend is half the
// square of the slope in the middle of the cell: a factor corrects for taking the slope at its
// beginning. Of byte products below 2^-24, only the upper byte counts.
//
// Error in ulp: parabola 0.24, ln 2 rounded 0.002; rounding 0.5. Worst over all inputs: 0.73711, at
// 28310223.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

// 2^24 ln 2
#define LN2 11629080
#define START (16 * LN2)
// tables/log_small.py fits it.
#define BEND 122

#define sum0 r18
#define sum1 r19
#define sum2 r20
#define sum3 r21
// The distance: four bits and two bytes.
#define d2 r25
#define d1 r24
#define d0 r23
#define bend r22
#define slope0 r26
#define slope1 r27
// The value, whose lowest byte comes last since it replaces Z, plus the product of distance and
// slope; p1 and p2 replace bend and d0.
#define p0 r30
#define p1 r22
#define p2 r23
#define p r31
#define zero r31

    FUNCTION fixedpoint_log_q16_16_small
    tst r25
    brmi .Lnone
    ldi_bytes sum0, START, 4
    brne .Lbit
.Lbyte:
    mov_from_top r23, r22, 3
    mov r22, r1
    subi_bytes sum0, (8 * LN2), 4
    cpse r25, r1
    rjmp .Lbit
    brpl .Lbyte         // three times at most
.Lnone:
    ldi_bytes r22, 0x80000000, 4
    ret
.Lbit:
    subi_bytes sum0, LN2, 4
    lsl_bytes r22, 4
    brcc .Lbit

    // Z = the five bytes of the cell
    mov r30, d2
    andi r30, 0xf0
    ldi r31, 80
    mul r30, r31
    mov r30, r1
    ldi r31, 0
    subi r30, lo8(-(fixedpoint_log_small_table))
    sbci r31, hi8(-(fixedpoint_log_small_table))
    andi d2, 15
    lpm slope0, Z+
    lpm slope1, Z+
    mul slope1, slope1
    ldi bend, BEND
    mul r1, bend
    mov bend, r1
    mul d1, bend
    sub slope0, r1
    sbci slope1, 0
    mul d2, bend
    sub slope0, r0
    sbc slope1, r1
    mul d0, slope1
    lpm p1, Z+
    lpm p2, Z+
    lpm p0, Z
    mov p, r1
    mul d2, slope1
    add p0, p
    adc p1, r0
    adc p2, r1
    ldi zero, 0
    mul_add_upper d1, slope0, p0, zero, p1, p2
    mul_add d2, slope0, p0, p1, zero, p2
    mul_add d1, slope1, p0, p1, zero, p2
    // The sum is returned without its lowest byte.
    add p0, sum0
    adc p1, sum1
    adc p2, sum2
    adc sum3, zero
    mov r24, sum3
    lsl sum3
    sbc r25, r25
    clr r1
    ret
    ENDFUNC fixedpoint_log_q16_16_small
#endif
