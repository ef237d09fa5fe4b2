// SPDX-License-Identifier: MIT
// int32_t fixedpoint_atan2_q16_16(int32_t y, int32_t x)
// The angle of the vector (x, y) in Q16.16 radians, in (-pi, pi], within 0.75 ulp; (0, 0): 0.
//
// int32_t fixedpoint_atan_q16_16(int32_t a)
// The arc tangent of a Q16.16 number in radians, within 0.75 ulp.
//
// In       y or a = r25:r22, x = r21:r18
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// CYCLES
//
// The smaller magnitude N is divided by the larger one D: both are shifted until D has 24 bits (a
// multiplication by a power of two), the reciprocal of D comes from chords on 256 intervals, and
// N/D from six of the nine byte products. The arc tangent of the ratio comes from chords on 256
// intervals; octants fold by pi/2 and pi. atan of less than 1 needs no division.
//
// Error in ulp: chord of the arc tangent 0.041; chord of the reciprocal 2^-19, which moves the
// angle by at most half of it, 0.063; ratio cut to 23 bits from products cut in three places,
// 0.031; D, N and the rise of the reciprocal cut, 0.016; rise and entries of the arc tangent 0.010.
// Rounding 0.5.

#ifdef __AVR__

// y, later the numerator N = min(|y|, |x|).
#define n0 r22
#define n1 r23
#define n2 r24
#define n3 r25
// x, later the denominator D = max(|y|, |x|).
#define d0 r18
#define d1 r19
#define d2 r20
#define d3 r21
#define octant r27
#define STEEP 0
#define LEFT 1
#define power r26
// D normalised, without its leading one: interval and fraction of it.
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
#define angle1 r22
#define angle2 r23
#define angle3 r24
#define atan_rise0 r20
#define atan_rise1 r18

// pi/2 and pi in units of 2^-24, and 1 ulp of Q16.16: the angle holds half an ulp for rounding,
// which a subtraction from pi takes off twice too often.
#define HALF_PI 26353589
#define PI 52707179
#define ULP 256

.macro subtract_constant constant
    subi angle0, lo8(\constant)
    sbci angle1, hi8(\constant)
    sbci angle2, hlo8(\constant)
    sbci angle3, hhi8(\constant)
.endm

// angle = constant - angle: one's complement is -1 - angle. angle3 is 0 before.
.macro subtract_from_constant constant
    com angle0
    com angle1
    com angle2
    com angle3
    subtract_constant (-1 - \constant)
.endm

    .section .text.fixedpoint_atan2_q16_16, "ax", @progbits

    .global fixedpoint_atan2_q16_16
    .type fixedpoint_atan2_q16_16, @function
fixedpoint_atan2_q16_16:
    ldi octant, 0
    tst d3
    brpl 1f
    ldi octant, 1 << LEFT
    com d3
    com d2
    com d1
    neg d0
    sbci d1, 0xff
    sbci d2, 0xff
    sbci d3, 0xff
1:  bst n3, 7
    brtc 2f
    com n3
    com n2
    com n1
    neg n0
    sbci n1, 0xff
    sbci n2, 0xff
    sbci n3, 0xff
2:  cp d0, n0
    cpc d1, n1
    cpc d2, n2
    cpc d3, n3
    brcc .Ldivide
    movw r30, d0
    movw d0, n0
    movw n0, r30
    movw r30, d2
    movw d2, n2
    movw n2, r30
    ori octant, 1 << STEEP
.Ldivide:
    cpse d3, r1
    rjmp .Lfour_bytes
    tst d2
    brne .Lthree_bytes
    // D is below 1: eight bits up; at most twice.
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
    ldi page, hi8(fixedpoint_normalise_table)
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
    mul slope1, fraction1
    add rise0, r0
    adc rise1, r1
    sub reciprocal0, rise0
    sbc reciprocal1, rise1
    sbci reciprocal2, 0
    mul numerator2, reciprocal2
    mov ratio1, r0
    mov ratio2, r1
    mul numerator2, reciprocal0
    mov ratio0, r1
    clr reciprocal0     // used up: zero
    mul numerator1, reciprocal1
    add ratio0, r1
    adc ratio1, reciprocal0
    adc ratio2, reciprocal0
    mul numerator0, reciprocal2
    add ratio0, r1
    adc ratio1, reciprocal0
    adc ratio2, reciprocal0
    mul numerator2, reciprocal1
    add ratio0, r0
    adc ratio1, r1
    adc ratio2, reciprocal0
    mul numerator1, reciprocal2
    add ratio0, r0
    adc ratio1, r1
    adc ratio2, reciprocal0
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
    mul atan_slope1, ratio1
    add atan_rise0, r0
    adc atan_rise1, r1
    clr r1
    add angle0, atan_rise0
    adc angle1, atan_rise1
    adc angle2, r1
    ldi angle3, 0
    ldi r25, 0
    lsr octant
    brcs .Lsteep
    breq .Lfolded
    subtract_from_constant (PI + ULP)
.Lfolded:
    brts .Lnegate
    ret
.Lsteep:
    breq .Lsteep_right
    subtract_constant (-HALF_PI)
    brts .Lnegate
    ret
.Lsteep_right:
    subtract_from_constant (HALF_PI + ULP)
    brts .Lnegate
    ret
    // Rounding of the reciprocal made the ratio 1 or a little more.
.Lone:
    ldi ratio0, 0xff
    ldi ratio1, 0xff
    ldi ratio2, 0xff
    rjmp .Larctangent

.Lfour_bytes:
    mov r30, d3
    ldi page, hi8(fixedpoint_normalise_table)
    lpm power, Z
    sbrc d3, 7
    ldi power, 1
    mul d3, power
    mov interval, r0
    mul d2, power
    or interval, r1
    mov fraction1, r0
    mul d1, power
    or fraction1, r1
    mov fraction0, r0
    mul d0, power
    or fraction0, r1
    mul n3, power
    mov numerator2, r0
    mul n2, power
    or numerator2, r1
    mov numerator1, r0
    mul n1, power
    or numerator1, r1
    mov numerator0, r0
    mul n0, power
    or numerator0, r1
    rjmp .Lnormalised

.Lnegate:
    com r24
    com r23
    neg r22
    sbci r23, 0xff
    sbci r24, 0xff
    sbc r25, r25
    ret
    .size fixedpoint_atan2_q16_16, .-fixedpoint_atan2_q16_16

    .global fixedpoint_atan_q16_16
    .type fixedpoint_atan_q16_16, @function
fixedpoint_atan_q16_16:
    bst r25, 7
    brtc .Lpositive
    com r25
    com r24
    com r23
    neg r22
    sbci r23, 0xff
    sbci r24, 0xff
    sbci r25, 0xff
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
    ldi n0, 0
    ldi n1, 0
    ldi n2, 1
    ldi n3, 0
    ldi octant, 1 << STEEP
    rjmp .Ldivide
    .size fixedpoint_atan_q16_16, .-fixedpoint_atan_q16_16

#endif
