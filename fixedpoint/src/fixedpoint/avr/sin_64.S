// SPDX-License-Identifier: MIT
// int64_t fixedpoint_sin_64(int64_t angle, uint8_t fraction)
// int64_t fixedpoint_cos_64(int64_t angle, uint8_t fraction)
// Sine and cosine of angle / 2^fraction radians, for every input; within 0.7 ulp, in [-1, 1].
// fraction must be in 31..56.
//
// void fixedpoint_sincos_64(int64_t angle, int64_t* sine_and_cosine, uint8_t fraction)
// Both, bit for bit as above: one argument reduction, two evaluations.
//
// In       angle = r25:r18, fraction = r16; sine_and_cosine = r17:r16, fraction = r14
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    24 bytes, sincos 34
// Table    2346 bytes, fixedpoint_septic_sine_table
//
// Argument reduction: the magnitude of the angle becomes S in units of 2^-63, of which 12 bytes
// count. The upper 5 bytes times 2/pi give the whole quarter turns, or one less; the remainder of
// S, with pi/2 to 10 bytes, contains at most one more.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "septic_64.inc"

    // r11:r2 = pi/2 times the 16 bits in `high` and `low`, to that many bytes; byte `first` and
    // those above it count.
    .macro times_half_pi high, low, bytes
    clr r2
    clr r3
    .set j, 0
    .rept \bytes
    .if j < 2
    ldi r26, (0xc4c6 >> (8 * j)) & 0xff
    .elseif j < 6
    ldi r26, (0x2168c234 >> (8 * (j - 2))) & 0xff
    .else
    ldi r26, (0xc90fdaa2 >> (8 * (j - 6))) & 0xff
    .endif
    mul \low, r26
    add 2 + j, r0
    .if j + 1 < \bytes
    adc 3 + j, r1
    .if j + 2 < \bytes
    clr 4 + j
    adc 4 + j, zero
    .endif
    mul \high, r26
    add 3 + j, r0
    .if j + 2 < \bytes
    adc 4 + j, r1
    .endif
    .endif
    .set j, j + 1
    .endr
    .endm

    SECTION fixedpoint_sin_64
    // r25:r18 = the angle in units of 2^-63 minus its whole quarter turns, which are added to r28;
    // T = its sign
.Lreduce:
    clr zero
    bst r25, 7
    brtc 1f
    negate_bytes r18, 8
1:  clr r14
    clr r15
    movw r16, r14
    mov r30, r29
    subi r30, 31
    rjmp 3f
2:  .irp n, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24
    .set place, \n
    mov place, place + 1
    .endr
    clr r25
3:  subi r30, 8
    brcc 2b
    subi r30, -8
    breq 5f
4:  lsr r25
    .irp n, 24, 23, 22, 21, 20, 19, 18, 17, 16, 15, 14
    ror r\n
    .endr
    dec r30
    brne 4b
5:  ldi r26, 0xa2
    mov r13, r26
    ldi r26, 0xf9
    mov r12, r26
    ldi r26, 0x83
    mov r11, r26
    ldi r26, 0x6e
    mov r10, r26
    ldi r26, 0x4e
    mov r9, r26
    fraction_product 25, 13, 5, 3
    lsl_bytes r3, 5
    movw r22, r4
    movw r24, r6
    add r28, r22
    times_half_pi r23, r22, 10
    cp zero, r2
    cpc zero, r3
    .irp n, 14, 15, 16, 17, 18, 19, 20, 21
    sbc \n, \n - 10
    .endr
    mov r0, r24
    or r0, r25
    brne 8f
    rjmp 6f
8:  times_half_pi r25, r24, 8
    sub r14, r2
    .irp n, 15, 16, 17, 18, 19, 20, 21
    sbc \n, \n - 12
    .endr
6:  movw_from_top r18, r14, 8
    cpi r25, 0xc9
    brlo 7f
    inc r28
    subi_bytes r18, 0xc90fdaa22168c234, 8
    brcc 7f
    dec r28
    subi_bytes r18, 0x36f0255dde973dcc, 8
7:  ret

    // r25:r18 = the sine of that plus r28 quarter turns, negated if T is set
.Levaluate:
    sbrs r28, 0
    rjmp 1f
    com_bytes r18, 8
    subi_bytes r18, 0x36f0255dde973dcb, 8
1:  evaluate fixedpoint_septic_sine_table
    clr r17
    round_from 63
    clr r26
    bld r26, 1
    eor r26, r28
    sbrs r26, 1
    ret
    negate_bytes r18, 8
    ret

    ENTRY fixedpoint_cos_64
    save_registers
    ldi r28, 1
    mov r29, r16
    rcall .Lreduce
    clt
    rjmp 1f
    ENDFUNC fixedpoint_cos_64

    ENTRY fixedpoint_sin_64
    save_registers
    ldi r28, 0
    mov r29, r16
    rcall .Lreduce
1:  rcall .Levaluate
    restore_registers
    ret
    ENDFUNC fixedpoint_sin_64

    ENTRY fixedpoint_sincos_64
    save_registers
    push r16
    push r17
    ldi r28, 0
    mov r29, r14
    rcall .Lreduce
    push_all r18, r19, r20, r21, r22, r23, r24, r25
    rcall .Levaluate
    pop_all r9, r8, r7, r6, r5, r4, r3, r2
    pop r31
    pop r30
    .irp n, 18, 19, 20, 21, 22, 23, 24, 25
    st Z+, r\n
    .endr
    push r30
    push r31
    movw_bytes r18, r2, 8
    inc r28
    clt
    rcall .Levaluate
    pop r31
    pop r30
    .irp n, 18, 19, 20, 21, 22, 23, 24, 25
    st Z+, r\n
    .endr
    restore_registers
    ret
    ENDFUNC fixedpoint_sincos_64
#endif
