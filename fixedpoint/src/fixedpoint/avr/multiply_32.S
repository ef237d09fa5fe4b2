// SPDX-License-Identifier: MIT
// int32_t fixedpoint_multiply_q<32 - F>_<F>(int32_t a, int32_t b)
// int32_t fixedpoint_multiply_add_q<32 - F>_<F>(int32_t a, int32_t b, int32_t c)
// uint32_t fixedpoint_multiply_u<32 - F>_<F>(uint32_t a, uint32_t b)
// floor(a b / 2^F + 1/2) modulo 2^32, plus c: the product rounded to nearest, half up, of every
// 32-bit format except Q16.16 and U16.16, which have faster kernels of their own.
//
// In       a = r25:r22, b = r21:r18, c = r17:r14
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    2 bytes
//
// The result is in five bytes of the product (columns_32.inc), from byte floor((F - 1) / 8) on, shifted
// to whole bytes by at most four bits either way; the bit that leaves last rounds. Bytes below the five
// only carry, bytes above are not formed.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include "columns_32.inc"
#include "round_32.inc"

    .macro multiply fraction
    push r16
    push r17
    movw a2, r24
    clr zero
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

    FUNCTION fixedpoint_multiply_u\integer\()_\fraction
    .set .Lis_signed, 0
    multiply \fraction
    .set .Lis_signed, 1
    ret
    ENDFUNC fixedpoint_multiply_u\integer\()_\fraction
    .endm

#include "splits_32.inc"

#endif
