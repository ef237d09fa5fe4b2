// SPDX-License-Identifier: MIT
// int32_t fixedpoint_biquad_q8_24(int32_t input, void* filter)
// biquad_32.S for Q8.24.
//
// In       input = r25:r22, filter = r21:r20: see below
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    9 bytes and a call
//
// The filter consists of the coefficient of x, a number of halves n, the coefficients of x1, x2, y2 and
// y1, the weights of the errors of y1 and y2, x1, x2, then the sums of seven bytes whose upper four are y2 and y1. A
// sum contains the half that rounds, so its lower bytes are an error e plus a half. With the weights k1
// and k2, n = 1 - k1 - k2 halves correct this; n is 0 in most low-pass filters.
//
// c y + k e, with the coefficient c = d + f, 0 <= f < 1, is f y + d (y + e) + (k - d) e. Here y + e is a stored
// sum. If d is -1, 0 or 1, k - d is 0 or 1, which is the first bit of f; but the weight of the error of y2
// is at most 1.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

// s6:...:s3 are the result.
#define s0 r10
#define s1 r11
#define s2 r12
#define u3 r22
#define u4 r23
#define u5 r24
#define u6 r25
#define b2 r13
#define zero r14
#define q0 r26
#define q1 r27
#include "upper_sum_q8_24.inc"

#define signals_at 23

    .macro take_b
    ld b0, Z+
    ld b1, Z+
    ld b2, Z+
    .endm
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

    // s = the low three bytes of a times those of b.
    .macro first_rows
    mul a0, b0
    movw s0, r0
    mul a2, b0
    mov s2, r0
    mov u3, r1
    mul_add a1, b0, s1, s2, zero, u3
    mul a2, b1
    mov q0, r0
    mov u4, r1
    mul_add a1, b1, s2, u3, zero, u4
    mul a0, b1
    add s1, r0
    adc s2, r1
    adc u3, q0
    adc u4, zero
    mul a2, b2
    mov q0, r0
    mov u5, r1
    mul_add a1, b2, u3, u4, zero, u5
    mul a0, b2
    add s2, r0
    adc u3, r1
    adc u4, q0
    adc u5, zero
    clr u6
    .endm
    // s += the same.
    .macro rows
    mul a2, b0
    movw q0, r0
    mul_add a1, b0, s1, s2, zero, q1
    mul a0, b0
    add s0, r0
    adc s1, r1
    adc s2, q0
    adc u3, q1
    adc u4, zero
    adc u5, zero
    adc u6, zero
    mul a2, b1
    movw q0, r0
    mul_add a1, b1, s2, u3, zero, q1
    mul a0, b1
    add s1, r0
    adc s2, r1
    adc u3, q0
    adc u4, q1
    adc u5, zero
    adc u6, zero
    mul a2, b2
    movw q0, r0
    mul_add a1, b2, u3, u4, zero, q1
    mul a0, b2
    add s2, r0
    adc u3, r1
    adc u4, q0
    adc u5, q1
    adc u6, zero
    .endm
    // s += or -= q1:b1:b0.
    .macro error first, next
    \first s0, b0
    \next s1, b1
    \next s2, q1
    \next u3, zero
    \next u4, zero
    \next u5, zero
    \next u6, zero
    .endm
    // s += or -= a:q1:b1:b0.
    .macro last_sum first, next
    \first s0, b0
    \next s1, b1
    \next s2, q1
    \next u3, a0
    \next u4, a1
    \next u5, a2
    \next u6, a3
    .endm

    SECTION fixedpoint_biquad_q8_24
    highest_products

    // s += q0 halves.
.Lhalves:
    clr q1
    asr q0
    ror q1
    mov b0, q0
    lsl b0
    sbc b0, b0
    add s2, q1
    adc u3, q0
    adc u4, b0
    adc u5, b0
    adc u6, b0
    ret

    ENTRY fixedpoint_biquad_q8_24
    push_all r10, r11, r12, r13, r14, r16, r17, r28, r29
    movw r30, r20
    movw r28, r20
    adiw r28, signals_at
    movw a0, r22
    movw a2, r24
    clr zero
    take_b
    first_rows
    upper_highest_of_a
    ld q0, Z+
    upper_highest_of_b
    ld q0, Z+
    cpse q0, zero
    rcall .Lhalves
    .rept 2
    exchange
    take_b
    rows
    upper_highest_of_a
    ld q0, Z+
    upper_highest_of_b
    .endr
    set                 // T: of y2
1:  ldd_bytes a0, Y + 3, 4
    take_b
    rows
    upper_highest_of_a
    ldd b0, Y + 0
    ldd b1, Y + 1
    ldd q1, Y + 2
    ld q0, Z+           // d
    inc q0
    breq .Lminus
    dec q0
    breq 2f
    dec q0
    brne .Lother
    brts .Lother
    last_sum add, adc
2:  sbrs b2, 7
    rjmp 3f
    error add, adc
3:  brtc 4f
    clt
    adiw r28, 7
    rjmp 1b
.Lminus:
    last_sum sub, sbc
    rjmp 2b
    // d - 1 is q0.
.Lother:
    inc q0
    rcall .Lhighest_of_b
    ldd b0, Y + 0
    ldd q0, Z + 0       // the weight
    brtc 1f
    ldd q0, Z + 5
1:  tst q0
    breq 3b
    brmi 2f
    error add, adc
    dec q0
    rjmp 1b
2:  error sub, sbc
    inc q0
    rjmp 1b

4:  sbiw r28, 7
    std Y + 0, b0
    std Y + 1, b1
    std Y + 2, q1
    std_bytes Y + 3, a0, 4
    std_bytes Y + 7, s0, 3
    std_bytes Y + 10, u3, 4
    clr r1
    pop_all r29, r28, r17, r16, r14, r13, r12, r11, r10
    ret
    ENDFUNC fixedpoint_biquad_q8_24

#endif
