// SPDX-License-Identifier: MIT
// int32_t fixedpoint_atan2_q16_16_small(int32_t y, int32_t x)
// The angle of the vector (x, y) in Q16.16 radians, in (-pi, pi], within 0.59 ulp; (0, 0): 0.
//
// int32_t fixedpoint_atan_q16_16_small(int32_t a)
// The arc tangent of a Q16.16 number in radians, within 0.59 ulp: atan2(a, 1).
//
// Without a table: an eighth of the flash of fixedpoint_atan2_q16_16, and slower.
//
// In       y or a = r25:r22, x = r21:r18
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
//
// The smaller magnitude is divided by the larger one bit by bit. Of the ratio x, atan(x) =
// x (c0 - z (c1 - z (c2 - ... z c6))), z = x^2: the polynomial of least largest error, 2.5e-7, that
// fixedpoint/tables/minimax.py finds. All factors are 24-bit fractions.
//
// Error in ulp: polynomial 0.017; ratio 0.004; products cut and coefficients rounded, 0.06 around
// the mean that is added with the half ulp; pi 0.002. Rounding 0.5. The worst of all 2^32 inputs of
// atan is 0.52690, at -60901; the worst found of atan2, in 10^9 pairs and by climbing, is 0.53494,
// at (139315820, 151594038).

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define octant r27
#define angle0 r19
#include "octants_q16_16.inc"

// The ratio.
#define x0 r30
#define x1 r31
#define x2 r26
#include "multiply_high_24.inc"

#include "atan_polynomial.inc"
// Half an ulp, and what the products cut in the mean.
#define ROUNDING 130

    SECTION fixedpoint_atan2_q16_16_small

    ENTRY fixedpoint_atan_q16_16_small
    ldi d0, 0
    ldi d1, 0
    ldi d2, 1
    ldi d3, 0
    ENDFUNC fixedpoint_atan_q16_16_small

    ENTRY fixedpoint_atan2_q16_16_small
    into_first_octant
    cp d0, r1
    cpc d1, r1
    cpc d2, r1
    cpc d3, r1
    brne .Ldivide
    ret                 // D is 0, and so is N
.Ldivide:
    brpl .Lfits
    lsr d3              // D is 2^31: halved, so that twice N fits
    lsr n3
    ror n2
    ror n1
    ror n0
.Lfits:
    // 24 bits, inverted; the one ahead of them leaves when they are complete.
    ldi x0, 1
    ldi x1, 0
    ldi x2, 0
.Lbit:
    lsl n0
    rol n1
    rol n2
    rol n3
    cp n0, d0
    cpc n1, d1
    cpc n2, d2
    cpc n3, d3
    brcs .Lbelow
    sub n0, d0
    sbc n1, d1
    sbc n2, d2
    sbc n3, d3
.Lbelow:
    rol x0
    rol x1
    rol x2
    brcc .Lbit
    com x0
    com x1
    com x2
    clr zero
    movw t0, x0
    mov t2, x2
    rcall .Lmultiply_by_x
    movw z0, t0
    mov z2, t2
    ldi t0, lo8(C6)
    ldi t1, hi8(C6)
    ldi t2, hlo8(C6)
    rcall .Lmultiply
    subtract_from C5
    rcall .Lmultiply
    subtract_from C4
    rcall .Lmultiply
    subtract_from C3
    rcall .Lmultiply
    subtract_from C2
    rcall .Lmultiply
    subtract_from C1
    rcall .Lmultiply
    subtract_from C0
    rcall .Lmultiply_by_x
    clr r1
    mov angle0, t0
    mov angle1, t1
    mov angle2, t2
    subi angle0, lo8(0x1000000 - ROUNDING)
    sbci angle1, hi8(0x1000000 - ROUNDING)
    sbci angle2, hlo8(0x1000000 - ROUNDING)
    return_from_first_octant
    return_negated

    multiply_high_24
    ENDFUNC fixedpoint_atan2_q16_16_small

#endif
