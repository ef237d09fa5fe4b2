// SPDX-License-Identifier: MIT
// uint64_t fixedpoint_multiply_words(uint32_t a, uint32_t b)
// a b, exact.
//
// uint32_t fixedpoint_upper_product(uint32_t a, uint32_t b)
// Its upper word, which the calling convention returns in the same registers.
//
// In       a = r25:r22, b = r21:r18
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    3 bytes
//
// Row by row: the even products of a byte of b are adjacent, and so are the odd ones, and each set
// is added to the sum in one carry chain. A sum of j rows is below 2^(32 + 8 j), so the second
// chain of a row does not leave a carry.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define a0 r22
#define a1 r23
#define a2 r24
#define a3 r25
#define b0 r26
#define b1 r27
#define b2 r30
#define b3 r31
#define t0 r28
#define t1 r29
// Bytes of the sum; an upper one replaces a byte of b that is no longer needed.
#define s0 r18
#define s1 r19
#define s2 r20
#define s3 r21
#define s4 r17
#define s5 b0
#define s6 b1
#define s7 b2

    .macro row b, low0, low1, low2, low3, top
    mul a2, \b
    movw t0, r0
    mul a0, \b
    add \low0, r0
    adc \low1, r1
    adc \low2, t0
    adc \low3, t1
    ldi \top, 0
    adc \top, \top
    mul a3, \b
    movw t0, r0
    mul a1, \b
    add \low1, r0
    adc \low2, r1
    adc \low3, t0
    adc \top, t1
    .endm

    SECTION fixedpoint_multiply_words
    ENTRY fixedpoint_upper_product
    ENTRY fixedpoint_multiply_words
    push_all r17, r28, r29
    movw b0, r18
    movw b2, r20
    mul a0, b0
    movw s0, r0
    mul a2, b0
    movw s2, r0
    ldi s4, 0
    mul_add a1, b0, s1, s2, s4, s3
    mul_add a3, b0, s3, s4
    row b1, s1, s2, s3, s4, s5
    row b2, s2, s3, s4, s5, s6
    row b3, s3, s4, s5, s6, s7
    mov r22, s4
    mov r23, s5
    mov r24, s6
    mov r25, s7
    clr r1
    pop_all r29, r28, r17
    ret
    ENDFUNC fixedpoint_multiply_words
    ENDFUNC fixedpoint_upper_product
#endif
