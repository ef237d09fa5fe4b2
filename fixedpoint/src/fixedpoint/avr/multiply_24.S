// SPDX-License-Identifier: MIT
// Int24 fixedpoint_multiply_q<24 - F>_<F>(Int24 a, Int24 b)
// Int24 fixedpoint_multiply_add_q<24 - F>_<F>(Int24 a, Int24 b, Int24 c)
// floor(a b / 2^F + 1/2) modulo 2^24, plus c: the product rounded to nearest, half up, of every
// 24-bit format.
//
// In       a = r24:r22, b = r20:r18, c = r16:r14
// Out      r24:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
//
// The result is in four bytes of the product, from byte floor((F - 1) / 8) on, shifted to whole
// bytes by at most four bits in either direction; the bit that leaves last rounds. In Q8.16 it does so
// within the sum.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define zero r25
#define s0 r27
#define s1 r26
#define s2 r30
#define s3 r31
#define s4 r24
#define s5 r27
#include "columns_24.inc"

    .macro take p0, p1, p2
    .ifc \p0, s2
    movw r22, s2
    .else
    mov r22, \p0
    mov r23, \p1
    .endif
    .ifnc \p2, s4
    mov r24, \p2
    .endif
    .endm
    .macro round_bytes left, p0, p1, p2, p3
    .if \left < 5
    .rept \left
    lsl \p0
    rol \p1
    rol \p2
    rol \p3
    .endr
    lsl \p0
    take \p1, \p2, \p3
    .else
    .rept 8 - \left
    lsr \p3
    ror \p2
    ror \p1
    ror \p0
    .endr
    take \p0, \p1, \p2
    .endif
    .if \left < 8
    adc_each r22, r1, 3
    .endif
    .endm
    .macro multiply fraction
    columns ((\fraction - 1) / 8), ((\fraction - 1) / 8 + 3), (\fraction == 16)
    clr r1
    .if \fraction == 16
    take s2, s3, s4
    .elseif (\fraction - 1) / 8 == 0
    round_bytes (8 - \fraction), s0, s1, s2, s3
    .elseif (\fraction - 1) / 8 == 1
    round_bytes (16 - \fraction), s1, s2, s3, s4
    .else
    round_bytes (24 - \fraction), s2, s3, s4, s5
    .endif
    .endm

    .macro kernels integer, fraction
    FUNCTION fixedpoint_multiply_q\integer\()_\fraction
    multiply \fraction
    ret
    ENDFUNC fixedpoint_multiply_q\integer\()_\fraction

    FUNCTION fixedpoint_multiply_add_q\integer\()_\fraction
    multiply \fraction
    add_bytes r22, r14, 3
    ret
    ENDFUNC fixedpoint_multiply_add_q\integer\()_\fraction
    .endm

#include "splits_24.inc"

#endif
