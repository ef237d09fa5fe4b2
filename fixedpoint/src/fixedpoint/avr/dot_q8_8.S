// SPDX-License-Identifier: MIT
// int16_t fixedpoint_dot2_q8_8(const int16_t* a, const int16_t* b)
// int16_t fixedpoint_dot3_q8_8(const int16_t* a, const int16_t* b)
// floor(sum a_i b_i / 2^8 + 1/2) modulo 2^16 of 2 or 3 components, one rounding.
//
// In:       a r25:r24, b r23:r22, in RAM
// Out:      r25:r24
// Clobbers: r0, r18..r27, r30, r31
// Stack:    0 bytes.
//
// Bits 23..0 of the exact sum are formed; higher bits are beyond the result. So only the product of
// the low bytes carries past its own two bytes.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define a0 r18
#define a1 r19
#define b0 r20
#define b1 r21
#define s0 r22
#define s1 r24
#define s2 r25
#define zero r23

    .macro begin
    movw r26, r24
    movw r30, r22
    clr zero
    clr s0
    clr s1
    clr s2
    .endm

    .macro add_product
    ld a0, X+
    ld a1, X+
    ld b0, Z+
    ld b1, Z+
    mul_add a0, b0, s0, s1, zero, s2
    mulsu_add a1, b0, s1, s2
    mulsu_add b1, a0, s1, s2
    mul a1, b1
    add s2, r0
    .endm

    SECTION fixedpoint_dot_q8_8
    ENTRY fixedpoint_dot3_q8_8
    begin
    add_product
    rjmp .Lsecond
    ENDFUNC fixedpoint_dot3_q8_8

    ENTRY fixedpoint_dot2_q8_8
    begin
.Lsecond:
    add_product
    add_product
    clr r1
    lsl s0
    adc s1, r1
    adc s2, r1
    ret
    ENDFUNC fixedpoint_dot2_q8_8

#endif
