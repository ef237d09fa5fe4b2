// SPDX-License-Identifier: MIT
// The last step of functions of 32 bits whose results have an exponent. They are no C functions: a
// kernel jumps here to return.
//
// fixedpoint_scale_40      r25:r22 = r27:r23 2^(r19 - 48) rounded to nearest, saturated; r19 from 7 to
//                          41, r27:r23 at most about 2^39
// fixedpoint_largest_32    r25:r22 = 2^31 - 1
// fixedpoint_smallest_32   r25:r22 = -2^31
// fixedpoint_zero_32       r25:r22 = 0
//
// Changes  r0, r19..r27; r1 is 0 again at return
//
// The 40 bits go up by less than a byte, by a product with a power of 2, and down by whole bytes.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    .macro drop_two_bytes
    mov r21, r23
    movw r22, r24
    mov r24, r26
    clr r25
    clr r26
    .endm

    SECTION fixedpoint_scale_40
    ENTRY fixedpoint_scale_40
    // r26:r21 = the mantissa 2^(r19 mod 8)
    ldi r20, 1
    sbrc r19, 1
    ldi r20, 4
    sbrc r19, 0
    lsl r20
    sbrc r19, 2
    swap r20
    mul r23, r20
    mov r21, r0
    mov r22, r1
    mul r24, r20
    or r22, r0
    mov r23, r1
    mul r25, r20
    or r23, r0
    mov r24, r1
    mul r26, r20
    or r24, r0
    mov r25, r1
    mul r27, r20
    or r25, r0
    mov r26, r1
    clr r1
    // 5 - r19 / 8 bytes go; of the next one the top bit rounds.
    sbrc r19, 5
    rjmp 2f
    drop_two_bytes
    sbrc r19, 4
    rjmp 2f
    drop_two_bytes
2:  sbrc r19, 3
    rjmp 3f
    mov r21, r22
    mov r22, r23
    mov r23, r24
    mov r24, r25
    mov r25, r26
3:  lsl r21
    adc r22, r1
    adc r23, r1
    adc r24, r1
    adc r25, r1
    brmi fixedpoint_largest_32
    ret
    ENDFUNC fixedpoint_scale_40

    ENTRY fixedpoint_largest_32
    ldi r22, 0xff
    ldi r23, 0xff
    movw r24, r22
    lsr r25
    ret
    ENDFUNC fixedpoint_largest_32

    ENTRY fixedpoint_smallest_32
    ldi r22, 0
    ldi r23, 0
    ldi r24, 0
    ldi r25, 0x80
    ret
    ENDFUNC fixedpoint_smallest_32

    ENTRY fixedpoint_zero_32
    ldi r22, 0
    ldi r23, 0
    movw r24, r22
    ret
    ENDFUNC fixedpoint_zero_32
#endif
