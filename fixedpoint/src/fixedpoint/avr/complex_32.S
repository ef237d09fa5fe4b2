// SPDX-License-Identifier: MIT
// void fixedpoint_complex_product_q<32 - F>_<F>(int32_t* result, const int32_t* a, const int32_t* b)
// The product of two complex numbers, the real part first: each part is the exact sum or difference
// of two products, divided by 2^F, rounded half up and taken modulo 2^32. For every 32-bit format but
// Q8.24, which complex_q8_24.S multiplies.
//
// In       result = r25:r24, a = r23:r22, b = r21:r20, in RAM; result must not be a or b
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    10 or 11 bytes

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define b1 r17
#define b2 r9
#include "product_sum_32.inc"

    .macro complex_product fraction, top
    set_short \fraction
    .if is_short
    push b2
    .endif
    push_sum \top
    push r28
    push r29
    movw r28, r24
    movw r26, r22
    movw r30, r20
    clr zero
    adiw r26, 4
    ld_each a0, X+, 4              // the imaginary part of a
    sbiw r26, 8
    .if !is_short
    begin \fraction, \top, 0xff
    .endif
    set                 // T: of the real part
2:  .if is_short
    first_product \top, 0, 4
    brts 1f
    add_half \fraction, \top
    rjmp 3f
1:  complement_and_half \fraction, \top
    .else
    add_product \fraction, \top, at=4
    brtc 3f
    com_bytes s0, (\top + 1)
    .endif
3:  ld_each a0, X+, 4              // the other part
    add_product \fraction, \top
    finish \fraction
    brtc 4f
    clt
    .if !is_short
    begin \fraction, \top
    .endif
    rjmp 2b
4:  pop r29
    pop r28
    pop_sum \top
    .if is_short
    pop b2
    .endif
    clr r1
    ret
    .endm

    .macro kernels integer, fraction
    .if \fraction != 24    // complex_q8_24.S
    FUNCTION fixedpoint_complex_product_q\integer\()_\fraction
    complex_product \fraction, ((\fraction - 1) / 8 + 4)
    ENDFUNC fixedpoint_complex_product_q\integer\()_\fraction
    .endif
    .endm

#include "splits_32.inc"
    kernels 16, 16

#endif
