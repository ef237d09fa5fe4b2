// SPDX-License-Identifier: MIT
// int32_t fixedpoint_multiply_add_q16_16(int32_t a, int32_t b, int32_t c)
// floor((a b + c 2^16) / 2^16 + 1/2) modulo 2^32: a b + c, rounded once. A whole number of ulps
// may be added after the rounding.
//
// In       a = r25:r22, b = r21:r18, c = r17:r14
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include "multiply_q16_16.inc"

    FUNCTION fixedpoint_multiply_add_q16_16
    multiply_q16_16
    add_bytes r22, r14, 4
    ret
    ENDFUNC fixedpoint_multiply_add_q16_16

#endif
