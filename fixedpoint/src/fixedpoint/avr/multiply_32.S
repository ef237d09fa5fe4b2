// SPDX-License-Identifier: MIT
// int32_t fixedpoint_multiply_q<32 - F>_<F>(int32_t a, int32_t b)
// int32_t fixedpoint_multiply_add_q<32 - F>_<F>(int32_t a, int32_t b, int32_t c)
// floor(a b / 2^F + 1/2) modulo 2^32, plus c: the product rounded to nearest, half up, of every
// 32-bit format except Q16.16, which has a faster kernel of its own.
//
// In       a = r25:r22, b = r21:r18, c = r17:r14
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    2 bytes
//
// Column by column: byte k of the product is the sum of all a_i b_j with i + j = k, and the carries
// of a column reach at most two bytes up. The result is in five bytes of the product, from byte
// floor((F - 1) / 8) on, shifted to whole bytes by at most four bits in either direction; the last
// bit shifted out rounds. Bytes below the five only carry; bytes above are not computed.
//
// `mulsu` sets the carry to the sign of its product, which is subtracted from the byte above it.
// Bytes 5 and 6 each receive two such signs and start from 2, which is subtracted at the end: no
// sum is negative before that, and none needs sign extension. a1 b1 <= 0xfe01 absorbs the carries
// of the columns below, at most 0x1fd.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define a0 r22
#define a1 r23
#define a2 r16
#define a3 r17
#define zero r27
// Bytes of the sum; the first ones have been dropped when the last ones begin.
#define s0 r26
#define s1 r25
#define s2 r30
#define s3 r31
#define s4 r24
#define s5 r26
#define s6 r25
#define s7 r30

#include "round_32.inc"

    .macro signed_product p, q, low, high, carry
    mulsu \p, \q
    sbc \carry, zero
    add \low, r0
    adc \high, r1
    adc \carry, zero
    .endm
    .macro top_product multiplication, p, q, low, high
    \multiplication \p, \q
    add \low, r0
    adc \high, r1
    .endm
    .macro last_product p, q, low
    mul \p, \q
    add \low, r0
    .endm

    // The five bytes from `first` = 0..3 on.
    .macro five_bytes first
    movw a2, r24
    clr zero
    mul a0, rB0
    .if \first == 0
    mov s0, r0
    .endif
    mov s1, r1
    mul a1, rB1
    movw s2, r0
    mul_add a0, rB1, s1, s2, zero, s3
    mul_add a1, rB0, s1, s2, zero, s3
    clr s4
    mul_add a0, rB2, s2, s3, zero, s4
    mul_add a2, rB0, s2, s3, zero, s4
    .if \first == 0
    top_product mul, a1, rB2, s3, s4
    top_product mul, a2, rB1, s3, s4
    top_product mulsu, rB3, a0, s3, s4
    top_product mulsu, a3, rB0, s3, s4
    last_product a2, rB2, s4
    last_product rB3, a1, s4
    last_product a3, rB1, s4
    .else
    ldi s5, 2
    mul_add a1, rB2, s3, s4, zero, s5
    mul_add a2, rB1, s3, s4, zero, s5
    signed_product rB3, a0, s3, s4, s5
    signed_product a3, rB0, s3, s4, s5
    .if \first == 1
    top_product mul, a2, rB2, s4, s5
    top_product mulsu, rB3, a1, s4, s5
    top_product mulsu, a3, rB1, s4, s5
    last_product a2, rB3, s5
    last_product a3, rB2, s5
    subi s5, 2
    .else
    ldi s6, 2
    mul_add a2, rB2, s4, s5, zero, s6
    signed_product rB3, a1, s4, s5, s6
    signed_product a3, rB1, s4, s5, s6
    .if \first == 2
    top_product mulsu, rB3, a2, s5, s6
    top_product mulsu, a3, rB2, s5, s6
    last_product a3, rB3, s6
    subi s5, 2
    sbci s6, 2
    .else
    ldi s7, 2
    signed_product rB3, a2, s5, s6, s7
    signed_product a3, rB2, s5, s6, s7
    muls_add a3, rB3, s6, s7
    subi s5, 2
    sbci s6, 2
    sbci s7, 2
    .endif
    .endif
    .endif
    .endm

    .macro multiply fraction
    push r16
    push r17
    five_bytes ((\fraction - 1) / 8)
    clr r1
    round \fraction
    pop r17
    pop r16
    .endm

    .macro kernels integer, fraction
    FUNCTION fixedpoint_multiply_q\integer\()_\fraction
    multiply \fraction
    ret
    ENDFUNC fixedpoint_multiply_q\integer\()_\fraction

    FUNCTION fixedpoint_multiply_add_q\integer\()_\fraction
    multiply \fraction
    add_bytes r22, r14, 4
    ret
    ENDFUNC fixedpoint_multiply_add_q\integer\()_\fraction
    .endm

#include "splits_32.inc"

#endif
