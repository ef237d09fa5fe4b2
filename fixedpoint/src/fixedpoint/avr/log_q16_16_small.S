// SPDX-License-Identifier: MIT
// int32_t fixedpoint_log_q16_16_small(int32_t a)
// ln a in Q16.16, within 0.73 ulp for every a > 0; the smallest number where a <= 0.
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Table    96 bytes, fixedpoint_log_small_table
//
// a is shifted left until its leading one leaves, and with every bit ln 2 is subtracted from
// 16 ln 2. What is left of a is the fraction of a number from 1 to 2: its upper four bits are the
// cell of a table of parabolas, the next 20 the distance d into it, and
//
//     ln = value + d (slope - bend d)
//
// in units of 2^-24. The products count down to the upper byte of those below that.
//
// Error in ulp: parabola 0.17; ln 2 rounded 0.02; cut products, slopes and bends 0.04. Rounding 0.5.
// tables/log_small.py makes the table.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

// 2^24 ln 2 and 16 times it, with half an ulp for rounding.
#define LN2 11629080
#define START (16 * LN2 + 128)

#define sum0 r18
#define sum1 r19
#define sum2 r20
#define sum3 r21
// The distance into the cell: four bits and two bytes.
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

    .macro subtract constant
    subi sum0, lo8(\constant)
    sbci sum1, hi8(\constant)
    sbci sum2, hlo8(\constant)
    sbci sum3, hhi8(\constant)
    .endm

    SECTION fixedpoint_log_q16_16_small
.Lnone:
    ldi r22, 0
    ldi r23, 0
    ldi r24, 0
    ldi r25, 0x80
    ret

    ENTRY fixedpoint_log_q16_16_small
    cp r1, r22
    cpc r1, r23
    cpc r1, r24
    cpc r1, r25
    brge .Lnone
    ldi sum0, lo8(START)
    ldi sum1, hi8(START)
    ldi sum2, hlo8(START)
    ldi sum3, hhi8(START)
.Lbyte:
    tst r25
    brne .Lbit
    mov r25, r24
    mov r24, r23
    mov r23, r22
    mov r22, r1
    subtract (8 * LN2)
    rjmp .Lbyte
.Lbit:
    subtract LN2
    lsl r22
    rol r23
    rol r24
    rol r25
    brcc .Lbit

    // Z = the table's entry of six bytes: 6 / 16 of the upper four bits
    mov r30, r25
    andi r30, 0xf0
    ldi r31, 96
    mul r30, r31
    mov r30, r1
    ldi r31, 0
    subi r30, lo8(-(fixedpoint_log_small_table))
    sbci r31, hi8(-(fixedpoint_log_small_table))
    andi d2, 15
    lpm r22, Z+
    mul d1, r22
    mov r26, r1
    mul d2, r22
    add r26, r0
    clr r27
    adc r27, r1
    lpm r22, Z+
    sub slope0, r26
    lpm r26, Z+
    sbc slope1, r27
    ldi zero, 0
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
    mul d1, slope0
    add p0, r1
    adc p1, zero
    adc p2, zero
    mul d2, slope0
    add p0, r0
    adc p1, r1
    adc p2, zero
    mul d1, slope1
    add p0, r0
    adc p1, r1
    adc p2, zero
    add sum0, p0
    adc sum1, p1
    adc sum2, p2
    adc sum3, zero
    mov r22, sum1
    mov r23, sum2
    mov r24, sum3
    lsl sum3
    sbc r25, r25
    clr r1
    ret
    ENDFUNC fixedpoint_log_q16_16_small
#endif
