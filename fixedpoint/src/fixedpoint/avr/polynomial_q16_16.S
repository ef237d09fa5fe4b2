// SPDX-License-Identifier: MIT
// int32_t fixedpoint_polynomial_q16_16(int32_t x, const int32_t* c, uint16_t n)
// Horner's rule: p = c[n - 1], then for i = n - 2 .. 0
// p = floor(p x / 2^16 + 1/2) + c[i] modulo 2^32, whatever the fraction bits of p and c are.
//
// In       x = r25:r22, c = r21:r20 in program memory, n = r19:r18; n must be at least 1
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    8 bytes and a call
//
// p is a, and the fraction of x is b, of short_factor_q16_16.inc. The integer part of x is in
// r27:r26 and takes a multiplication only if it is neither 0 nor -1, which T indicates.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include "short_factor_q16_16.inc"

    FUNCTION fixedpoint_polynomial_q16_16
    push_all zero, s1, s4, s5, r28, r29
    clr zero
    movw r26, r24
    movw r28, r18
    movw r30, r20
    mov r0, r26         // T: r27:r26 is not just a sign extension
    lsl r0
    sbc r0, r0
    clt
    cp r26, r0
    cpc r27, r0
    breq 1f
    set
1:  sbiw r28, 1         // Z = c + 4 (n - 1)
    movw r18, r28
    lsl r18
    rol r19
    lsl r18
    rol r19
    add r30, r18
    adc r31, r19
    lpm_each a0, Z+, 4
    sbiw r28, 0
    breq 5f
2:  multiply_fraction
    brts 6f
    sbrs r27, 7
    rjmp 3f
    sub s2, a0
    sbc s3, a1
    sbc s4, a2
    sbc s5, a3
3:  sbiw r30, 8
    lpm_each a0, Z+, 4
    add a0, s2
    adc a1, s3
    adc a2, s4
    adc a3, s5
    sbiw r28, 1
    brne 2b
5:  movw r22, a0
    movw r24, a2
    pop_all r29, r28, s5, s4, s1, zero
    clr r1
    ret
6:  push b0
    push b1
    movw b0, r26
    XCALL fixedpoint_add_whole_product
    pop b1
    pop b0
    rjmp 3b
    ENDFUNC fixedpoint_polynomial_q16_16

#endif
