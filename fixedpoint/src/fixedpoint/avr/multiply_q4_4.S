// SPDX-License-Identifier: MIT
// int8_t fixedpoint_multiply_q4_4(int8_t a, int8_t b)
// uint8_t fixedpoint_multiply_u4_4(uint8_t a, uint8_t b)
// floor(a b / 2^4 + 1/2) modulo 2^8.
//
// In:       a r24, b r22
// Out:      r24
// Clobbers: r0
// Stack:    0 bytes.
//
// The result is bits 11..4 of the product: the high byte's low nibble and the low byte's high
// nibble, which one swap puts in place, plus one if bit 3 is set.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    .macro kernel name, multiplication
    FUNCTION \name
    \multiplication r24, r22
    mov r24, r0
    eor r24, r1
    andi r24, 0xf0
    eor r24, r1
    swap r24
    sbrc r0, 3
    inc r24
    clr r1
    ret
    ENDFUNC \name
    .endm
    kernel fixedpoint_multiply_q4_4, muls
    kernel fixedpoint_multiply_u4_4, mul

#endif
