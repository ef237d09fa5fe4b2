// SPDX-License-Identifier: MIT
// int32_t fixedpoint_atan2_q16_16_small(int32_t y, int32_t x)
// The angle of the vector (x, y) in Q16.16 radians, in (-pi, pi], within 0.74 ulp; (0, 0): 0.
//
// int32_t fixedpoint_atan_q16_16_small(int32_t a)
// The arc tangent of a Q16.16 number in radians, within 0.74 ulp: atan2(a, 1).
//
// In       y or a = r25:r22, x = r21:r18
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Table    96 bytes, fixedpoint_arctangent_small_table
//
// The smaller magnitude is divided by the larger one bit by bit, to 20 bits, after both have been
// halved until three bytes hold them. parabola_small.S gives 256/257 of the ratio's arc tangent, to
// which its upper bytes are added, with half an ulp for rounding.
//
// Error in ulp: parabola 0.2, ratio 0.03, pi 0.002. Rounding 0.5. The worst found of atan, in 4 10^7
// inputs, is 0.72928, at 808607; of atan2, in 2 10^7 pairs, 0.73179, at (17934928, -1988335).

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define octant r27
#define angle0 r18
#include "octants_q16_16.inc"

#define sum0 r18
#define sum1 r19
#define sum2 r20
#define sum3 r21
// The ratio.
#define x0 r26
#define x1 r30
#define x2 r31

// What is subtracted of a complement, -1 - angle, so that pi less the angle is left.
#define LESS_PI (-1 - (PI + ULP))

    SECTION fixedpoint_atan2_q16_16_small

    ENTRY fixedpoint_atan_q16_16_small
    ldi_bytes d0, 0x10000, 4
    ENDFUNC fixedpoint_atan_q16_16_small

    ENTRY fixedpoint_atan2_q16_16_small
    into_first_octant rcall .Lnegate
    // Below 2^23 twice N fits three bytes.
.Lscale:
    cpi d2, 0x80
    cpc d3, r1
    brcs .Lscaled
    lsr_bytes d0, 4
    lsr_bytes n0, 4
    rjmp .Lscale
.Lscaled:
    cp_each d0, r1, 3
    brne .Ldivide
    ret                 // D is 0, and so is N
.Ldivide:
    // 20 bits, inverted, two bytes and four bits: the one ahead of its bits leaves when they are
    // complete. The upper bits of the octant count, and are 0 again at last.
    ori octant, 0x10
.Lbyte:
    mov x2, x1
    mov x1, x0
    ldi x0, 1
    sbrc octant, 7
    ldi x0, 0x10
.Lbit:
    lsl_bytes n0, 3
    cp_bytes n0, d0, 3
    brcs .Lbelow
    sub_bytes n0, d0, 3
.Lbelow:
    rol x0
    brcc .Lbit
    subi octant, 0xb0
    brcs .Lbyte
    com x0
    com x1
    com x2
    swap x0
    andi x0, 0xf6       // 6 for the bits that follow: errors are balanced
    mov r23, x0
    movw r24, x1
    ldi_bytes sum0, 0, 3
    mov sum3, octant    // to which nothing is carried
    ldi r30, lo8(fixedpoint_arctangent_small_table)
    ldi r31, hi8(fixedpoint_arctangent_small_table)
    XCALL fixedpoint_parabola_small
    add sum0, sum1      // angle0
    adc sum1, sum2
    adc sum2, r27       // 0
    mov octant, sum3
    clr r1
    mov angle1, sum1
    mov angle2, sum2
    ldi angle3, 0
    ldi r25, 0
    // A steep angle is taken from pi/2, then a left one from pi.
    sbrs octant, STEEP
    rjmp .Lflat
    subtract_from_constant (HALF_PI + ULP)
.Lflat:
    sbrs octant, LEFT
    rjmp .Lsigned
    com angle0
    com_bytes angle1, 3
    lsr octant          // PI is 2 HALF_PI + 1
    sbci angle0, lo8(LESS_PI)
    sbci angle1, hi8(LESS_PI)
    sbci angle2, hlo8(LESS_PI)
    sbci angle3, hhi8(LESS_PI)
.Lsigned:
    brtc .Lreturn
.Lnegate:
    negate_bytes r22, 4
.Lreturn:
    ret
    ENDFUNC fixedpoint_atan2_q16_16_small

#endif
