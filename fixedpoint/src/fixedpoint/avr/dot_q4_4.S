// SPDX-License-Identifier: MIT
// int8_t fixedpoint_dot2_q4_4(const int8_t* a, const int8_t* b)
// int8_t fixedpoint_dot3_q4_4(const int8_t* a, const int8_t* b)
// floor(sum a_i b_i / 2^4 + 1/2) modulo 2^8 of 2 or 3 components, one rounding.
//
// In:       a r25:r24, b r23:r22, in RAM
// Out:      r24
// Clobbers: r0, r18..r21, r25..r27, r30, r31
// Stack:    0 bytes.
//
// The sum modulo 2^16 is enough: the result is its bits 11..4.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define a r18
#define b r19
#define s0 r24
#define s1 r25

    // s1:s0 = the first product; X and Z point to the next ones.
    .macro first_product
    movw r26, r24
    movw r30, r22
    ld a, X+
    ld b, Z+
    muls a, b
    movw s0, r0
    .endm
    .macro add_product
    ld a, X+
    ld b, Z+
    muls_add a, b, s0, s1
    .endm

    SECTION fixedpoint_dot_q4_4
    ENTRY fixedpoint_dot3_q4_4
    first_product
    add_product
    rjmp .Llast
    ENDFUNC fixedpoint_dot3_q4_4

    ENTRY fixedpoint_dot2_q4_4
    first_product
.Llast:
    add_product
    clr r1
    subi s0, -8
    sbci s1, -1
    andi s0, 0xf0
    andi s1, 0x0f
    or s0, s1
    swap s0
    ret
    ENDFUNC fixedpoint_dot2_q4_4

#endif
