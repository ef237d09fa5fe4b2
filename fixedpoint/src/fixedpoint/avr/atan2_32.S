// SPDX-License-Identifier: MIT
// int32_t fixedpoint_atan2_q<32 - F>_<F>(int32_t y, int32_t x)
// int32_t fixedpoint_atan_q<32 - F>_<F>(int32_t a)
// The angle of the vector (x, y) in (-pi, pi] and of (1, a), in every 32-bit format except Q16.16;
// within 0.55 ulp up to F = 28 and 0.75 ulp beyond, saturated; atan2(0, 0) = 0.
//
// In       y = r25:r22, x = r21:r18; a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    12 bytes
// Tables   3072 bytes, fixedpoint_atan_32_table; 512 bytes, fixedpoint_reciprocal_table
//
// The ratio of the shorter coordinate to the longer one, to 32 fraction bits, is the position in the
// arc tangent table; it is 2^32 - 1 if both are equal. Its base-256 digits are those of divide_32.S
// without signs, rounding and limits. Beyond F = 24 there are four, and the upper byte of the
// remainder is interpolated with the slope there. Up to F = 24 there are three, and that byte is the
// fourth: it is up to 2 less. The angle is then unfolded from the first octant.
//
// Error in units of 2^-31: up to F = 24 the 32-bit core (cubic_core_32.inc), the ratio -1.0, and 2 that
// are added; beyond, the 40-bit core 0.2.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "cubic_32.inc"
#include "ratio_32.inc"

    // r25:r22 = floor(2^32 n / d) for n = r25:r22 below d = r21:r18; r26 = the upper byte of the
    // remainder for the scaled divisor, which is 2^40 less at most a 256th. Changes r18..r21, r27,
    // r30, r31; r1 is not 0 at return.
    FUNCTION fixedpoint_ratio_32
    ratio_32
    ret
    ENDFUNC fixedpoint_ratio_32

    // The same, or up to 2 less, without a remainder.
    FUNCTION fixedpoint_rough_ratio_32
    ratio_32 rough
    ret
    ENDFUNC fixedpoint_rough_ratio_32

#define STEEP 0
#define LEFT 1

    // Adds a constant to the angle, which has five bytes or six.
    .macro turn fraction, value
    .if \fraction > 24
    add_constant 23, (\value + (1 << (38 - \fraction)))
    sbci r22, constant & 0xff
    .else
    add_constant 22, \value + (1 << (30 - \fraction))
    .endif
    .endm

    .macro kernels integer, fraction
    .if \fraction > 24
    .set half_pi, 863554413089
    .set pi, 1727108826179
    .set cut, 0
    .else
    .set half_pi, 3373259426
    .set pi, 6746518852
    .set cut, 2
    .endif
    SECTION fixedpoint_atan2_q\integer\()_\fraction
.Lequal_\fraction:
    or_bytes r0, n0, 4
    breq 1f
    ldi r22, 0xff
    ldi r23, 0xff
    movw r24, r22
    .if \fraction > 24
    ldi r26, 0xff
    .endif
.Lratio_is_known_\fraction:
    push r30
    rjmp .Llook_up_\fraction
1:  ret

    ENTRY fixedpoint_atan_q\integer\()_\fraction
    ldi r30, 0
    .if \fraction == 32
    // 1 does not fit in four bytes, and the numbers are their own ratios to it.
    ldi r26, 0
    bst n3, 7
    brtc .Lratio_is_known_\fraction
    negate_bytes n0, 4
    rjmp .Lratio_is_known_\fraction
    .else
    ldi_bytes r18, 1 << \fraction, 4
    rjmp .Lright_\fraction
    .endif
    ENDFUNC fixedpoint_atan_q\integer\()_\fraction

    ENTRY fixedpoint_atan2_q\integer\()_\fraction
    ldi r30, 0
    tst d3
    brpl .Lright_\fraction
    ldi r30, 1 << LEFT
    negate_bytes d0, 4
.Lright_\fraction:
    bst n3, 7
    brtc 1f
    negate_bytes n0, 4
1:  cp_bytes n0, d0, 4
    brlo 2f
    breq .Lequal_\fraction
    exchange_coordinates
    ori r30, 1 << STEEP
2:  push r30
    .if \fraction > 24
    XCALL fixedpoint_ratio_32
    .else
    XCALL fixedpoint_rough_ratio_32
    .endif
.Llook_up_\fraction:
    mov r30, r25
    mov_from_top r18, r22, 3
    find_record fixedpoint_atan_32_table, r22
    clr zero
    .if \fraction > 24
    push r26
    XCALL fixedpoint_cubic_40
    pop r0
    mul r22, r0
    add r23, r1
    adc_each r24, zero, 4
    clr r22
    .else
    XCALL fixedpoint_cubic_32
    clr r26
    .endif
    clr r1
    pop r20
    cpi r20, 1 << LEFT
    brlo 1f
    breq 2f
    turn \fraction, half_pi + cut
    rjmp 4f
1:  tst r20
    brne 3f
    turn \fraction, cut
    rjmp 4f
3:  turned_back \fraction
    turn \fraction, half_pi - cut + 1
    rjmp 4f
2:  turned_back \fraction
    turn \fraction, pi - cut + 1
4:
    .if \fraction > 24
    .if \fraction == 32
    lsl_bytes r23, 5
    rol r22
    .endif
    mov r18, r22
    movw r22, r24
    movw r24, r26
    mov r26, r18
    .endif
    .if \fraction > 29
    tst r26
    brne .Lsaturated_\fraction
    .if \fraction > 30
    cpi r25, 0x80
    brsh .Lsaturated_\fraction
    .endif
    .endif
    .if \fraction < 31
    shift_signed (31 - \fraction)
    .endif
    brtc 5f
    negate_bytes r22, 4
5:  ret
    .if \fraction > 29
.Lsaturated_\fraction:
    brts 1f
    XJMP fixedpoint_largest_32
1:  XJMP fixedpoint_smallest_32
    .endif
    ENDFUNC fixedpoint_atan2_q\integer\()_\fraction
    .endm

    // Prepares the subtraction of the angle from the constant added next: its one's complement is
    // -1 - angle.
    .macro turned_back fraction
    com_bytes r23, 4
    com r22
    .if \fraction > 24
    com r27
    .endif
    .endm

#include "splits_32.inc"

#endif
