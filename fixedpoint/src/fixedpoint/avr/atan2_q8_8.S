// SPDX-License-Identifier: MIT
// int16_t fixedpoint_atan2_q8_8(int16_t y, int16_t x)
// int16_t fixedpoint_atan_q8_8(int16_t a)
// The angle of the vector (x, y), or (1, a), in radians, in (-pi, pi], within 0.5494 ulp (exact, over
// all pairs); 0 for (0, 0).
//
// In:       y or a r25:r24, x r23:r22
// Out:      r25:r24
// Clobbers: r0, r18..r23, r26, r27, r30, r31
// Stack:    0 bytes.
//
// The smaller coordinate times the reciprocal of the larger one, both shifted left so that the
// leading one of the larger is in bit 15, is the ratio t in 15 bits. It is below 1, since the
// reciprocal is always slightly less than 1 / larger. Reciprocal and arc tangent are interpolated
// linearly on 128 intervals each (3 loads and a multiplication); atan2_q8_8.py generates the
// tables. portable/atan2_q8_8.hpp is the same, bit for bit.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define small0 r24
#define small1 r25
#define large0 r22
#define large1 r23
#define sign_y r20
#define sign_x r21
#define value0 r18
#define value1 r19
#define t0 r26
#define t1 r27
#define zero r31
// 2^16 pi and half of it, plus half an ulp.
#define PI 206015
#define HALF_PI 103072

    // value1:value0 and r0 = the entry for r30 in the table of chords, whose bytes are in separate
    // pages.
    .macro load_chord
    ldi r31, hi8(fixedpoint_atan2_q8_8_table)
    lpm_pages value0, value1, r0
    .endm

    SECTION fixedpoint_atan2_q8_8
    ENTRY fixedpoint_atan_q8_8
    ldi large0, 0
    ldi large1, 1
    ENDFUNC fixedpoint_atan_q8_8

    ENTRY fixedpoint_atan2_q8_8
    mov sign_y, small1
    mov sign_x, large1
    tst small1
    brpl 1f
    com small1
    neg small0
    sbci small1, 0xff
1:  tst large1
    brpl 1f
    com large1
    neg large0
    sbci large1, 0xff
1:  clt
    cp large0, small0
    cpc large1, small1
    brsh 1f
    set
    movw r26, small0
    movw small0, large0
    movw large0, r26
1:  tst large1
    brne .Lnormalise
    tst large0
    brne 1f
    ret
1:  mov large1, large0
    mov small1, small0
    clr large0
    clr small0

    // large and small = 2^k large and 2^k small, with the leading one of large in bit 15.
.Lnormalise:
    mov r30, large1
    ldi r31, hi8(fixedpoint_long_division_table)
    ldi r26, 1
    sbrs large1, 7
    lpm r26, Z
    mul large1, r26
    mov large1, r0
    mul large0, r26
    mov large0, r0
    or large1, r1
    mul small1, r26
    mov small1, r0
    mul small0, r26
    mov small0, r0
    or small1, r1

    // value = 2^30 / large
    mov r30, large1
    load_chord
    mul r0, large0
    sub value0, r1
    sbci value1, 0

    // t = 2^15 small / large, less than 2^15
    clr zero
    mul small1, value1
    movw t0, r0
    mul_add_upper small1, value0, t0, zero, t1
    mul_add_upper small0, value1, t0, zero, t1
    lsl t0
    rol t1

    // value = 2^16 atan(small / large)
    mov r30, t1
    load_chord
    mul r0, t0
    add value0, r1
    clr r1
    adc value1, r1
    add value0, t0
    adc value1, t1

    brts .Lsteep
    tst sign_x
    brmi .Lleft
    lsl value0
    adc value1, r1
    mov r24, value1
    clr r25
    rjmp .Lsign
.Lleft:
    ldi r26, lo8(PI)
    ldi r24, hi8(PI)
    ldi r25, hlo8(PI)
    rjmp .Lsubtract
.Lsteep:
    ldi r26, lo8(HALF_PI)
    ldi r24, hi8(HALF_PI)
    ldi r25, hlo8(HALF_PI)
    tst sign_x
    brmi .Ladd
.Lsubtract:
    sub r26, value0
    sbc r24, value1
    sbc r25, r1
    rjmp .Lsign
.Ladd:
    add r26, value0
    adc r24, value1
    adc r25, r1
.Lsign:
    tst sign_y
    brmi 1f
    ret
1:  com r25
    neg r24
    sbci r25, 0xff
    ret
    ENDFUNC fixedpoint_atan2_q8_8

#endif
