// SPDX-License-Identifier: MIT
// int64_t fixedpoint_dot2_q32_32(const int64_t* a, const int64_t* b)
// int64_t fixedpoint_dot3_q32_32(const int64_t* a, const int64_t* b)
// floor(sum a_i b_i / 2^32 + 1/2) modulo 2^64 of 2 or 3 components: one rounding.
//
// In       a = r25:r24, b = r23:r22, in RAM
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    23 bytes
//
// Bytes 0..11 of the exact sum, 2^96 being beyond the result, take one component after the other,
// and of it one byte of b after the other. The even and the odd products of a byte of b lie side by
// side and go into the sum in one carry chain each. They are products of unsigned numbers: where
// a_i is negative, they are 2^64 b_i too much, and likewise for b_i.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define s3 r5
#define s8 r10
#define s9 r11
#define s10 r12
#define s11 r13
#define a0 r14
#define a1 r15
#define a2 r16
#define a3 r17
#define a4 r18
#define a5 r19
#define a6 r20
#define a7 r21
#define digit r22
#define zero r23

    // Of byte `byte` of the sum, r2 + byte, unless it lies above 11.
    .macro into operation, byte, value
    .irp n, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13
    .if \n - 2 == \byte
    \operation r\n, \value
    .endif
    .endr
    .endm

    // Four products side by side into bytes `byte`.. of the sum.
    .macro chain p0, p1, p2, p3, byte
    .if \byte + 6 < 12
    mul \p3, digit
    movw r28, r0
    .endif
    .if \byte + 4 < 12
    mul \p2, digit
    movw r26, r0
    .endif
    .if \byte + 2 < 12
    mul \p1, digit
    movw r24, r0
    .endif
    mul \p0, digit
    into add, (\byte), r0
    into adc, (\byte + 1), r1
    into adc, (\byte + 2), r24
    into adc, (\byte + 3), r25
    into adc, (\byte + 4), r26
    into adc, (\byte + 5), r27
    into adc, (\byte + 6), r28
    into adc, (\byte + 7), r29
    into adc, (\byte + 8), zero
    into adc, (\byte + 9), zero
    into adc, (\byte + 10), zero
    into adc, (\byte + 11), zero
    .endm

    SECTION fixedpoint_dot_q32_32
    ENTRY fixedpoint_dot2_q32_32
    ldi r21, 2
    rjmp 1f
    ENDFUNC fixedpoint_dot2_q32_32

    ENTRY fixedpoint_dot3_q32_32
    ldi r21, 3
1:
    .irp n, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 28, 29
    push r\n
    .endr
    movw r26, r24
    movw r30, r22
    mov r24, r21
    clr zero
    clr r2
    clr r3
    .irp n, 4, 6, 8, 10, 12
    movw r\n, r2
    .endr
.Lcomponent:
    .irp n, 14, 15, 16, 17, 18, 19, 20, 21
    ld r\n, X+
    .endr
    push r24
    push r26
    push r27
    .irp n, 0, 1, 2, 3, 4, 5, 6, 7
    ldd digit, Z + \n
    chain a0, a2, a4, a6, \n
    chain a1, a3, a5, a7, (\n + 1)
    .endr
    tst digit
    brpl 1f
    sub s8, a0
    sbc s9, a1
    sbc s10, a2
    sbc s11, a3
1:  tst a7
    brpl 2f
    ld r26, Z
    ldd r27, Z + 1
    ldd r28, Z + 2
    ldd r29, Z + 3
    sub s8, r26
    sbc s9, r27
    sbc s10, r28
    sbc s11, r29
2:  adiw r30, 8
    pop r27
    pop r26
    pop r24
    dec r24
    breq 3f
    rjmp .Lcomponent
3:  clr r1
    lsl s3
    .irp n, 6, 7, 8, 9, 10, 11, 12, 13
    adc r\n, r1
    .endr
    movw r18, r6
    movw r20, r8
    movw r22, r10
    movw r24, r12
    .irp n, 29, 28, 17, 16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2
    pop r\n
    .endr
    ret
    ENDFUNC fixedpoint_dot3_q32_32

#endif
