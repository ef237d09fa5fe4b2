// SPDX-License-Identifier: MIT
// int32_t fixedpoint_dot_difference2_q16_16(const int32_t* n, const int32_t* u, const int32_t* v)
// int32_t fixedpoint_dot_difference3_q16_16(const int32_t* n, const int32_t* u, const int32_t* v)
// floor(sum n_i d_i / 2^16 + 1/2) modulo 2^32 of 2 or 3 components, with d_i = u_i - v_i modulo
// 2^32, signed: one rounding.
//
// int32_t fixedpoint_project2_q16_16(const int32_t* n, const int32_t* u)
// int32_t fixedpoint_project3_q16_16(const int32_t* n, const int32_t* u)
// The same with d_i = u_i: the dot product, in less time if n is a unit vector.
//
// int32_t fixedpoint_square2_q16_16(const int32_t* n)
// int32_t fixedpoint_square3_q16_16(const int32_t* n)
// The same with d_i = n_i, in half the time if each |n_i| < 1.
//
// In       n = r25:r24, u = r23:r22, v = r21:r20, in RAM
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    10 bytes and a call
//
// The differences are a of short_factor_q16_16.inc, the components of n are b. Bytes 0..5 of the
// sum are kept, since 2^48 is beyond the result; they start with the half ulp that rounds.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include "short_factor_q16_16.inc"

#define s0 r13
#define q0 r10
#define q1 r11
#define count r12

// Of the squares; the result is in sum3:sum2 and above.
#define sum0 r26
#define sum1 r27
#define sum2 r22
#define sum3 r23
#define count_and_4 r20
#define none r21

    .macro subtract_byte a, instruction
    ld r0, Y+
    \instruction \a, r0
    .endm

// The squares of |n_i|, which is a1:a0: three products each. No sum reaches 2^34, so the count fits
// above its byte 4. T is set for three components.
    SECTION fixedpoint_square_q16_16
    ENTRY fixedpoint_square2_q16_16
    ldi count_and_4, 0x20
    clt
    rjmp .Lsquares
    ENDFUNC fixedpoint_square2_q16_16

    ENTRY fixedpoint_square3_q16_16
    ldi count_and_4, 0x30
    set
.Lsquares:
    movw r30, r24
    clr none
    clr sum0
    ldi sum1, 0x80      // rounds
    clr sum2
    clr sum3
.Lsquare:
    ld a0, Z+
    ld a1, Z+
    ld r0, Z+
    ld r1, Z+
    cpse r0, r1
    rjmp .Lbeyond_one
    tst r0
    breq 1f
    inc r0
    brne .Lbeyond_one
    com a1
    neg a0
    sbci a1, 0xff
    breq .Lbeyond_one   // n_i = -1
1:  mul a1, a1
    movw r24, r0
    mul a0, a0
    add sum0, r0
    adc sum1, r1
    adc sum2, r24
    adc sum3, r25
    adc count_and_4, none
    mul a0, a1
    lsl r0
    rol r1
    adc sum3, none
    adc count_and_4, none
    add sum1, r0
    adc sum2, r1
    adc sum3, none
    adc count_and_4, none
    subi count_and_4, 0x10
    cpi count_and_4, 0x10
    brsh .Lsquare
    mov r24, count_and_4
    clr r25
    clr r1
    ret
.Lbeyond_one:           // starts over, with Z before the components already read
    ldi r18, 2
    bld r18, 0          // 2 or 3
    mov r19, r18
    swap count_and_4
    andi count_and_4, 0x0f
    sub r19, count_and_4
2:  sbiw r30, 4
    subi r19, 1
    brcc 2b
    movw r24, r30
    movw r22, r30
    clt
    XJMP .Lcomponents
    ENDFUNC fixedpoint_square3_q16_16

    SECTION fixedpoint_dot_difference_q16_16
    ENTRY fixedpoint_project2_q16_16
    ldi r18, 2
    clt
    rjmp .Lcomponents
    ENDFUNC fixedpoint_project2_q16_16

    ENTRY fixedpoint_project3_q16_16
    ldi r18, 3
    clt
    rjmp .Lcomponents
    ENDFUNC fixedpoint_project3_q16_16

    ENTRY fixedpoint_dot_difference2_q16_16
    ldi r18, 2
    set
    rjmp .Lcomponents
    ENDFUNC fixedpoint_dot_difference2_q16_16

    ENTRY fixedpoint_dot_difference3_q16_16
    ldi r18, 3
    set
.Lcomponents:
    push_all q0, q1, count, s0, zero, s1, s4, s5
    brtc 1f
    push r28
    push r29
    movw r28, r20
1:  mov count, r18
    movw r30, r24
    movw r26, r22
    clr zero
    clr s0
    ldi r18, 0x80
    mov s1, r18
    clr s2
    clr s3
    movw s4, s2
.Lcomponent:
    ld_each a0, X+, 4
    brtc .Lfraction
    subtract_byte a0, sub
    subtract_byte a1, sbc
    subtract_byte a2, sbc
    subtract_byte a3, sbc
.Lfraction:
    load_half_of_b .Lwhole_part
    mul a1, b1
    movw q0, r0
    mul a0, b0
    add s0, r0
    adc s1, r1
    adc s2, q0
    adc s3, q1
    adc s4, zero
    adc s5, zero
    mulsu a3, b1
    movw q0, r0
    mul a2, b0
    add s2, r0
    adc s3, r1
    adc s4, q0
    adc s5, q1
    mulsu a3, b0
    sbc s5, zero
    movw q0, r0
    mul a0, b1
    add s1, r0
    adc s2, r1
    adc s3, q0
    adc s4, q1
    adc s5, zero
    mul a2, b1
    movw q0, r0
    mul a1, b0
    add s1, r0
    adc s2, r1
    adc s3, q0
    adc s4, q1
    adc s5, zero
.Lwhole_part:
    add_whole_part
    dec count
    breq 4f
    rjmp .Lcomponent
4:  movw r22, s2
    movw r24, s4
    brtc 5f
    pop r29
    pop r28
5:  pop_all s5, s4, s1, zero, s0, count, q1, q0
    clr r1
    ret
    ENDFUNC fixedpoint_dot_difference3_q16_16

#endif
