// SPDX-License-Identifier: MIT
// bool fixedpoint_angle_reaches_q16_16(int32_t y, int32_t x, uint32_t tie)
// Whether the magnitude of the angle of (x, y), of any common unit, is at least a tie: an odd
// multiple of 2^-17, or a multiple of 2^-16, given in units of 2^-32 modulo 1. Requires that the
// two differ by at most 2^-26.
//
// In       y = r25:r22, x = r21:r18, tie = r17:r14
// Out      r24
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    49 bytes
// Tables   792 bytes, fixedpoint_short_turns_table
//
// The tie, mirrored into the first octant, is reduced by angles whose tangents are the digits
// c / 16, f / 256, g / 4096 and h / 65536, to a rest below 2^-16. The vector is turned back by the
// same angles:
//     (x, y) <- (x + y d, y - x d),
// which is exact, as the digits add 47 bits to the 32 of the longer coordinate. Then y is compared
// with x times the tangent of the rest, which is rest + rest^3 / 3.
//
// In units of 2^-88, the tangent errs by up to 3 for the angles, 16 for the products and 35 for
// the terms that follow, and the product, where x is a quarter or more, by 18: less than 2^-80 of x
// together. No direction of Q16.16 is closer to a tie than 2^-79.6, unless it is one.
// bench/prove_nearest_angles shows of each tie that this suffices.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define SPL 0x3d
#define SPH 0x3e
#define SREG 0x3f
// The coordinates, later the shorter and the longer one.
#define n0 r22
#define n3 r25
#define d0 r18
#define d3 r21
// Bit 0 is set if the angle is subtracted from a constant.
#define octant r30
#define MIRRORED 0
#define STEEP 1
#define LEFT 2
// The angle in units of 2^-88, later without its upper two bytes.
#define a0 r7
#define a4 r11
#define a9 r16
#define a10 r17
// The places of the entries in the table.
#define FINE 16
#define THIRD (FINE + 17)
#define FOURTH (THIRD + 16)
#define HALF_PI (FOURTH + 21)
#define PI (HALF_PI + 1)
// The turned vector in units of 2^-80, as a fraction of 2^80.
#define x0 r2
#define y0 r12
#define digit r24
#define zero r31
#define carry_x r26
#define carry_y r27
// Above the stack pointer, once everything is there: the tangent, the digits, the octant, y and x.
#define TANGENT 1
#define DIGITS 10
#define OCTANT 14
#define SHORTER 15
#define LONGER 19
#define FRAME 22

#include "fraction_product.inc"

    // X[to] += Y[from] digit and Y[to] -= X[from] digit, by bytes.
    .macro turn_byte from, to
    mul .Lr12 + \from, digit
    add r0, carry_x
    adc r1, zero
    add .Lr2 + \to, r0
    adc r1, zero
    mov carry_x, r1
    mul .Lr2 + \from, digit
    add r0, carry_y
    adc r1, zero
    sub .Lr12 + \to, r0
    adc r1, zero
    mov carry_y, r1
    .endm

    SECTION fixedpoint_angle_reaches_q16_16
    // angle -= the entry of that number.
.Lsubtract:
    ldi r25, 11
    mul r24, r25
    movw r30, r0
    subi r30, lo8(-(fixedpoint_short_turns_table))
    sbci r31, hi8(-(fixedpoint_short_turns_table))
    lpm r0, Z+
    sub a0, r0
    .irp byte, r8, r9, r10, r11, r12, r13, r14, r15, r16, r17
    lpm r0, Z+
    sbc \byte, r0
    .endr
    ret

    // r30:r26 = the product of the fractions r6:r2 and r22:r18
.Lproduct:
    clr zero
    fraction_product 6, 22, 5
    ret

    // By the digit / 256 and by the digit / 65536.
.Lturn_by_256th:
    clr carry_x
    clr carry_y
    .irp byte, 5, 6, 7, 8, 9
    turn_byte \byte, \byte - 1
    .endr
    add r11, carry_x
    sub r21, carry_y
    ret
.Lturn_by_65536th:
    clr carry_x
    clr carry_y
    .irp byte, 2, 3, 4, 5, 6, 7, 8
    turn_byte \byte, \byte - 2
    .endr
    mul r11, digit
    add r0, carry_y
    adc r1, zero
    sub r19, r0
    sbc r20, r1
    sbc r21, zero
    add r9, carry_x
    adc r10, zero
    adc r11, zero
    ret

    ENTRY fixedpoint_angle_reaches_q16_16
    push_all r2, r3, r4, r5, r6, r7, r8, r9, r10, r11, r12, r13, r14, r15, r16, r17, r28, r29
    ldi octant, 0
    tst d3
    brpl 1f
    ldi octant, 1 << LEFT | 1 << MIRRORED
    negate_bytes d0, 4
