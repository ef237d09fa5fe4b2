// SPDX-License-Identifier: MIT
// The length of vectors with a component of 2^23 (128 in Q16.16) or more. Not a C function: entered
// by a jump from the lengths with r31:r30 the vector and r26 its number of components, 2 or 3.
//
// r25:r24:r23:r22 = the integer nearest to the length, at most 2^31 - 1. Keeps what calls keep.
//
// Technique. The squares of the bytes are summed in r23:...:r16, the products of two bytes in
// r14:...:r8, to be doubled once. length_root.S takes the root of the upper six bytes; its
// remainder and the lower two bytes make eight more bits, one at a time. About 95 cycles a
// component, 30 a bit.

#ifdef __AVR__
#define zero r15
#define count r28

    .section .text.fixedpoint_length_long, "ax", @progbits
    .global fixedpoint_length_long
    .type fixedpoint_length_long, @function
fixedpoint_length_long:
    .irp register, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 28
    push r\register
    .endr
    mov count, r26
    clr zero
    clr r16
    clr r17
    movw r18, r16
    movw r20, r16
    movw r22, r16
    movw r8, r16
    movw r10, r16
    movw r12, r16
    clr r14
1:  ld r24, Z+
    ld r25, Z+
    ld r26, Z+
    ld r27, Z+
    tst r27
    brpl 2f
    com r25
    com r26
    com r27
    neg r24
    sbci r25, 0xff
    sbci r26, 0xff
    sbci r27, 0xff
    // The squares of the bytes
2:  mul r24, r24
    add r16, r0
    adc r17, r1
    adc r18, zero
    adc r19, zero
    adc r20, zero
    adc r21, zero
    adc r22, zero
    adc r23, zero
    mul r25, r25
    add r18, r0
    adc r19, r1
    adc r20, zero
    adc r21, zero
    adc r22, zero
    adc r23, zero
    mul r26, r26
    add r20, r0
    adc r21, r1
    adc r22, zero
    adc r23, zero
    mul r27, r27
    add r22, r0
    adc r23, r1
    // The products of two bytes
    mul r24, r25
    add r8, r0
    adc r9, r1
    adc r10, zero
    adc r11, zero
    adc r12, zero
    adc r13, zero
    adc r14, zero
    mul r24, r26
    add r9, r0
    adc r10, r1
    adc r11, zero
    adc r12, zero
    adc r13, zero
    adc r14, zero
    mul r24, r27
    add r10, r0
    adc r11, r1
    adc r12, zero
    adc r13, zero
    adc r14, zero
    mul r25, r26
    add r10, r0
    adc r11, r1
    adc r12, zero
    adc r13, zero
    adc r14, zero
    mul r25, r27
    add r11, r0
    adc r12, r1
    adc r13, zero
    adc r14, zero
    mul r26, r27
    add r12, r0
    adc r13, r1
    adc r14, zero
    dec count
    breq 3f
    rjmp 1b
3:  lsl r8
    rol r9
    rol r10
    rol r11
    rol r12
    rol r13
    rol r14
    add r17, r8
    adc r18, r9
    adc r19, r10
    adc r20, r11
    adc r21, r12
    adc r22, r13
    adc r23, r14
    cpi r23, 0x40
    brlo 4f
    rjmp .Lclamp
4:  call fixedpoint_length_root
    // The remainder of the root, which was rounded, brought to 0 .. 2 root.
    sec
    adc r18, r22
    adc r19, r23
    adc r20, r24
    adc r21, r25
    brpl 5f
    subi r22, 1
    sbci r23, 0
    sbci r24, 0
    sec
    adc r18, r22
    adc r19, r23
    adc r20, r24
    adc r21, r25
    add r18, r22
    adc r19, r23
    adc r20, r24
    adc r21, r25
    // A bit: one where the remainder, or it with the next two bits of N, exceeds the root.
5:  ldi count, 8
    ldi r26, 0x3f
6:  cp r26, r17
    cpc r22, r18
    cpc r23, r19
    cpc r24, r20
    cpc r25, r21
    brcs 7f
    lsl r16
    rol r17
    rol r18
    rol r19
    rol r20
    rol r21
    lsl r16
    rol r17
    rol r18
    rol r19
    rol r20
    rol r21
    lsl r22
    rol r23
    rol r24
    rol r25
    dec count
    brne 6b
    rjmp 8f
7:  lsl r16
    rol r17
    rol r18
    rol r19
    rol r20
    rol r21
    lsl r16
    rol r17
    rol r18
    rol r19
    rol r20
    rol r21
    lsl r22
    rol r23
    rol r24
    rol r25
    sec
    sbc r18, r22
    sbc r19, r23
    sbc r20, r24
    sbc r21, r25
    sub r18, r22
    sbc r19, r23
    sbc r20, r24
    sbc r21, r25
    inc r22
    dec count
    brne 6b
    // Round.
8:  cp r22, r18
    cpc r23, r19
    cpc r24, r20
    cpc r25, r21
    adc r22, r1
    adc r23, r1
    adc r24, r1
    adc r25, r1
    brpl 9f
.Lclamp:
    clr r1
    ldi r22, 0xff
    ldi r23, 0xff
    ldi r24, 0xff
    ldi r25, 0x7f
9:
    .irp register, 28, 17, 16, 15, 14, 13, 12, 11, 10, 9, 8
    pop r\register
    .endr
    ret
    .size fixedpoint_length_long, . - fixedpoint_length_long
#endif
