// SPDX-License-Identifier: MIT
// int32_t fixedpoint_polynomial_q<32 - F>_<F>(int32_t x, const int32_t* c, uint16_t n)
// Horner's rule: p = c[n - 1], then for i = n - 2 .. 0
// p = floor(p x / 2^F + 1/2) + c[i] modulo 2^32, whatever the fraction bits of p and c are. Of each
// split of 32 bits but Q16.16, whose own is faster.
//
// In       x = r25:r22, c = r21:r20 in program memory, n = r19:r18, at least 1
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    6 or 7 bytes
//
// p is a and x is b of columns_32.inc. The result is in five bytes of the product, from byte
// floor((F - 1) / 8) on, as in multiply_32.S. Of 17 to 24 fraction bits the highest byte of x is mostly 0
// or -1, which takes no multiplication; T says that it is not 0.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define s2 r14
#define s3 r15
#define s7 r28
#include "columns_32.inc"

// Where the last coefficient to be taken ends.
#define end r12

    // a = the coefficient at Z, which moves behind it.
    .macro take_coefficient
    lpm_each a0, Z+, 2
    lpm_each a2, Z+, 2
    .endm

    // a = the coefficient and p4:...:p0 shifted right by 8 - left bits and rounded.
    .macro add_rounded left, p0, p1, p2, p3, p4
    .if \left < 5
    .rept \left
    lsl \p0
    rol \p1
    rol \p2
    rol \p3
    rol \p4
    .endr
    lsl \p0
    take_coefficient
    adc a0, \p1
    adc a1, \p2
    adc a2, \p3
    adc a3, \p4
    .else
    .rept 8 - \left
    lsr \p4
    ror \p3
    ror \p2
    ror \p1
    ror \p0
    .endr
    .if \left == 8
    clc
    .endif
    take_coefficient
    adc a0, \p0
    adc a1, \p1
    adc a2, \p2
    adc a3, \p3
    .endif
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
    .if (\fraction - 1) / 8 == 2
    clt
    cpse rB3, zero
    set
    .endif
    take_coefficient
    rjmp 1f
2:  .if (\fraction - 1) / 8 == 2
    short_product rB0, rB1, rB2
    brtc 3f
    cpi rB3, 0xff
    brne 4f
    each_of_a sub, sbc
3:
    .else
    five_bytes ((\fraction - 1) / 8)
    .endif
    sbiw r30, 8
    .if (\fraction - 1) / 8 == 0
    add_rounded (8 - \fraction), s0, s1, s2, s3, s4
    .elseif (\fraction - 1) / 8 == 1
    add_rounded (16 - \fraction), s1, s2, s3, s4, s5
    .elseif (\fraction - 1) / 8 == 2
    add_rounded (24 - \fraction), s2, s3, s4, s5, s6
    .else
    add_rounded (32 - \fraction), s3, s4, s5, s6, s7
    .endif
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
    .if (\fraction - 1) / 8 == 2
4:  mulsu rB3, a0
    sbc s5, zero
    sbc s6, zero
    add s3, r0
    adc s4, r1
    adc s5, zero
    adc s6, zero
    signed_product rB3, a1, s4, s5, s6
    top_product mulsu, rB3, a2, s5, s6
    last_product rB3, a3, s6
    rjmp 3b
    .endif
    .endm

    .macro kernels integer, fraction
    FUNCTION fixedpoint_polynomial_q\integer\()_\fraction
    polynomial \fraction
    ENDFUNC fixedpoint_polynomial_q\integer\()_\fraction
    .endm

#include "splits_32.inc"

#endif
