// SPDX-License-Identifier: MIT
// s5:s2 += a b modulo 2^32 of the signed b in b1:b0, for the operands of Q16.16 that have more than
// a sign before the point. The registers are those of short_factor_q16_16.inc.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include "short_factor_q16_16.inc"

    FUNCTION fixedpoint_add_whole_product
    mul a0, b0
    add s2, r0
    adc s3, r1
    adc s4, zero
    adc s5, zero
    mul a1, b0
    add s3, r0
    adc s4, r1
    adc s5, zero
    mul a0, b1
    add s3, r0
    adc s4, r1
    adc s5, zero
    mul a2, b0
    add s4, r0
    adc s5, r1
    mul a1, b1
    add s4, r0
    adc s5, r1
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
