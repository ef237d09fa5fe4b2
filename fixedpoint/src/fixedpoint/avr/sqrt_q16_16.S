; SPDX-License-Identifier: MIT
#ifdef __AVR__

#define c0 r22
#define c1 r23
#define c2 r24
#define zero r25

    ; root16 = root[index] + slope[index] * next / 256, from r30 = index
    .macro root16 low, high, slope, next
    ldi r31, hi8(fixedpoint_sqrt_table)
    lpm \low, Z
    inc r31
    lpm \high, Z
    inc r31
    lpm \slope, Z
    mul \slope, \next
    add \low, r1
    adc \high, zero
    .endm

    ; r26:r19:r18 = c^2 + c - (a0 << 16) modulo 2^24, from r26 = (c0 c2 << 1) - a0
    .macro test_half
    mul c0, c0
    movw r18, r0
    add r18, c0
    adc r19, c1
    adc r26, c2
    mul c1, c1
    add r26, r0
    mul c1, c0
    add r19, r0
    adc r26, r1
    add r19, r0
    adc r26, r1
    .endm

    .section .text.fixedpoint_sqrt_q16_16, "ax", @progbits
    .global fixedpoint_sqrt_q16_16
    .type fixedpoint_sqrt_q16_16, @function
fixedpoint_sqrt_q16_16:
    sbiw r24, 0
    brne .Labove_one
    cpi r23, 64
    brlo .Lbelow_quarter

    ; 1/4 <= a < 1
    mov r30, r23
    mov r26, r22
    root16 c0, c1, r18, r26
    neg r26
    test_half
    brmi 1f
2:  clr r1
    ret
1:  subi c0, 0xff
    sbci c1, 0xff
    cpi r26, 0xff
    breq 2b
    rjmp .Lremainder_of_two

.Lbelow_quarter:
    cpi r23, 16
    brsh 1f
    rjmp .Lbelow_sixteenth
1:  movw r18, r22
    lsl r18
    rol r19
    lsl r18
    rol r19
    mov r30, r19
    mov r26, r22
    root16 c0, c1, r19, r18
    lsr c1
    ror c0
    brcs 1f
    rjmp .Lnear_half
1:  adc c0, zero
    adc c1, zero
    clr r1
    ret

.Labove_one:
    tst r25
    breq 2f
    brmi 1f
    rjmp .Labove_256
1:  mov r22, r1
    mov r23, r1
    movw r24, r22
    ret
2:
    ldi r20, 64
    ldi r27, 2
    ldi r18, 0x80 - 6 * 2
    cpi r24, 4
    brlo 1f
    ldi r20, 16
    ldi r27, 4
    ldi r18, 0x80 - 6 * 4
    cpi r24, 16
    brlo 1f
    ldi r20, 4
    ldi r27, 8
    ldi r18, 0x80 - 6 * 8
    cpi r24, 64
    brlo 1f
    ldi r20, 1
    ldi r27, 16
    ldi r18, 0x80 - 6 * 16
1:  mul r24, r20
    mov r30, r0
    mul r23, r20
    or r30, r1
    mov r26, r0
    mul r22, r20
    or r26, r1
    mov r19, r0
    root16 r20, r21, r24, r26
    mul r20, r20
    sub r19, r1
    sbc r26, zero
    mul r21, r21
    sub r26, r0
    mul r20, r21
    lsl r0
    rol r1
    sub r19, r0
    sbc r26, r1
    mul r19, r24
    mov r19, r1
    mul r26, r24
    mov r26, r22
    add r19, r0
    adc r20, r1
    adc r21, zero
    mul r19, r27
    mov r19, r0
    mov c0, r1
    mul r20, r27
    or c0, r0
    mov c1, r1
    mul r21, r27
    or c1, r0
    mov c2, r1
    cp r19, r18
    brlo .Ldone
    add r19, r18
    brcs .Lup
.Lnear_half:
    neg r26
    mul c0, c2
    add r26, r0
    add r26, r0
    test_half
    brpl .Ldone
