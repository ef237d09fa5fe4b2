// SPDX-License-Identifier: MIT
// int32_t fixedpoint_biquad_q8_24(int32_t input, void* filter)
// That of biquad_q16_16.S for Q8.24.
//
// In       input = r25:r22, filter = r21:r20: see below
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    7 bytes and a call
//
// The filter consists of the coefficient of x; 128 n in four bytes; the coefficient of x1, and x1;
// that of x2, and x2; that of y2, and a sum of seven bytes whose upper four are y2; that of y1, and
// the sum of y1; the weights of the errors of y2 and y1, a byte each.
//
// A sum contains the half that rounds, so its lower three bytes are the error e plus a half. With the
// weights k1 and k2, n = 1 - k1 - k2 halves correct this.
//
// c y + k e, with the coefficient c = d + f where 0 <= f < 1, is f y + d (y + e) + (k - d) e, and
// y + e is a stored sum. The weight is the integer nearest to c, so k - d is the first bit of f. Only
// where |k| would exceed 2, or 1 for y2, it is limited; such d do not take the short path.

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

// Where the filter has a coefficient, followed by a signal or a sum; and the rest.
#define halves_at 4
#define x1_at 8
#define x2_at 16
#define y2_at 24
#define y1_at 35
#define weights_at 46

    // Loads the next signal into a, after storing a in its place.
    .macro exchange at
    ldd_bytes q0, Z + \at, 2
    ldd_bytes r0, Z + \at + 2, 2
    std_bytes Z + \at, a0, 4
    movw a0, q0
    movw a2, r0
    .endm
    .macro load_error at
    ldd b0, Z + \at
    ldd b1, Z + \at + 1
    ldd q1, Z + \at + 2
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

    // s += q0 times the error.
1:  dec q0
    error add, adc
.Lweigh:
    tst q0
    breq 3f
    brpl 1b
    inc q0
    error sub, sbc
    rjmp .Lweigh
3:  ret

    ENTRY fixedpoint_biquad_q8_24
    push_all r10, r11, r12, r13, r14, r16, r17
    movw r30, r20
    movw a0, r22
    movw a2, r24
    clr zero
    load_b 0
    first_rows
    upper_highest_bytes 0
    ldd q0, Z + halves_at
    add s2, q0
    ldd q0, Z + halves_at + 1
    adc u3, q0
    ldd q0, Z + halves_at + 2
    adc u4, q0
    adc u5, q0
    adc u6, q0
    .irp at, x1_at, x2_at
    exchange (\at + 4)
    load_b \at
    rows
    upper_highest_bytes \at
    .endr

    ldd_bytes a0, Z + y2_at + 7, 4
    load_b y2_at
    rows
    upper_highest_of_a
    load_error (y2_at + 4)
    ldd q0, Z + y2_at + 3
    inc q0
    breq 1f
    rjmp .Lother_y2
1:  last_sum sub, sbc   // d = -1
.Lfraction_of_y2:
    sbrs b2, 7
    rjmp .Ly1
    error add, adc
.Ly1:
    ldd_bytes a0, Z + y1_at + 7, 4
    load_b y1_at
    rows
    upper_highest_of_a
    load_error (y1_at + 4)
    ldd q0, Z + y1_at + 3
    dec q0
    brne .Lother_y1
    last_sum add, adc   // d = 1
4:  sbrs b2, 7
    rjmp 5f
    error add, adc
5:  std Z + y2_at + 4, b0
    std Z + y2_at + 5, b1
    std Z + y2_at + 6, q1
    std_bytes Z + y2_at + 7, a0, 4
    std_bytes Z + y1_at + 4, s0, 3
    std_bytes Z + y1_at + 7, u3, 4
    clr r1
    pop_all r17, r16, r14, r13, r12, r11, r10
    ret

.Lother_y1:
    subi q0, -3
    breq 1f
    cpi q0, 1
    breq 2f
    subi q0, 2
    breq 4b
    rcall .Lhighest_of_b
    load_error (y1_at + 4)
    ldd q0, Z + weights_at + 1
    rcall .Lweigh
    rjmp 5b
1:  last_sum sub, sbc   // d = -2
2:  last_sum sub, sbc   // d = -1
    rjmp 4b
.Lother_y2:
    dec q0
    brne 1f
    rjmp .Lfraction_of_y2
1:  rcall .Lhighest_of_b
    load_error (y2_at + 4)
    ldd q0, Z + weights_at
    rcall .Lweigh
    rjmp .Ly1
    ENDFUNC fixedpoint_biquad_q8_24

#endif
