// SPDX-License-Identifier: MIT
// int32_t fixedpoint_atan2_q16_16_small(int32_t y, int32_t x)
// The angle of the vector (x, y) in Q16.16 radians, in (-pi, pi], within 0.63 ulp; 0 for (0, 0).
//
// int32_t fixedpoint_atan_q16_16_small(int32_t a)
// The arc tangent of a Q16.16 number in radians, within 0.63 ulp: atan2(a, 1).
//
// In       y or a = r25:r22, x = r21:r18
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Table    48 bytes, fixedpoint_arctangent_small_table
//
// Both magnitudes are shifted until the larger one, D, is in 2^16 <= D < 2^22; then the smaller
// one, N, is divided by it bit by bit. Four bits q leave the remainder R = 16 N - q D. Since
//
//     atan(N / D) = atan(q / 16) + atan(R / (16 D + q N)),
//
// R is divided by D + q N / 16, to 16 bits: z, in units of 2^-20, whose arc tangent is z - z^3 / 3.
// The table adds to atan(q / 16) half an ulp for rounding and an offset that centres the errors.
//
// Error in ulp: z 0.03, the truncation of q N / 16 0.03 for the smallest D, the cube 0.03; rounding
// 0.5. Worst of atan over all inputs: 0.61407, at -11623; worst of atan2 found in 6 10^7 pairs:
// 0.62514, at (12471, 67349).

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define octant r27
#define angle0 r18
#include "octants_q16_16.inc"

#define zero d3
// N, q 2^4, then z.
#define numerator0 r30
#define numerator1 r31
#define numerator2 r25
#define q r30
#define z0 r26
#define z1 r25

    SECTION fixedpoint_atan2_q16_16_small
    // Eight bits of N / D, inverted, or as many as there are zeros above the leading one of z0.
.Lbyte:
    ldi z0, 1
.Lbit:
    lsl_bytes n0, 3
    cp_bytes n0, d0, 3
    brcs .Lbelow
    sub_bytes n0, d0, 3
.Lbelow:
    rol z0
    brcc .Lbit
.Lnone:
    ret

    ENTRY fixedpoint_atan_q16_16_small
    ldi_bytes d0, 0x10000, 4
    ENDFUNC fixedpoint_atan_q16_16_small

    ENTRY fixedpoint_atan2_q16_16_small
    into_first_octant rcall .Lnegate
.Lup:
    mov r30, d2
    or r30, d3
    brne .Ldown
    cp_each d0, r1, 2
    breq .Lnone         // D = 0, hence N = 0
    mov_from_top d1, d0, 2
    mov_from_top n1, n0, 2
    clr d0
    clr n0
    rjmp .Lup
.Lshift:
    lsr_bytes d0, 4
    lsr_bytes n0, 4
.Ldown:
    cpi d2, 0x40
    cpc d3, r1
    brcc .Lshift

    movw numerator0, n0
    mov numerator2, n2
    ldi z0, 0x1f        // four bits, and four ones above them
    rcall .Lbit
    com z0
    swap z0
    mul_add_upper numerator0, z0, d0, zero, d1, d2
    mul_add numerator1, z0, d0, d1, zero, d2
    mul_add numerator2, z0, d1, d2
    mov q, z0
    rcall .Lbyte
    mov z1, z0
    rcall .Lbyte
    com z0
    com z1
    mul z1, z1
    mul r1, z1
    ldi r31, 85
    mul r1, r31
    sub z0, r1
    sbc z1, zero
    ldi r31, 48         // three bytes per angle
    mul q, r31
    mov r30, r1
    ldi r31, 0
    subi r30, lo8(-(fixedpoint_arctangent_small_table))
    sbci r31, hi8(-(fixedpoint_arctangent_small_table))
    lpm angle0, Z+
    lpm angle1, Z+
    lpm angle2, Z+
    ldi r31, 16
    mul_add z0, r31, angle0, angle1, zero, angle2
    mul_add z1, r31, angle1, angle2
    clr r1
    ldi angle3, 0

    // Octant angles are subtracted from, added to, and subtracted from 0, pi/2, pi and pi/2.
    inc octant
    sbrs octant, 1
    rjmp .Lturned
    com angle0
    rcall .Lnegate
.Lturned:
    sbrc octant, 2
    subi octant, 2
.Lquarter:
    dec octant
    breq .Lsigned
    subtract_constant (-HALF_PI)
    rjmp .Lquarter
.Lsigned:
    ldi r25, 0
    brtc .Lreturn
.Lnegate:
    negate_bytes r22, 4
.Lreturn:
    ret
    ENDFUNC fixedpoint_atan2_q16_16_small

#endif
