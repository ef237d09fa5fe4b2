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
// Bytes 0..11 of the exact sum are formed, since 2^96 is beyond the result: component by component,
// and byte by byte of b. The even products of a byte of b are adjacent, and so are the odd ones:
// each set is added to the sum in one carry chain. The products are unsigned: if a_i is negative,
// they are 2^64 b_i too large, and likewise for b_i.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define s3 r5
#define s8 r10
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

    // An instruction on byte `byte` of the sum, r2 + byte, unless it is above 11.
    .macro into operation, byte, value
    .if \byte < 12
    \operation 2 + \byte, \value
    .endif
    .endm

    // Four adjacent products to bytes `byte`.. of the sum.
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
    push_all r2, r3, r4, r5, r6, r7, r8, r9, r10, r11, r12, r13, r14, r15, r16, r17, r28, r29
    movw r26, r24
    movw r30, r22
    mov r24, r21
    clr zero
    clr r2
    clr r3
    movw_each r4, r2, 10
.Lcomponent:
    ld_each a0, X+, 8
    push_all r24, r26, r27
    .irp n, 0, 1, 2, 3, 4, 5, 6, 7
    ldd digit, Z + \n
    chain a0, a2, a4, a6, \n
    chain a1, a3, a5, a7, (\n + 1)
    .endr
    tst digit
    brpl 1f
    sub_bytes s8, a0, 4
1:  tst a7
    brpl 2f
    ld r26, Z
    ldd_bytes r27, Z + 1, 3
    sub_bytes s8, r26, 4
2:  adiw r30, 8
    pop_all r27, r26, r24
    dec r24
    breq 3f
    rjmp .Lcomponent
3:  clr r1
    lsl s3
    adc_each r6, r1, 8
    movw_bytes r18, r6, 8
    pop_all r29, r28, r17, r16, r15, r14, r13, r12, r11, r10, r9, r8, r7, r6, r5, r4, r3, r2
    ret
    ENDFUNC fixedpoint_dot3_q32_32

#endif
