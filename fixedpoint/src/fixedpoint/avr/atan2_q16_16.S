// SPDX-License-Identifier: MIT
// int32_t fixedpoint_atan2_q16_16(int32_t y, int32_t x)
// The angle of the vector (x, y) in Q16.16 radians, in (-pi, pi], within 0.68 ulp; (0, 0): 0.
//
// int32_t fixedpoint_atan_q16_16(int32_t a)
// The arc tangent of a Q16.16 number in radians, within 0.59 ulp.
//
// In       y or a = r25:r22, x = r21:r18
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
//
// The smaller magnitude N is divided by the larger one D: both are shifted until D has 24 bits (a
// multiplication by a power of two), the reciprocal of D comes from linear interpolation on 256
// intervals, and N/D from six of the nine byte products. The arc tangent of the ratio also comes
// from linear interpolation on 256 intervals; octants are folded by pi/2 and pi. atan of less than
// 1 does not need a division.
//
// Error in ulp: chord of the arc tangent 0.041; chord of the reciprocal 2^-19, of which the angle
// takes at most half, 0.063; the ratio truncated to 23 bits, less than 5 units of them, 0.039; D
// and N truncated to 24 bits 0.016; rise and entries of the reciprocal 0.005, of the arc tangent
// 0.013; pi 0.002. Rounding 0.5. The largest error over all 2^32 inputs of atan is 0.58382, at
// -68608; the largest found for atan2, in 10^9 pairs and by hill climbing, is 0.62549, at
// (-25067131, -33686008).

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define octant r27
#define power r26
// D normalised, without its leading one: its interval and fraction.
#define interval r30
#define fraction0 r20
#define fraction1 r21
// N shifted likewise.
#define numerator0 r18
#define numerator1 r19
#define numerator2 r25
#define page r31
// While interpolating the reciprocal.
#define slope0 r22
#define slope1 r23
#define reciprocal0 r31
#define reciprocal1 r24
#define reciprocal2 r26
#define rise0 r20
#define rise1 r22
// The ratio, position in the arc tangent's table.
#define ratio0 r20
#define ratio1 r21
#define ratio2 r30
// While interpolating the arc tangent.
#define atan_slope0 r18
#define atan_slope1 r19
#define angle0 r31
#define atan_rise0 r20
#define atan_rise1 r18

#include "octants_q16_16.inc"

    FUNCTION fixedpoint_atan2_q16_16
    into_first_octant negate_bytes n0, 4
    cpse d3, r1
    rjmp .Lfour_bytes
    tst d2
    brne .Lthree_bytes
    // D is below 1: shifted left by eight bits, at most twice.
.Lshort:
    mov d2, d1
    mov d1, d0
    ldi d0, 0
    mov n2, n1
    mov n1, n0
    ldi n0, 0
    tst d2
    brne .Lthree_bytes
    tst d1
    brne .Lshort
    ret                 // D is 0, and so is N
.Lthree_bytes:
    mov r30, d2
    ldi page, hi8(fixedpoint_long_division_table)
    lpm power, Z
    sbrc d2, 7
    ldi power, 1
    mul d2, power
    mov interval, r0
    mul d1, power
    mov fraction1, r0
    or interval, r1
    mul d0, power
    mov fraction0, r0
    or fraction1, r1
    mul n2, power
    mov numerator2, r0
    mul n0, power
    movw numerator0, r0
    mul n1, power
    or numerator1, r0
    or numerator2, r1
.Lnormalised:
    lsl fraction0       // drops the leading one
    rol fraction1
    rol interval
    ldi page, hi8(fixedpoint_ratio_table)
    lpm slope0, Z
    inc page
    lpm slope1, Z
    inc page
    lpm reciprocal1, Z
    inc page
    lpm reciprocal2, Z
    inc page
    lpm reciprocal0, Z
    mul slope1, fraction0
    mov rise0, r1
    mul slope0, fraction1
    add rise0, r1
    clr rise1
    rol rise1
    mul_add slope1, fraction1, rise0, rise1
    sub reciprocal0, rise0
    sbc reciprocal1, rise1
    sbci reciprocal2, 0
    mul numerator2, reciprocal2
    mov ratio1, r0
    mov ratio2, r1
    mul numerator2, reciprocal0
    mov ratio0, r1
    clr reciprocal0     // used up: zero
    mul_add_upper numerator1, reciprocal1, ratio0, reciprocal0, ratio1, ratio2
    mul_add_upper numerator0, reciprocal2, ratio0, reciprocal0, ratio1, ratio2
    mul_add numerator2, reciprocal1, ratio0, ratio1, reciprocal0, ratio2
    mul_add numerator1, reciprocal2, ratio0, ratio1, reciprocal0, ratio2
    lsl ratio0
    rol ratio1
    rol ratio2
    brcs .Lone
.Larctangent:
    ldi page, hi8(fixedpoint_arctangent_table)
    lpm atan_slope0, Z
    inc page
    lpm atan_slope1, Z
    inc page
    lpm angle1, Z
    inc page
    lpm angle2, Z
    inc page
    lpm angle0, Z
    mul atan_slope1, ratio0
    mov atan_rise0, r1
    mul atan_slope0, ratio1
    add atan_rise0, r1
    clr atan_rise1
    rol atan_rise1
    mul_add atan_slope1, ratio1, atan_rise0, atan_rise1
    clr r1
    add angle0, atan_rise0
    adc angle1, atan_rise1
    adc angle2, r1
    return_from_first_octant

    // Rounding of the reciprocal made the ratio 1 or slightly more.
.Lone:
    ldi ratio0, 0xff
    ldi ratio1, 0xff
    ldi ratio2, 0xff
    rjmp .Larctangent

.Lfour_bytes:
    mov r30, d3
    ldi page, hi8(fixedpoint_long_division_table)
    lpm power, Z
    sbrc d3, 7
    ldi power, 1
    mul d3, power
    mov interval, r0
    mul_or d2, power, fraction1, interval
    mul_or d1, power, fraction0, fraction1
    mul d0, power
    or fraction0, r1
    mul n3, power
    mov numerator2, r0
    mul_or n2, power, numerator1, numerator2
    mul_or n1, power, numerator0, numerator1
    mul n0, power
    or numerator0, r1
    rjmp .Lnormalised

    return_negated
    ENDFUNC fixedpoint_atan2_q16_16

    ENTRY fixedpoint_atan_q16_16
    bst r25, 7
    brtc .Lpositive
    negate_bytes r22, 4
.Lpositive:
    adiw r24, 0
    brne .Lat_least_one
    // The number is the ratio, with a last byte of zero.
    mov r30, r23
    ldi page, hi8(fixedpoint_arctangent_table)
    lpm r18, Z
    inc page
    lpm r19, Z
    inc page
    lpm r20, Z
    inc page
    lpm r21, Z
    inc page
    lpm angle0, Z
    mul r18, r22
    mov r18, r1
    mul r19, r22
    add r0, r18
    adc r1, r25
    add angle0, r0
    adc r20, r1
    adc r21, r25
    movw r22, r20
    clr r1
    brts .Lnegate
    ret
.Lat_least_one:
    movw d0, r22
    movw d2, r24
    ldi_bytes n0, 0x10000, 4
    ldi octant, 1 << STEEP
    rjmp .Lfirst_octant
    ENDFUNC fixedpoint_atan_q16_16

#endif
