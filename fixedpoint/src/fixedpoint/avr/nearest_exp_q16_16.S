// SPDX-License-Identifier: MIT
// int32_t fixedpoint_exp_q16_16_correctly_rounded(int32_t a)
// e^a in Q16.16, saturated; within 0.5 ulp.
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    7 bytes
// Table    2496 bytes, fixedpoint_exp_32_table
//
// a is k ln 2 - r as in exp_32.S. Over all arguments the relative error of the mantissa e^-r is at
// most 0.379 2^-32, so the error of the result, in units of 2^-16 ulp, is less than half of (its
// upper half plus 1); truncation adds one more unit. The argument is kept on the stack for the code
// that decides close cases.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "exp_32.inc"
#include "scale_40.inc"

// The function of kernel/power_side.hpp that decides close cases, under its mangled name.
#define ROUNDED_POWER _ZN10fixedpoint6kernel13rounded_powerIlLi16EEET_S2_S2_

// Bytes of r, the lowest first.
#define rest0 r26
#define rest1 r18
#define rest2 r19
#define rest3 r20
#define rest4 r30
// k + 17
#define k r27

    SECTION fixedpoint_exp_q16_16_correctly_rounded
.Lout_of_range:
    tst r25
    brmi 1f
    XJMP fixedpoint_largest_32
1:  XJMP fixedpoint_zero_32

    ENTRY fixedpoint_exp_q16_16_correctly_rounded
    movw r26, r24
    adiw r26, 12
    cpi r26, 23
    cpc r27, r1
    brsh .Lout_of_range
    push_all r22, r23, r24
    // k + 17 = floor((185 (a + 12) + 93) / 128)
    ldi r30, 185
    mul r26, r30
    movw r26, r0
    mul r23, r30
    subi r26, -93
    sbci r27, -1
    add r26, r1
    clr zero
    adc r27, zero
    lsl r26
    rol r27
    multiple_of_ln2 (17), rest0, rest1, rest2, rest3, rest4
    sub rest3, r22
    sbc rest4, r23
    subi k, -8
    exponential
    scale r20
    // r21:r20 = the fraction. It is safely away from 1/2 if its upper byte is by r25 / 2 + 2.
    mov r19, r25
    lsr r19
    subi r19, -2
    mov r18, r21
    subi r18, 128
    add r18, r19
    lsl r19
    cp r18, r19
    brlo .Lclose_to_a_tie
.Lcertain:
    lsl r21
    adc_each r22, r1, 4
    pop_all r0, r0, r0
    brmi 1f
    ret
1:  XJMP fixedpoint_largest_32

.Lclose_to_a_tie:
    tst r25
    brmi .Lcertain
    movw r18, r24
    lsr_bytes r18, 2
    subi_bytes r18, -2, 2
    movw r26, r20
    subi r27, 128
    add_bytes r26, r18, 2
    lsl_bytes r18, 2
    cp_bytes r26, r18, 2
    brsh .Lcertain
    movw_bytes r18, r22, 4
    pop_all r24, r23, r22
    mov r25, r24
    lsl r25
    sbc r25, r25
    XJMP ROUNDED_POWER
    ENDFUNC fixedpoint_exp_q16_16_correctly_rounded
#endif
