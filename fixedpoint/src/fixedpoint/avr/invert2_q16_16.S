// SPDX-License-Identifier: MIT
// uint8_t fixedpoint_invert2_q16_16(const int32_t* a, int32_t* inverse)
// Writes the inverse of a 2x2 matrix (blocks/matrix.hpp) and returns 1; if the rounded determinant
// is 0, only returns 0.
//
// In       a = r25:r24, inverse = r23:r22, in RAM; inverse may be a
// Out      r24
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    16 bytes and a call
//
// The column (a11, -a10) of cofactors is kept on the stack, for the determinant and as two
// numerators. Each quotient overwrites only an element that is no longer needed.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define SPL 0x3d
#define SPH 0x3e
#define matrix r12
#define d0 r14
#define d2 r16

    .macro store_quotient place
    movw rB0, d0
    movw rB2, d2
    XCALL fixedpoint_divide_q16_16
    std_bytes Y + \place, rA0, 4
    .endm

    SECTION fixedpoint_invert2_q16_16
    // No inverse: the column is dropped, which leaves 0.
.Lsingular:
    ldi r24, 8
1:  pop r0
    dec r24
    brne 1b
    rjmp .Lreturn

    ENTRY fixedpoint_invert2_q16_16
    push_all r12, r13, r14, r15, r16, r17, r28, r29
    movw r28, r22
    movw matrix, r24
    movw r30, r24
    ldd_bytes r18, Z + 8, 4
    negate_bytes r18, 4
    push_all r21, r20, r19, r18
    ldd_bytes r18, Z + 12, 4
    push_all r21, r20, r19, r18
    in r22, SPL
    in r23, SPH
    subi r22, 0xff      // what was pushed last
    sbci r23, 0xff
    XCALL fixedpoint_dot2_q16_16
    movw d0, rA0
    movw d2, rA2
    or_bytes r0, rA0, 4
    breq .Lsingular
    movw r30, matrix
    ldd_bytes rA0, Z + 0, 4
    store_quotient 12
    pop_all rA0, rA1, rA2, rA3
    store_quotient 0
    movw r30, matrix
    ldd_bytes rA0, Z + 4, 4
    negate_bytes rA0, 4
    store_quotient 4
    pop_all rA0, rA1, rA2, rA3
    store_quotient 8
    ldi r24, 1
.Lreturn:
    pop_all r29, r28, r17, r16, r15, r14, r13, r12
    ret
    ENDFUNC fixedpoint_invert2_q16_16

#endif
