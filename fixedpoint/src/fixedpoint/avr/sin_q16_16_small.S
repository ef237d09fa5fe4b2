// SPDX-License-Identifier: MIT
// int32_t fixedpoint_sin_q16_16_small(int32_t angle)
// int32_t fixedpoint_cos_q16_16_small(int32_t angle)
// Sine and cosine of a Q16.16 angle in radians, for every input; within 0.58 ulp, in [-1, 1].
// Without a table: about a fifth of the flash of fixedpoint_sin_q16_16, and slower.
//
// In       angle = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
//
// Of the quarter turns x, folded into [0, 1), sin(pi/2 x) / 2 = x (c0 + y (c1 + y (c2 + y c3))),
// y = 1 - x^2: the polynomial of least largest error, 5.9e-7 of the sine, that
// fixedpoint/tables/minimax.py finds. In 1 - x^2 no coefficient is negative. All factors are
// fractions of 24 bits, but 8 are enough for c3.
//
// Error in ulp: polynomial, coefficients and cut products 0.072 over all x, around their mean, which
// is added with the half ulp for rounding; quarter turns 0.036. Rounding 0.5. The worst found, in 9 10^7
// angles, is 0.57075, at -170937994.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include "quarter_turns_q16_16.inc"

#include "sin_polynomial.inc"
// Half an ulp in units of 2^-7 and four units for what is cut.
#define ROUNDING 68

#define x0 b4
#define x1 b5
#define x2 b6
#include "multiply_high_24.inc"

    SECTION fixedpoint_sin_q16_16_small

    ENTRY fixedpoint_cos_q16_16_small
    ldi b7, 1
    rjmp .Lreduce
    ENDFUNC fixedpoint_cos_q16_16_small

    ENTRY fixedpoint_sin_q16_16_small
    ldi b7, 0
.Lreduce:
    quarter_turns
    bst b7, 1
    lsr b7
    brcc 1f
    com x0
    com x1
    com x2
1:  movw t0, x0
    mov t2, x2
    rcall .Lmultiply_by_x
    com t0
    com t1
    com t2
    movw z0, t0
    mov z2, t2
    ldi carried, C3
    ldi t0, lo8(C2)
    ldi t1, hi8(C2)
    ldi t2, hlo8(C2)
    mul carried, z2
    add t0, r0
    adc t1, r1
    adc t2, zero
    mul carried, z1
    add t0, r1
    adc t1, zero
    adc t2, zero
    rcall .Lmultiply
    add_constant C1
    rcall .Lmultiply
    add_constant C0
    rcall .Lmultiply_by_x
    clr r1
    subi t0, lo8(0x1000000 - ROUNDING)
    sbci t1, hi8(0x1000000 - ROUNDING)
    sbci t2, hlo8(0x1000000 - ROUNDING)
    lsl t0              // the unit is 2^-7 ulp: result = t2:t1, 2^16 in the carry
    rol t1
    rol t2
    mov r22, t1
    mov r23, t2
    ldi r25, 0
    ldi r24, 0
    adc r24, r24
    brts 2f
    ret
2:  com r24
    com r23
    neg r22
    sbci r23, 0xff
    sbci r24, 0xff
    sbc r25, r25
    ret

    quarter_turns_far

    multiply_high_24
    ENDFUNC fixedpoint_sin_q16_16_small

#endif
