// SPDX-License-Identifier: MIT
// int32_t fixedpoint_one_pole_q16_16(int32_t input, void* filter)
// int32_t fixedpoint_one_pole_q8_24(int32_t input, void* filter)
// output:error += coefficient (input - output), where the difference saturates; returns the output.
//
// In       input = r25:r22, filter = r21:r20: the coefficient, the error in the highest F bits of two
//          or four bytes, and the output
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    4 or 5 bytes
//
// The error and the output are adjacent and form one sum, to which the exact product is added.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define SUM_BEGINS_IN_X
#include "product_sum_32.inc"

    // The bytes of the sum, which follow the coefficient. The lowest of four error bytes is 0.
    .macro load place, top
    ldd_bytes s0, Z + \place, 2
    ldd_bytes s2, Z + \place + 2, (\top - 1)
    .endm
    .macro store place, top
    std_bytes Z + \place, s0, 2
    std_bytes Z + \place + 2, s2, (\top - 1)
    .endm

    .macro one_pole fraction, top, o0, o1, o2, o3
    push_sum \top
    movw r30, r20
    movw a0, r22
    movw a2, r24
    clr zero
    load (4 + \fraction / 24), \top
    sub a0, \o0
    sbc a1, \o1
    sbc a2, \o2
    sbc a3, \o3
    brvc 2f
    lsl a3              // to the limit opposite to the wrapped sign
    sbc a3, a3
    mov a0, a3
    mov a1, a3
    mov a2, a3
    subi a3, 0x80
2:  add_product \fraction, \top
    store (4 + \fraction / 24), \top
    clr r1
    mov r22, \o0
    mov r23, \o1
    mov r24, \o2
    mov r25, \o3
    pop_sum \top
    ret
    .endm

    FUNCTION fixedpoint_one_pole_q16_16
    one_pole 16, 5, s2, s3, s4, s5
    ENDFUNC fixedpoint_one_pole_q16_16

    FUNCTION fixedpoint_one_pole_q8_24
    one_pole 24, 6, s3, s4, s5, s6
    ENDFUNC fixedpoint_one_pole_q8_24

#endif
