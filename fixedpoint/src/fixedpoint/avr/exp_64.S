// SPDX-License-Identifier: MIT
// int64_t fixedpoint_exp_64(int64_t a, uint8_t fraction)
// 2^fraction e^(a / 2^fraction) within 0.66 ulp; saturated to the largest number. fraction must be
// below 64.
//
// In       a = r25:r18, fraction = r16
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    15 bytes
// Table    4451 bytes, fixedpoint_exp_64_table
//
// That is 2^32 e^x with x = a / 2^fraction + (fraction - 32) ln 2 in units of 2^-72: a is shifted
// left or right bit by bit, and the table of exp_q32_32.S, which does the rest, contains the
// multiple of ln 2 modulo 1. The integer part of that is (178 fraction + 192) / 256 - 23, rounded
// downward.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define zero r17
#include "exp_64.inc"

    SECTION fixedpoint_exp_64
.Lunrounded:
    push_all r8, r9, r10, r11, r12, r13, r14, r15, r16, r17, r28, r29
    mov r28, r16
    clr zero
    bst r25, 7
    // r27:r18 = a 2^16, to be shifted left by 56 - fraction bits
    movw_from_top r20, r18, 8
    ldi r18, 0
    ldi r19, 0
    ldi r29, 56
    sub r29, r28
    brcs 4f
    rjmp 2f
1:  mov r30, r26
    lsl r30
    sbc r30, r30
    cp r30, r27
    brne .Lbeyond
    mov_from_top r21, r20, 7
    ldi r20, 0
2:  subi r29, 8
    brcc 1b
    subi r29, -8
    breq 5f
3:  lsl_bytes r20, 8
    brvs .Lbeyond
    dec r29
    brne 3b
    rjmp 5f

    // Above 2^63, which saturates, or 0.
.Lbeyond:
    brts .Lbelow
.Labove:
    ldi r25, 0x80
    rjmp 6f
.Lbelow:
    clr r18
    clr r19
    movw_each r20, r18, 6
6:  clr r1
    pop_all r29, r28, r17, r16, r15, r14, r13, r12, r11, r10, r9, r8
    ret

4:  asr_bytes r19, 9
    inc r29
    brne 4b
5:  mov r30, r27
    lsl r30
    brvs .Lbeyond
    inc r28
    find multiples, r28, 9
    load 8, 9
    dec r28
    add_bytes r18, r8, 9
    adc r27, zero
    ldi r29, 178
    mul r28, r29
    movw r30, r0
    subi r30, 64    // 2^16 - 192
    sbci r31, 0xff
    subi r31, 23
    add r27, r31
    cpi r27, 22
    brlt 1f
    rjmp .Labove
1:  cpi r27, -23
    brge 1f
    rjmp .Lbelow
1:
    multiple_of_ln2 r27, r26, r29
    sub_bytes r8, r18, 9
    clt
    XJMP fixedpoint_power_of_rest_q32_32

    ENTRY fixedpoint_exp_64
    rcall .Lunrounded
    tst r25
    brpl 1f
    ldi r18, 0xff
    ldi r19, 0xff
    movw r20, r18
    movw r22, r18
    ldi r24, 0xff
    ldi r25, 0x7f
1:  ret
    ENDFUNC fixedpoint_exp_64
#endif
