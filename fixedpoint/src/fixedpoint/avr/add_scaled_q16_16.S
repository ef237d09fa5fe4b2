// SPDX-License-Identifier: MIT
// void fixedpoint_add_scaled2_q16_16(int32_t* sum, const int32_t* v, int32_t factor)
// void fixedpoint_add_scaled3_q16_16(int32_t* sum, const int32_t* v, int32_t factor)
// sum_i += floor(v_i factor / 2^16 + 1/2) modulo 2^32 of 2 or 3 components.
//
// void fixedpoint_exchange2_q16_16(int32_t* a, int32_t* b, const int32_t* v, int32_t factor)
// void fixedpoint_exchange3_q16_16(int32_t* a, int32_t* b, const int32_t* v, int32_t factor)
// The same product is added to a_i and subtracted from b_i.
//
// In       sum = r25:r24, v = r23:r22, factor = r21:r18
//          a = r25:r24, b = r23:r22, v = r21:r20, factor = r19:r16; all in RAM
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    5 bytes and a call; of exchange 9 bytes and a call
//
// The factor is a of short_factor_q16_16.inc, the components are b. A whole factor from 0 to 255,
// which many inverse masses are, takes a quarter of the products and does not need rounding.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include "short_factor_q16_16.inc"

#define count r13
// For a whole factor, in place of s4 and s5.
#define w4 a0
#define w5 a1

    .macro add_byte s
    ld r0, X
    add r0, \s
    st X+, r0
    .endm
    .macro add_byte_with_carry s
    ld r0, X
    adc r0, \s
    st X+, r0
    .endm

    SECTION fixedpoint_exchange_q16_16
    ENTRY fixedpoint_exchange2_q16_16
    ldi r26, 2
    rjmp .Lexchange
    ENDFUNC fixedpoint_exchange2_q16_16

    ENTRY fixedpoint_exchange3_q16_16
    ldi r26, 3
.Lexchange:
    push r28
    push r29
    movw r28, r22
    movw r30, r20
    movw r20, r18
    movw r18, r16
    mov b0, r26
    set
    XCALL .Lcomponents
    pop r29
    pop r28
    ret
    ENDFUNC fixedpoint_exchange3_q16_16

    SECTION fixedpoint_add_scaled_q16_16
.Lno_fraction:
    clr s2
    clr s3
    movw s4, s2
    rjmp .Lwhole_part

.Lwhole_factor:
    movw r26, r24
1:  ld b1, Z+
    mul b1, a2
    movw s2, r0
    ld b1, Z+
    mul b1, a2
    clr w4
    add s3, r0
    adc w4, r1
    ld b1, Z+
    mul b1, a2
    clr w5
    add w4, r0
    adc w5, r1
    ld b1, Z+
    mul b1, a2
    add w5, r0
    add_byte s2
    add_byte_with_carry s3
    add_byte_with_carry w4
    add_byte_with_carry w5
    dec b0
    brne 1b
    clr r1
    ret

    ENTRY fixedpoint_add_scaled2_q16_16
    movw r30, r22
    ldi b0, 2
    rjmp .Lscaled
    ENDFUNC fixedpoint_add_scaled2_q16_16

    ENTRY fixedpoint_add_scaled3_q16_16
    movw r30, r22
    ldi b0, 3
.Lscaled:
    mov r0, a0
    or r0, a1
    or r0, a3
    breq .Lwhole_factor
    clt
.Lcomponents:
    push_all count, zero, s1, s4, s5
    movw r26, r24
    mov count, b0
    clr zero
.Lcomponent:
    load_half_of_b .Lno_fraction
    multiply_fraction
.Lwhole_part:
    add_whole_part
    add_byte s2
    add_byte_with_carry s3
    add_byte_with_carry s4
    add_byte_with_carry s5
    brtc .Lnext
    ld r0, Y
    sub r0, s2
    st Y+, r0
    ld r0, Y
    sbc r0, s3
    st Y+, r0
    ld r0, Y
    sbc r0, s4
    st Y+, r0
    ld r0, Y
    sbc r0, s5
    st Y+, r0
.Lnext:
    dec count
    breq 4f
    rjmp .Lcomponent
4:  pop_all s5, s4, s1, zero, count
    clr r1
    ret
    ENDFUNC fixedpoint_add_scaled3_q16_16

#endif
