// SPDX-License-Identifier: MIT
// int32_t fixedpoint_multiply_q16_16(int32_t a, int32_t b)
// floor(a b / 2^16 + 1/2) modulo 2^32: the Q16.16 product rounded to nearest, half up.
//
// In       a = r25:r22, b = r21:r18
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include "multiply_q16_16.inc"

    FUNCTION fixedpoint_multiply_q16_16
    multiply_q16_16
    ret
    ENDFUNC fixedpoint_multiply_q16_16

#endif
