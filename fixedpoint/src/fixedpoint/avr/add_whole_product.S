// SPDX-License-Identifier: MIT
// s5:s2 += a b modulo 2^32 for the signed b in b1:b0: for Q16.16 operands whose integer part is not
// just a sign. The registers are those of short_factor_q16_16.inc.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include "short_factor_q16_16.inc"

    FUNCTION fixedpoint_add_whole_product
    mul_add a0, b0, s2, s3, zero, s4, s5
    mul_add a1, b0, s3, s4, zero, s5
    mul_add a0, b1, s3, s4, zero, s5
    mul_add a2, b0, s4, s5
    mul_add a1, b1, s4, s5
    mul a3, b0
    add s5, r0
    mul a2, b1
    add s5, r0
    sbrs b1, 7
    ret
    sub s4, a0          // b is 2^16 less than its bytes
    sbc s5, a1
    ret
    ENDFUNC fixedpoint_add_whole_product

#endif
