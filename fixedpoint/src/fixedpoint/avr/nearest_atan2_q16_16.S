// SPDX-License-Identifier: MIT
// int32_t fixedpoint_atan2_q16_16_correctly_rounded(int32_t y, int32_t x)
// int32_t fixedpoint_atan_q16_16_correctly_rounded(int32_t a)
// The angle of the vector (x, y) in (-pi, pi] and of (1, a), of Q16.16; within 0.5 ulp; atan2(0, 0) = 0.
//
// In       y = r25:r22, x = r21:r18; a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    15 bytes, of atan 11; 59 in close cases
// Tables   3072 bytes, fixedpoint_atan_32_table; 512 bytes, fixedpoint_reciprocal_table
//
// As in atan2_32.S; a below 1 is the ratio. The operands are kept on the stack for
// angle_reaches_q16_16.S, which decides close cases.
//
// Error in units of 2^-31: the 32-bit core (cubic_core_32.inc), the ratio -1.0, pi 0.3.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include <fixedpoint/portable/doubt.hpp>
#include "cubic_32.inc"
#include "cubic_core_32.inc"
#include "ratio_32.inc"

// y is n0, later the shorter coordinate, x is d0, later the longer one.
#define octant r30
#define STEEP 0
#define LEFT 1
#define ONE_OPERAND 2
// In units of 2^-31.
#define HALF_PI 3373259426
#define PI 6746518852

    // Prepares the subtraction of the angle from the constant added next: its one's complement is
    // -1 - angle.
    .macro turned_back
    com_bytes r22, 5
    .endm
    // One unit of the constant is for the truncation in the core.
    .macro turn value
    add_constant 22, \value + (1 << 14) + FIXEDPOINT_DOUBT
    .endm

    SECTION fixedpoint_atan2_q16_16_correctly_rounded
    ENTRY fixedpoint_atan_q16_16_correctly_rounded
    push_all r22, r23, r24, r25
    ldi octant, 1 << ONE_OPERAND
    bst n3, 7
    brtc 1f
    negate_bytes n0, 4
1:  ldi_bytes d0, 0x10000, 4
    cp n2, d0
    cpc n3, d0
    brne .Lcompare
    movw r24, r22
    clr r22
    clr r23
.Lratio_is_known:
    push octant
    rjmp .Llook_up
    ENDFUNC fixedpoint_atan_q16_16_correctly_rounded
.Lequal:
    or_bytes r0, n0, 4
    breq 1f
    ldi r22, 0xff
    ldi r23, 0xff
    movw r24, r22
    rjmp .Lratio_is_known
1:  mov r20, octant
    rjmp .Lrounded

    ENTRY fixedpoint_atan2_q16_16_correctly_rounded
    push_all r18, r19, r20, r21, r22, r23, r24, r25
    ldi octant, 0
    tst d3
    brpl 1f
    ldi octant, 1 << LEFT
    negate_bytes d0, 4
1:  bst n3, 7
    brtc .Lcompare
    negate_bytes n0, 4
.Lcompare:
    cp_bytes n0, d0, 4
    brlo 1f
    breq .Lequal
    exchange_coordinates
    ori octant, 1 << STEEP
1:  push octant
    ratio_32 rough
.Llook_up:
    mov r30, r25
    mov_from_top r18, r22, 3
    find_record fixedpoint_atan_32_table, r22
    clr zero
    cubic_32
    clr r26
    clr r1
    pop r20
    sbrc r20, STEEP
    rjmp 2f
    sbrc r20, LEFT
    rjmp 1f
    turn 1
    rjmp 4f
1:  turned_back
    turn PI
    rjmp 4f
2:  sbrc r20, LEFT
    rjmp 3f
    turned_back
    turn HALF_PI
    rjmp 4f
3:  turn HALF_PI + 1
4:  lsl_bytes r23, 4
    tst r23
    breq .Lalmost_a_tie
.Lcertain:
    movw r22, r24
    mov r24, r26
    ldi r25, 0
.Lrounded:
    pop_all r0, r0, r0, r0
    sbrc r20, ONE_OPERAND
    rjmp 1f
    pop_all r0, r0, r0, r0
1:  brts .Lnegative
    ret
.Lnegative:
    negate_bytes r22, 3
    sbc r25, r25
    ret

.Lalmost_a_tie:
    cpi r22, 2 * FIXEDPOINT_DOUBT
    brsh .Lcertain
    // r26:r30 = the number below the tie
    movw r30, r24
    sbiw r30, 1
    sbc r26, r1
    pop_all r25, r24, r23, r22
    sbrs r20, ONE_OPERAND
    rjmp 1f
    ldi_bytes r18, 0x10000, 4
    rjmp 2f
1:  pop_all r21, r20, r19, r18
2:  push_all r14, r15, r16, r17, r30, r31, r26, r25
    movw r16, r30
    clr r14
    ldi r31, 0x80
    mov r15, r31
    XCALL fixedpoint_angle_reaches_q16_16
    pop r0
    bst r0, 7
    mov r0, r24
    pop_all r24, r23, r22, r17, r16, r15, r14
    ldi r25, 0
    add r22, r0
    adc r23, r1
    adc r24, r1
    brts .Lnegative
    ret
    ENDFUNC fixedpoint_atan2_q16_16_correctly_rounded
#endif