.Lup:
    subi c0, 0xff
    sbci c1, 0xff
    sbci c2, 0xff
.Ldone:
    clr r1
    ret

.Lremainder_of_two:
    add r18, c0
    adc r19, c1
    adc r26, zero
    add r18, c0
    adc r19, c1
    adc r26, zero
    brmi .Lup
    clr r1
    ret

.Lbelow_sixteenth:
    ldi r20, 16
    ldi r27, 64
    cpi r23, 4
    brsh 1f
    cpi r23, 1
    brlo .Lbyte
    ldi r20, 64
    ldi r27, 32
1:  mul r23, r20
    mov r30, r0
    mul r22, r20
    or r30, r1
    mov r19, r0
    root16 r20, r21, r18, r19
    mov r26, r22
    mul r20, r27
    mov r18, r0
    mov c0, r1
    mul r21, r27
    or c0, r0
    mov c1, r1
    subi r18, 0x80
    brsh .Lup
    add r18, r27
    breq .Lnear_half
    clr r1
    ret

.Lbyte:
    mov r30, r22
    ldi r31, hi8(fixedpoint_sqrt_table)
    cpi r22, 64
    lpm c0, Z
    inc r31
    lpm c1, Z
    brlo 2f
    ldi r18, 4
1:  lsr c1
    ror c0
    dec r18
    brne 1b
    adc c0, zero
    adc c1, zero
2:  ret

.Labove_256:
    ldi r27, 1
    cpi r25, 64
    brsh 1f
    ldi r27, 4
    cpi r25, 16
    brsh 1f
    ldi r27, 16
    cpi r25, 4
    brsh 1f
    ldi r27, 64
1:  mul r25, r27
    mov r30, r0
    mul r24, r27
    or r30, r1
    mov r26, r0
    mul r23, r27
    or r26, r1
    mov r19, r0
    mul r22, r27
    or r19, r1
    mov r18, r0
    clr zero
    root16 r20, r21, r24, r26
    movw r30, r18
    mul r20, r20
    sub r18, r0
    sbc r19, r1
    sbc r26, zero
    mul r21, r21
    sub r26, r0
    mul r20, r21
    lsl r0
    rol r1
    sub r19, r0
    sbc r26, r1
    ; 24-bit root
    mul r19, r24
    mov r18, r1
    mul r26, r24
    add r18, r0
    adc r20, r1
    adc r21, zero
    subi r18, 6
    sbc r20, zero
    sbc r21, zero
    ; its remainder, upper half
    mul r20, r18
    lsl r0
    rol r1
    sbc r31, zero
    sub r30, r1
    sbc r31, zero
    mul r20, r20
    sub r30, r0
    sbc r31, r1
    mul r21, r18
    lsl r0
    rol r1
    sub r30, r0
    sbc r31, r1
    mul r21, r20
    lsl r0
    sub r31, r0
    mul r30, r24
    mov r30, r1
    mul r31, r24
    add r0, r30
    adc r1, zero
    add r18, r1
    adc r20, zero
    adc r21, zero
    rjmp 2f
1:  lsr r21
    ror r20
    ror r18
2:  lsr r27
    lsr r27
    brne 1b
    ; test
    com r23
    neg r22
    sbci r23, 0xff
    mul r18, r18
    movw r30, r0
    add r30, r18
    adc r31, r20
    adc r22, r21
    adc r23, zero
    mul r20, r18
    add r31, r0
    adc r22, r1
    adc r23, zero
    add r31, r0
    adc r22, r1
    adc r23, zero
    mul r20, r20
    add r22, r0
    adc r23, r1
    mul r21, r18
    add r22, r0
    adc r23, r1
    add r22, r0
    adc r23, r1
    mul r21, r20
    add r23, r0
    add r23, r0
    mov r22, r18
    mov r23, r20
    mov r24, r21
    brpl 1f
    rjmp .Lup
1:  clr r1
    ret
    .size fixedpoint_sqrt_q16_16, . - fixedpoint_sqrt_q16_16
#endif
