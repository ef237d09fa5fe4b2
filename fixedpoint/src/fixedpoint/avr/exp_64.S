// SPDX-License-Identifier: MIT
// int64_t fixedpoint_exp_64(int64_t a, uint8_t fraction)
// 2^fraction e^(a / 2^fraction) within 0.66 ulp; saturated to the largest number, 0 where that is
// nearest. fraction < 64.
//
// In       a = r25:r18, fraction = r16
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    15 bytes
// Table    4451 bytes, fixedpoint_exp_64_table
//
// That is 2^32 e^x, x = a / 2^fraction + (fraction - 32) ln 2 in units of 2^-72: a moves up to its
// place, or down, bit by bit, and the table of exp_q32_32.S, which has the rest, has the multiple of
// ln 2 modulo 1. What is before the point of it is (178 fraction + 192) / 256 - 23, rounded downward.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define zero r17
#include "exp_64.inc"

    SECTION fixedpoint_exp_64
.Lunrounded:
    .irp n, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 28, 29
    push r\n
    .endr
    mov r28, r16
    clr zero
    bst r25, 7
    // r27:r18 = a 2^16, to be moved up by 56 - fraction bits
    movw r26, r24
    movw r24, r22
    movw r22, r20
    movw r20, r18
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
    mov r27, r26
    mov r26, r25
    mov r25, r24
    mov r24, r23
    mov r23, r22
    mov r22, r21
    mov r21, r20
    ldi r20, 0
2:  subi r29, 8
    brcc 1b
    subi r29, -8
    breq 5f
3:  lsl r20
    rol r21
    rol r22
    rol r23
    rol r24
    rol r25
    rol r26
    rol r27
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
    movw r20, r18
    movw r22, r18
    movw r24, r18
6:  clr r1
    .irp n, 29, 28, 17, 16, 15, 14, 13, 12, 11, 10, 9, 8
    pop r\n
    .endr
    ret

4:  asr r27
    ror r26
    ror r25
    ror r24
    ror r23
    ror r22
    ror r21
    ror r20
    ror r19
    inc r29
    brne 4b
5:  mov r30, r27
    lsl r30
    brvs .Lbeyond
    inc r28
    find multiples, r28, 9
    load 8, 9
    dec r28
    add r18, r8
    adc r19, r9
    adc r20, r10
    adc r21, r11
    adc r22, r12
    adc r23, r13
    adc r24, r14
    adc r25, r15
    adc r26, r16
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
    sub r8, r18
    sbc r9, r19
    sbc r10, r20
    sbc r11, r21
    sbc r12, r22
    sbc r13, r23
    sbc r14, r24
    sbc r15, r25
    sbc r16, r26
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
