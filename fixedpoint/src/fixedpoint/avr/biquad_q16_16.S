// SPDX-License-Identifier: MIT
// int32_t fixedpoint_biquad_q16_16(int32_t input, void* filter)
// The next output of a second-order filter: the exact sum of five products and two weighted errors,
// rounded half up and taken modulo 2^32. The rounding error becomes the next error.
//
// In       input = r25:r22, filter = r21:r20: the coefficients of x, x1, x2, y1, y2, then x1, x2, y1, y2,
//          the weights of the last two errors, a byte each, and these errors, signed, in 2 bytes
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    8 bytes
//
// Each product leaves its signal in a, which is stored to the place of the next signal: so all
// signals move on by one. The coefficient of y1 is between 1 and 2 in most low-pass filters, and
// between -2 and -1 in most high-pass filters.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "product_sum_32.inc"

#define top 5
#define weight r22
#define part r23
#define count r26

#define weight_at 16
#define error_at 18

    // Loads the next signal into a, after storing a in its place.
    .macro exchange
    ldd_bytes q0, Y + 0, 2
    ldd_bytes r0, Y + 2, 2
    st Y+, a0
    st Y+, a1
    st Y+, a2
    st Y+, a3
    movw a0, q0
    movw a2, r0
    .endm

    FUNCTION fixedpoint_biquad_q16_16
    push_sum top
    push r28
    push r29
    movw r30, r20
    movw r28, r20
    adiw r28, 20
    movw a0, r22
    movw a2, r24
    // s2:s1:s0 = the weighted errors, and a half that rounds
    ldd weight, Y + weight_at
    ldd part, Y + error_at
    mulsu weight, part
    movw s0, r0
    sbc s2, s2
    ldd part, Y + error_at + 1
    muls_add weight, part, s1, s2
    ldd weight, Y + weight_at + 1
    ldd part, Y + error_at + 2
    mulsu weight, part
    sbc q0, q0
    add s0, r0
    adc s1, r1
    adc s2, q0
    ldd part, Y + error_at + 3
    muls_add weight, part, s1, s2
    ldi q0, 0x80
    clr zero            // no longer part
    add s1, q0
    adc s2, zero
    mov s3, s2          // the sign of the sum of the errors
    lsl s3
    sbc s3, s3
    mov s4, s3
    mov s5, s3
    ldi count, 5
2:  add_product 16, top, 2
    dec count
    breq 4f
    adiw r30, 4
    exchange
    rjmp 2b
4:  sbiw r28, 8         // y1
    std_bytes Y + 0, s2, 4
    ldd_bytes r24, Y + 10, 2
    std_bytes Y + 12, r24, 2
    ldi r24, 0x80
    eor s1, r24         // minus the half added for rounding
    std_bytes Y + 10, s0, 2
    clr r1
    movw r22, s2
    movw r24, s4
    pop r29
    pop r28
    pop_sum top
    ret
    ENDFUNC fixedpoint_biquad_q16_16

#endif
