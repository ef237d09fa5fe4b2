// SPDX-License-Identifier: MIT
// int16_t fixedpoint_multiply_q<16 - F>_<F>(int16_t a, int16_t b)
// uint16_t fixedpoint_multiply_u<16 - F>_<F>(uint16_t a, uint16_t b)
// floor(a b / 2^F + 1/2) modulo 2^16: the product rounded to nearest, half up, of every 16-bit
// format except Q8.8 and U8.8, which have faster kernels of their own.
//
// In       a = r25:r24, b = r23:r22
// Out      r25:r24
// Changes  r0, r19..r21, r26, r27; r1 is 0 again at return
//
// The result is in three of the four bytes of the product, from byte floor((F - 1) / 8) on, shifted
// to whole bytes by at most four bits in either direction; the last bit shifted out rounds.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define a0 r20
#define a1 r21
#define b0 r22
#define b1 r23
#define any r19
#define zero r19
#define p0 r24
#define p1 r25
#define p2 r26
#define p3 r27

    // p1:p0 and p2, and p3 if `has_top`. Adding a carry to p3 needs no zero: what `any` holds has been
    // subtracted before.
    .macro product has_top
    movw a0, r24
    muls a1, b1
    movw p2, r0
    mul a0, b0
    movw p0, r0
    add_signed_product a1, b0, \has_top
    add_signed_product b1, a0, \has_top
    clr r1
    .endm
    .macro add_signed_product p, q, has_top
    mulsu \p, \q
    .if \has_top
    sbc p3, any
    .endif
    add p1, r0
    adc p2, r1
    .if \has_top
    adc p3, any
    .endif
    .endm

    .macro unsigned_product has_top
    movw a0, r24
    mul a1, b1
    movw p2, r0
    mul a0, b0
    movw p0, r0
    .if \has_top
    clr zero
    mul_add a1, b0, p1, p2, zero, p3
    mul_add b1, a0, p1, p2, zero, p3
    .else
    mul_add a1, b0, p1, p2
    mul_add b1, a0, p1, p2
    .endif
    clr r1
    .endm

    // high:middle:low / 2^(8 - left), rounded, of which the lower two bytes count.
    .macro round_bytes left, low, middle, high
    .if \left < 5
    .rept \left
    lsl \low
    rol \middle
    rol \high
    .endr
    lsl \low
    move \middle, \high
    .else
    .rept 8 - \left
    lsr \high
    ror \middle
    ror \low
    .endr
    move \low, \middle
    .endif
    .if \left < 8
    adc r24, r1
    adc r25, r1
    .endif
    .endm
    .macro move low, high
    .ifnc \low, r24
    mov r24, \low
    mov r25, \high
    .endif
    .endm

    .macro kernel name, product, fraction
    FUNCTION \name
    \product ((\fraction - 1) / 8)
    .if (\fraction - 1) / 8 == 0
    round_bytes (8 - \fraction), p0, p1, p2
    .else
    round_bytes (16 - \fraction), p1, p2, p3
    .endif
    ret
    ENDFUNC \name
    .endm
    .macro kernels integer, fraction
    kernel fixedpoint_multiply_q\integer\()_\fraction, product, \fraction
    kernel fixedpoint_multiply_u\integer\()_\fraction, unsigned_product, \fraction
    .endm

#include "splits_16.inc"

#endif
