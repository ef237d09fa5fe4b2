// SPDX-License-Identifier: MIT
// int32_t fixedpoint_multiply_add_q16_16(int32_t a, int32_t b, int32_t c)
// floor((a b + c 2^16) / 2^16 + 1/2) modulo 2^32: a b + c, rounded once. A whole number of ulps
// may be added after the rounding.
//
// In       a = r25:r22, b = r21:r18, c = r17:r14
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Cycles   83 on every path, call and ret included

#ifdef __AVR__

#include "multiply_q16_16.inc"

    .section .text.fixedpoint_multiply_add_q16_16, "ax", @progbits
    .global fixedpoint_multiply_add_q16_16
    .type fixedpoint_multiply_add_q16_16, @function
fixedpoint_multiply_add_q16_16:
    multiply_q16_16
    add r22, r14
    adc r23, r15
    adc r24, r16
    adc r25, r17
    ret
    .size fixedpoint_multiply_add_q16_16, .-fixedpoint_multiply_add_q16_16

#endif
