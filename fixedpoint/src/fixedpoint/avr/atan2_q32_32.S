// SPDX-License-Identifier: MIT
// int64_t fixedpoint_atan2_q32_32(int64_t y, int64_t x)
// int64_t fixedpoint_atan_q32_32(int64_t a)
// The angle of the vector (x, y) in (-pi, pi] and of (1, a), within 0.65 ulp; atan2(0, 0) = 0.
//
// In       y = r25:r18, x = r17:r10; a = r25:r18
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    11 bytes
// Tables   3328 bytes, fixedpoint_atan_64_table; 1280 bytes, fixedpoint_ratio_table; 256 bytes,
//          fixedpoint_leading_one_table
//
// Both coordinates are shifted left until the longer one, D, has its leading one at the top; five
// bytes of each are kept, N of the shorter one. Linear interpolation on 256 intervals gives 2^63 /
// D in three bytes R, biased by -40 so that R is never too large. Three bytes g of N / D follow
// from N R, at most 2^-17 too small; the remainder N - g D, exact except for bits below the result,
// times R + 40 gives the bytes below. The 40-bit ratio is the position in the arc tangent table; it
// is 2^40 - 1 if it rounds to 1. The angle is then unfolded from the first octant.
//
// Error in units of 2^-39: the core 11.0; the product of the relative errors of R, 73 2^-24, and of
// R + 40, 34 2^-24, 1.2; the omitted bytes 3; N and D truncated to five bytes 1; the rounding 64,
// half an ulp.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "cubic_64.inc"

#define n0 r21
#define n1 r22
#define n2 r23
#define n3 r24
#define n4 r25
#define d0 r13
#define d1 r14
#define d2 r15
#define d3 r16
#define d4 r17
// R and, while it is interpolated, the slope and its multiple.
#define inverse0 r10
#define inverse1 r11
#define inverse2 r12
#define slope0 r18
#define slope1 r19
#define fraction0 r26
#define fraction1 r27
#define fall0 r26
#define fall1 r18
#define g0 r26
#define g1 r27
#define g2 r31
#define nothing r20
#define bias r19

#define STEEP 0
#define LEFT 1

    // p2:p1:p0 = a b / 2^24 of three bytes each: portable/multiply_high_24.hpp.
    .macro product_of_fractions p2, p1, p0, a2, a1, a0, b2, b1, b0
    mul \a2, \b2
    mov \p1, r0
    mov \p2, r1
    mul \a2, \b0
    mov \p0, r1
    mul_add_upper \a1, \b1, \p0, nothing, \p1, \p2
    mul_add_upper \a0, \b2, \p0, nothing, \p1, \p2
    mul_add \a2, \b1, \p0, \p1, nothing, \p2
    mul_add \a1, \b2, \p0, \p1, nothing, \p2
    .endm

    // The angle is r22:r18, r26 in units of 2^-39 and includes half an ulp for rounding, before and
    // after.
    .macro add_to_angle value
    .set constant, -(\value)
    subi r26, constant & 0xff
    sbci r18, (constant >> 8) & 0xff
    sbci r19, (constant >> 16) & 0xff
    sbci r20, (constant >> 24) & 0xff
    sbci r21, (constant >> 32) & 0xff
    sbci r22, (constant >> 40) & 0xff
    .endm
    .macro subtract_angle_from value
    com r26
    com_bytes r18, 5
    add_to_angle (\value + 1 + (2 << 6))
    .endm

    SECTION fixedpoint_atan2_q32_32
    ENTRY fixedpoint_atan_q32_32
    push_all r10, r11, r12, r13, r14, r15, r16, r17
    clr r10
    clr r11
    movw_each r12, r10, 6
    inc r14
    ldi r30, 0
    rjmp .Lright
    ENDFUNC fixedpoint_atan_q32_32

    ENTRY fixedpoint_atan2_q32_32
    push_all r10, r11, r12, r13, r14, r15, r16, r17
    ldi r30, 0
    sbrs r17, 7
    rjmp .Lright
    ldi r30, 1 << LEFT
    clr r26
    com_bytes r10, 7
    com r17             // leaves a carry
    adc_each r10, r26, 8
.Lright:
    bst r25, 7
    brtc 1f
    negate_bytes r18, 8
1:  cp_bytes r18, r10, 8
    brlo 1f
    movw r26, r10
    movw r10, r18
    movw r18, r26
    movw r26, r12
    movw r12, r20
    movw r20, r26
    movw r26, r14
    movw r14, r22
    movw r22, r26
    movw r26, r16
    movw r16, r24
    movw r24, r26
    ori r30, 1 << STEEP