1:  tst n3
    brpl 1f
    negate_bytes n0, 4
1:  cp_bytes d0, n0, 4
    brsh 2f
    movw r26, n0
    movw n0, d0
    movw d0, r26
    movw r26, r24
    movw r24, r20
    movw r20, r26
    ldi r31, 1 << STEEP | 1 << MIRRORED
    eor octant, r31
    rjmp 2f
    // The longer coordinate gets 32 bits.
1:  mov_from_top r19, d0, 3
    clr d0
    mov_from_top r23, n0, 3
    clr n0
2:  tst d3
    breq 1b
    brmi 2f
1:  lsl_bytes n0, 4
    lsl_bytes d0, 4
    brpl 1b
2:  push_all r21, r20, r19, r18, r25, r24, r23, r22
    push octant
    // tie, pi - tie, pi/2 - tie or tie - pi/2; a difference is 2^-88 lower.
    clr_bytes a0, 7
    ldi r24, 0
    sbrc octant, LEFT
    ldi r24, PI
    sbrc octant, STEEP
    ldi r24, HALF_PI
    bst octant, MIRRORED
    rcall .Lsubtract
    brtc 1f
    com_bytes a0, 11
    // tan x >= x + x^3 / 3
1:  mul a10, a10
    mul r1, a10
    ldi r24, 85
    mul r1, r24
    mov r24, a10
    add r24, r1
    andi r24, 0xf0
    push r24
    swap r24
    rcall .Lsubtract
    mov r24, a10
    push r24
    subi r24, 0x100 - FINE
    rcall .Lsubtract
    mov r24, a9
    andi r24, 0xf0
    sbrc a10, 0
    ldi r24, 0xf0
    push r24
    swap r24
    subi r24, 0x100 - THIRD
    rcall .Lsubtract
    mov r24, a9
    push r24
    subi r24, 0x100 - FOURTH
    rcall .Lsubtract
    // The square of the rest, its cube, and a third of that.
    mov_bytes r2, a4, 5
    mov_bytes r18, a4, 5
    rcall .Lproduct
    mov_bytes r18, r26, 5
    rcall .Lproduct
    mov_bytes r18, r26, 5
    ldi r24, 0x55
    .irp byte, r2, r3, r4, r5, r6
    mov \byte, r24
    .endr
    rcall .Lproduct
    add_bytes a0, r26, 5
    .irp byte, r12, r13, r14, r15
    adc \byte, zero
    .endr
    push_all r15, r14, r13, r12, r11, r10, r9, r8, r7
    in r28, SPL
    in r29, SPH
    // Half of the coordinates, as the sum of the two may exceed 1.
    clr_bytes x0, 6
    ldd_bytes r8, Y + LONGER, 4
    lsr_bytes r7, 5
    clr_bytes y0, 6
    ldd_bytes r18, Y + SHORTER, 4
    lsr_bytes r17, 5
    ldd digit, Y + DIGITS + 3
    rcall .Lturn_by_256th
    ldd digit, Y + DIGITS + 2
    rcall .Lturn_by_256th
    ldd digit, Y + DIGITS + 1
    rcall .Lturn_by_65536th
    ldd digit, Y + DIGITS
    rcall .Lturn_by_65536th
    // The lowest byte of x does not matter.
    push_all r20, r19, r18, r17, r16, r15, r14, r13, r12
    ldd_bytes r12, Y + TANGENT, 9
    fraction_product 11, 20, 9, 21
    neg r21
    .irp byte, r22, r23, r24, r25, r26, r27, r28, r29, zero
    pop r0
    sbc r0, \byte
    .endr
    // Bit 0 is whether the direction is above the tie's; measuring from the y axis or from the left
    // swaps the sides.
    in r30, SPL
    in r31, SPH
    ldd r24, Z + OCTANT
    sbrs r0, 7
    inc r24
    andi r24, 1
    adiw r30, FRAME
    in r0, SREG
    cli
    out SPH, r31
    out SREG, r0
    out SPL, r30
    clr r1
    pop_all r29, r28, r17, r16, r15, r14, r13, r12, r11, r10, r9, r8, r7, r6, r5, r4, r3, r2
    ret
    ENDFUNC fixedpoint_angle_reaches_q16_16
#endif
