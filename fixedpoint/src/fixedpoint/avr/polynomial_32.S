// SPDX-License-Identifier: MIT
// int32_t fixedpoint_polynomial_q<32 - F>_<F>(int32_t x, const int32_t* c, uint16_t n)
// Horner's rule: p = c[n - 1], then for i = n - 2 .. 0
// p = floor(p x / 2^F + 1/2) + c[i] modulo 2^32, whatever the fraction bits of p and c are. For
// every 32-bit format but Q16.16, whose own kernel is faster.
//
// In       x = r25:r22, c = r21:r20 in program memory, n = r19:r18; n must be at least 1
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    6 or 7 bytes
//
// p is a and x is b of columns_32.inc. The result is in five bytes of the product, from byte
// floor((F - 1) / 8) on, as in multiply_32.S. With 17 to 24 fraction bits the highest byte of x is
// mostly 0 or -1, which needs no multiplication; T indicates that it is not 0.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define s2 r14
#define s3 r15
#define s7 r28
#include "columns_32.inc"

// The address after the last coefficient to be used.
#define end r12

    // a = the coefficient at Z; Z moves past it.
    .macro take_coefficient
    lpm_each a0, Z+, 2
    lpm_each a2, Z+, 2
    .endm

    .macro polynomial fraction
    push_all r12, r13, r14, r15, r16, r17
    .if \fraction > 24
    push s7
    .endif
    movw r30, r18       // c + 4 (n - 1)
    sbiw r30, 1
    lsl_bytes r30, 2
    lsl_bytes r30, 2
    add_bytes r30, r20, 2
    subi r20, 0xfc
    sbci r21, 0xff
    movw end, r20
    movw rB0, r22
    movw rB2, r24
    clr zero
    begin_products \fraction
    take_coefficient
    rjmp 1f
2:  product_by_b \fraction
    sbiw r30, 8
    each_sum shift, \fraction
    take_coefficient
    each_sum add_to_a, \fraction
1:  cp_bytes r30, end, 2
    breq 5f
    rjmp 2b
5:  movw r24, a2
    .if \fraction > 24
    pop s7
    .endif
    pop_all r17, r16, r15, r14, r13, r12
    clr r1
    ret
    other_product \fraction
    .endm

    .macro kernels integer, fraction
    FUNCTION fixedpoint_polynomial_q\integer\()_\fraction
    polynomial \fraction
    ENDFUNC fixedpoint_polynomial_q\integer\()_\fraction
    .endm

#include "splits_32.inc"

#endif
