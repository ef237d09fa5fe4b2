// SPDX-License-Identifier: MIT
// int32_t fixedpoint_biquad_q16_16(int32_t input, void* filter)
// The next output of a second-order filter: the exact sum of five products and two weighted errors,
// rounded half up and taken modulo 2^32. The rounding error becomes the next error.
//
// In       input = r25:r22, filter = r21:r20: the coefficients of x, x1, x2, y1, y2, then x1, x2, y1, y2,
//          the weights of the last two errors, a byte each, and these errors, signed, in 2 or 4 bytes
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    8 or 10 bytes
//
// Each product leaves its signal in a, which is stored to the place of the next signal: so all
// signals move on by one. The coefficient of y1 is between 1 and 2 in most low-pass filters.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define b1 r17
#define b2 r27
#include "product_sum_32.inc"

#define weight r22
#define part r23
#define count r26

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

    // sum += weight error, in the bytes that it occupies.
    .macro add_error weight_at, error_at, fraction
    ldd weight, Y + \weight_at
    ldd part, Y + \error_at
    mulsu weight, part
    sbc q0, q0
    add s0, r0
    adc s1, r1
    adc s2, q0
    .if \fraction == 24
    adc s3, q0
    ldd part, Y + \error_at + 1
    mulsu weight, part
    sbc q0, q0
    add s1, r0
    adc s2, r1
    adc s3, q0
    .endif
    ldd part, Y + \error_at + \fraction / 8 - 1
    muls weight, part
    into add, (\fraction / 8 - 1), 7, r0
    into adc, (\fraction / 8), 7, r1
    .endm

    .macro biquad fraction, top, error_bytes, half, o0, o1, o2, o3
    set_short \fraction
    push_sum \top
    push r28
    push r29
    movw r30, r20
    movw r28, r20
    adiw r28, 20
    movw a0, r22
    movw a2, r24
    clr s0
    clr s1
    movw s2, s0
    ldi part, 0x80
    mov \half, part     // rounds
    add_error 16, 18, \fraction
    add_error 17, (18 + \error_bytes), \fraction
    clr zero
    mov \o1, \o0       // the sign of the sum of the errors
    lsl \o1
    sbc \o1, \o1
    mov \o2, \o1
    mov \o3, \o1
    ldi count, 5
2:  .if is_short
    add_short_product \top, Z+
    .else
    add_product \fraction, \top, 1
    .endif
    dec count
    breq 4f
    .if !is_short
    adiw r30, 4
    .endif
    exchange
    rjmp 2b
4:  sbiw r28, 8         // y1
    std Y + 0, \o0
    std Y + 1, \o1
    std Y + 2, \o2
    std Y + 3, \o3
    ldi r24, 0x80
    eor \half, r24      // minus the half added for rounding
    .irp n, 0, 1, 2, 3
    .if \n < \error_bytes
    ldd r24, Y + 10 + \n
    std Y + 10 + \error_bytes + \n, r24
    .endif
    .endr
    .irp n, 0, 1, 2
    .if \n < \fraction / 8
    std Y + 10 + \n, r1\n
    .endif
    .endr
    .if \error_bytes > \fraction / 8
    lsl \half
    sbc r24, r24
    std Y + 13, r24
    .endif
    clr r1
    mov r22, \o0
    mov r23, \o1
    mov r24, \o2
    mov r25, \o3
    pop r29
    pop r28
    pop_sum \top
    ret
    .endm

    FUNCTION fixedpoint_biquad_q16_16
    biquad 16, 5, 2, s1, s2, s3, s4, s5
    ENDFUNC fixedpoint_biquad_q16_16

#endif
