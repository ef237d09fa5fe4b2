// SPDX-License-Identifier: MIT
// int32_t fixedpoint_exp_q16_16_small(int32_t a)
// e^a in Q16.16, within 0.72 ulp for every input; the largest number from ln 32768 on, 0 if that is
// the nearest number.
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    2 bytes
// Table    132 bytes, fixedpoint_exp_small_table
//
// ln 2 is subtracted k times in units of 2^-32. A correction in these units makes up for rounding
// ln 2 up; it fits k = 14, where results have the most bits. For the upper four bits of
// r = a - k ln 2, at first 0 <= r < ln 2, the table has a factor 1 + b/256 slightly below e^r and
// its logarithm, which is subtracted: r < 17/256. The next factor is 1 + j/256: j is the upper byte
// of r, plus 1 if the next byte is at least 256 - j (j + 1) / 2. Then ln(1 + j/256) is at most r,
// and less than 2^-8 below it. For the remainder s, which gets a fifth byte from the table,
//
//     v = s + s^2 / 2 + s^3 / 6
//
// in units of 2^-40, and c = (1 + v)(1 + j/256)(1 + b/256) - 1. Of byte products below 2^-40, only
// the upper byte counts. Truncating bits before the last shift does not round twice.
//
// Rounding errs by 0.5 ulp; most of the rest comes from r at k = 14, from ln 2 and logarithms in
// whole units. Worst over all inputs: 0.71803, at 677515.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define LN2_0 0xf8
#define LN2_1 0x17
#define LN2_2 0x72
#define LN2_3 0xb1
#define CORRECTION 2
#define SIXTH 43

// r; its integer r4 ends as 0 and becomes a scratch register. Then s = s2:s0 followed by v0, then
// c, since the next byte of v is c4.
#define r4 r24
#define scratch r24
#define r3 r23
#define s2 r22
#define s1 r21
#define s0 r20
#define c4 r23
#define c3 r22
#define c2 r21
#define c1 r20
#define c0 r18
// 16 - k: the number of bits by which the mantissa is shifted.
#define shift r19
#define zero r25
// The terms of the square and the cube, added to s.
#define w0 r26
#define w1 r27
#define w2 r30
#define square r31
// b or j, and its product with c.
#define factor r24
#define q1 r30
#define q2 r31
#define q3 r26
#define q4 r27

    // Z = the entry of the table at r30
    .macro point_to offset
    ldi r31, 0
    subi r30, lo8(-(fixedpoint_exp_small_table + \offset))
    sbci r31, hi8(-(fixedpoint_exp_small_table + \offset))
    .endm

    SECTION fixedpoint_exp_q16_16_small
.Lbeyond:
    sbiw r24, 12
.Lsaturate:             // the largest number or 0, depending on the sign of r25
    lsl r25
    sbc r22, r22
    com r22
    mov r23, r22
    movw r24, r22
    lsr r25
    ret

    ENTRY fixedpoint_exp_q16_16_small
    adiw r24, 12
    cpi r24, 23
    cpc r25, r1
    brsh .Lbeyond
    subi r4, 12
    ldi s1, 0
    ldi s0, CORRECTION
    ldi shift, 16
1:  dec shift
    subi s0, LN2_0
    sbci s1, LN2_1
    sbci s2, LN2_2
    sbci r3, LN2_3
    sbci r4, 0
    brpl 1b
2:  inc shift
    subi s0, 0x100 - LN2_0
    sbci s1, 0xff - LN2_1
    sbci s2, 0xff - LN2_2
    sbci r3, 0xff - LN2_3
    sbci r4, 0xff
    brmi 2b
    cpi shift, 2
    brlo .Lsaturate
    // Z = the five bytes of the factor
    mov r30, r3
    andi r30, 0xf0
    ldi w1, 80
    mul r30, w1
    mov r30, r1
    point_to 0
    lpm r0, Z+
    push r0
    lpm r0, Z+
    sub s0, r0
    lpm r0, Z+
    sbc s1, r0
    lpm r0, Z+
    sbc s2, r0
    lpm r0, Z+
    sbc r3, r0

    mov r30, r3
    inc r30
    mul r30, r3
    lsr r1
    ror r0
    add r0, s2
    adc r3, zero
    push r3
    mov r30, r3
    lsl r30
    lsl r30
    point_to 60
    lpm c0, Z+
    lpm r0, Z+
    add s0, r0
    lpm r0, Z+
    adc s1, r0
    lpm r0, Z+
    adc s2, r0

    // w = s2^2 2^7 + s2 s1 + s1^2 / 2^9 + s2 s0 / 2^8 + s2^3 / (6 2^8)
    mul s2, s1
    movw w0, r0
    mul s1, s1
    lsr r1
    add w0, r1
    adc w1, zero
    mul_add_upper s2, s0, w0, zero, w1
    mul s2, s2
    mov square, r1
    lsr r1
    ror r0
    ror scratch
    add w0, scratch
    adc w1, r0
    adc r1, zero
    mov w2, r1
    mul s2, square
    ldi scratch, SIXTH
    mul r1, scratch
    add w0, r0
    adc w1, r1
    adc w2, zero
    // v
    ldi c4, 0
    add c0, w0
    adc c1, w1
    adc c2, w2
    adc c3, zero
    adc c4, zero

    // Twice c = (1 + c)(1 + factor / 256) - 1; the top bit of `shift` is set after the first time.
3:  pop factor
    mul factor, c2
    movw q1, r0
    mul factor, c4
    movw q3, r0
    mul_add_upper factor, c0, c0, zero, q1, q2
    mul_add factor, c1, c0, q1, zero, q2
    mul_add factor, c3, q2, q3, zero, q4
    add c1, q1
    adc c2, q2
    adc c3, q3
    adc c4, q4
    add c4, factor
    subi shift, 0x80
    brmi 3b
    clr r1
    movw r24, c3
    movw r22, c1
    ldi r20, 1          // e^r is below 2
2:  cpi shift, 9
    brlo 3f
    mov_bytes r22, r23, 3
    mov r25, r20
    ldi r20, 0
    subi shift, 8
    rjmp 2b
3:  lsr r20
    ror_bytes r22, 4
    dec shift
    brne 3b
    adc_each r22, r1, 4
    ret
    ENDFUNC fixedpoint_exp_q16_16_small
#endif
