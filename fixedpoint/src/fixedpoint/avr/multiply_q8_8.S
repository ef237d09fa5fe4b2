// SPDX-License-Identifier: MIT
// int16_t fixedpoint_multiply_q8_8(int16_t a, int16_t b)
// uint16_t fixedpoint_multiply_u8_8(uint16_t a, uint16_t b)
// floor(a b / 2^8 + 1/2) modulo 2^16.
//
// In:       a r25:r24, b r23:r22
// Out:      r25:r24
// Clobbers: r0, r20, r21
// Stack:    0 bytes.
//
// The four byte products, of which bits 23..8 count. mulsu makes the middle two signed; it takes
// only r16..r23, hence the copy of a. The lowest product comes last: its bit 7 rounds, and r1,
// which must be cleared for the caller anyway, is the zero that the carry needs.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    FUNCTION fixedpoint_multiply_q8_8
    movw r20, r24
    mulsu r21, r22
    movw r24, r0
    mulsu_add r23, r20, r24, r25
    mul r21, r23
    add r25, r0
    mul r20, r22
    lsl r0
    adc r24, r1
    clr r1
    adc r25, r1
    ret
    ENDFUNC fixedpoint_multiply_q8_8

    FUNCTION fixedpoint_multiply_u8_8
    mul r25, r22
    movw r20, r0
    mul_add r24, r23, r20, r21
    mul r25, r23
    add r21, r0
    mul r24, r22
    lsl r0
    adc r20, r1
    clr r1
    adc r21, r1
    movw r24, r20
    ret
    ENDFUNC fixedpoint_multiply_u8_8

#endif
