// SPDX-License-Identifier: MIT
// int64_t fixedpoint_atan2_64(int64_t y, int64_t x, uint8_t fraction)
// The angle of the vector (x, y) in radians with `fraction` fraction bits, within 0.7 ulp; 0 for
// the zero vector. fraction must be in 31..56.
//
// In       y = r25:r18, x = r17:r10, fraction = r8
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    46 bytes
// Tables   2944 bytes, fixedpoint_septic_atan_table; that of divide_64.S
//
// The ratio of the smaller side to the larger one, by divide_64 with 63 fraction bits, is the
// position in the table. An angle has nine bytes until it is rounded.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "septic_64.inc"

#define flags r28
#define BELOW 0
#define LEFT 1
#define STEEP 2

    // r17 and r25:r18 = an angle, in units of 2^-63, minus that; its bytes are given from the
    // lowest on.
    .macro subtract_from b0, b1, b2, b3, b4, b5, b6, b7, b8
    .irp n, 18, 19, 20, 21, 22, 23, 24, 25, 17
    com r\n
    .endr
    subi r18, 0xff - \b0
    sbci r19, 0xff - \b1
    sbci r20, 0xff - \b2
    sbci r21, 0xff - \b3
    sbci r22, 0xff - \b4
    sbci r23, 0xff - \b5
    sbci r24, 0xff - \b6
    sbci r25, 0xff - \b7
    sbci r17, 0xff - \b8
    .endm

    FUNCTION fixedpoint_atan2_64
    save_registers
    mov r29, r8
    clr zero
    ldi flags, 0
    tst r25
    brpl 1f
    ldi flags, 1 << BELOW
    negate_bytes r18, 8
1:  tst r17
    brpl 1f
    ori flags, 1 << LEFT
    .irp n, 10, 11, 12, 13, 14, 15, 16, 17
    com r\n
    .endr
    .irp n, 10, 11, 12, 13, 14, 15, 16, 17
    adc r\n, zero
    .endr
1:  cp r10, r18
    .irp n, 11, 12, 13, 14, 15, 16, 17
    cpc \n, \n + 8
    .endr
    brcc 1f
    ori flags, 1 << STEEP
    movw r30, r18
    movw r18, r10
    movw r10, r30
    movw r30, r20
    movw r20, r12
    movw r12, r30
    movw r30, r22
    movw r22, r14
    movw r14, r30
    movw r30, r24
    movw r24, r16
    movw r16, r30
1:  tst r17
    brpl 1f
    .irp n, 17, 16, 15, 14, 13, 12, 11, 10
    .if \n == 17
    lsr r\n
    .else
    ror r\n
    .endif
    .endr
    lsr r25
    .irp n, 24, 23, 22, 21, 20, 19, 18
    ror r\n
    .endr
1:  ldi r30, 63
    mov r8, r30
    XCALL fixedpoint_divide_64
    lsl r18
    .irp n, 19, 20, 21, 22, 23, 24, 25
    rol r\n
    .endr
    evaluate fixedpoint_septic_atan_table
    clr r17
    sbrs flags, STEEP
    rjmp 1f
    subtract_from 0x35, 0xc2, 0x68, 0x21, 0xa2, 0xda, 0x0f, 0xc9, 0x00
1:  sbrs flags, LEFT
    rjmp 1f
    subtract_from 0x6a, 0x84, 0xd1, 0x42, 0x44, 0xb5, 0x1f, 0x92, 0x01
1:  round_from 63
    sbrs flags, BELOW
    rjmp 1f
    negate_bytes r18, 8
1:  restore_registers
    ret
    ENDFUNC fixedpoint_atan2_64
#endif