1:  push r30
    mov r0, r17
    or r0, r16
    or r0, r15
    or r0, r14
    brne 1f
    movw r16, r12
    movw r14, r10
    movw r24, r20
    movw r22, r18
    clr r10
    clr r11
    movw r12, r10
    movw r18, r10
    movw r20, r10
1:  mov r0, r17
    or r0, r16
    brne 1f
    movw_from_top r12, r10, 6
    movw_from_top r20, r18, 6
    clr r11
    clr r19
1:  tst r17
    brne 1f
    mov_from_top r12, r11, 6
    mov_from_top r20, r19, 6
    tst r17
    brne 1f
    pop r30             // y and x are 0, and so is r25:r18
    rjmp .Lreturn
1:  mov r30, r17
    lsr r30
    subi r30, 128
    ldi r31, hi8(fixedpoint_leading_one_table)
    lpm r26, Z
    mul d4, r26
    mov d4, r0
    mul_or_bytes d0, r26, d0, 4
    mul r12, r26
    or d0, r1
    mul n4, r26
    mov n4, r0
    mul_or_bytes n0, r26, n0, 4
    mul r20, r26
    or n0, r1
    // R
    clr nothing
    mov r30, d4
    mov fraction1, d3
    mov fraction0, d2
    lsl fraction0
    rol fraction1
    rol r30             // without the leading one
    ldi r31, hi8(fixedpoint_ratio_table)
    lpm_pages slope0, slope1, inverse1, inverse2, inverse0
    mul slope1, fraction0
    mov fall0, r1
    mul slope0, fraction1
    add fall0, r1
    clr fall1
    rol fall1
    mul_add slope1, fraction1, fall0, fall1
    sub inverse0, fall0
    sbc inverse1, fall1
    sbc inverse2, nothing
    ldi bias, 40
    sub inverse0, bias
    sbc inverse1, nothing
    sbc inverse2, nothing
    product_of_fractions g2, g1, g0, n4, n3, n2, inverse2, inverse1, inverse0
    lsl g0
    rol g1
    rol g2
    // Bytes 2 to 5 of g D in r25:r24:r19:r18
    mul g0, d2
    movw r18, r0
    clr r24
    mul_add g1, d1, r18, r19, nothing, r24
    mul_add g2, d0, r18, r19, nothing, r24
    clr r25
    mul_add g0, d3, r19, r24, nothing, r25
    mul_add g1, d2, r19, r24, nothing, r25
    mul_add g2, d1, r19, r24, nothing, r25
    mul_add g0, d4, r24, r25
    mul_add g1, d3, r24, r25
    mul_add g2, d2, r24, r25
    mul g1, d4
    add r25, r0
    mul g2, d3
    add r25, r0
    // The remainder, doubled, in r23:r22:r21
    neg r18
    sbc n0, r19
    sbc n1, r24
    sbc n2, r25
    lsl r18
    rol_bytes n0, 3
    ldi bias, 40
    add inverse0, bias
    adc inverse1, nothing
    adc inverse2, nothing
    product_of_fractions r18, r25, r24, n2, n1, n0, inverse2, inverse1, inverse0
    add g0, r18
    adc g1, nothing
    adc g2, nothing
    movw r22, r24
    movw r24, g0
    mov r30, g2
    brcc 1f
    ldi r22, 0xff
    ldi r23, 0xff
    movw r24, r22
    mov r30, r22
1:  clr zero
    find_record_64 fixedpoint_atan_64_table, r26
    XCALL fixedpoint_cubic_64
    clr r22
    pop r30
    cpi r30, 1 << LEFT
    brlo 1f
    breq 2f
    add_to_angle 863554413090
    rjmp 4f
1:  tst r30
    breq 4f
    subtract_angle_from 863554413090
    rjmp 4f
2:  subtract_angle_from 1727108826179
4:  lsl r26
    rol_bytes r18, 5
    brtc 5f
    com_bytes r18, 5
    increment_bytes r18, 5
5:  mov r23, r22
    lsl r23
    sbc r23, r23
    mov r24, r23
    mov r25, r23
    clr r1
.Lreturn:
    pop_all r17, r16, r15, r14, r13, r12, r11, r10
    ret
    ENDFUNC fixedpoint_atan2_q32_32
#endif
