// SPDX-License-Identifier: MIT
// int32_t fixedpoint_dot2_q<32 - F>_<F>(const int32_t* a, const int32_t* b)
// int32_t fixedpoint_dot3_q<32 - F>_<F>(const int32_t* a, const int32_t* b)
// floor(sum a_i b_i / 2^F + 1/2) modulo 2^32 of 2 or 3 components, one rounding: of each split of
// 32 bits but Q16.16, whose own is faster.
//
// In       a = r25:r24, b = r23:r22, in RAM
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    11 bytes
//
// Bytes 0..top of the exact sum, what lies above `top` being beyond the result, take one component
// after the other, and of it one byte of b after the other. The even and the odd products of a byte
// of b lie side by side and go into the sum in one carry chain each. They are products of unsigned
// numbers: where a_i is negative, they are 2^32 b_i too much, and likewise for b_i.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define s0 r10
#define s1 r11
#define s2 r12
#define s3 r13
#define s4 r14
#define s5 r15
#define s6 r16
#define s7 r17
#define a0 r18
#define a1 r19
#define a2 r20
#define a3 r21
#define digit r22
#define zero r23
#define q0 r24
#define q1 r25
#define count r28

#include "round_32.inc"

    // Of byte `byte` of the sum, r10 + byte, unless it lies above `top`.
    .macro into operation, byte, top, value
    .irp n, 0, 1, 2, 3, 4, 5, 6, 7
    .if (\n == \byte) && (\n <= \top)
    \operation r1\n, \value
    .endif
    .endr
    .endm

    // Two products side by side into bytes `byte`.. of the sum.
    .macro chain low, high, byte, top
    .if \byte + 2 <= \top
    mul \high, digit
    movw q0, r0
    .endif
    mul \low, digit
    into add, (\byte), \top, r0
    into adc, (\byte + 1), \top, r1
    into adc, (\byte + 2), \top, q0
    into adc, (\byte + 3), \top, q1
    into adc, (\byte + 4), \top, zero
    into adc, (\byte + 5), \top, zero
    into adc, (\byte + 6), \top, zero
    into adc, (\byte + 7), \top, zero
    .endm

    .macro row index, top
    ldd digit, Z + \index
    chain a0, a2, \index, \top
    chain a1, a3, (\index + 1), \top
    .endm

    .macro dot fraction, top
1:  push s0
    push s1
    push s2
    push s3
    push s4
    push s5
    push s6
    push s7
    push count
    mov count, r26
    movw r26, r24
    movw r30, r22
    clr zero
    clr s0
    clr s1
    movw s2, s0
    movw s4, s0
    movw s6, s0
2:  ld a0, X+
    ld a1, X+
    ld a2, X+
    ld a3, X+
    row 0, \top
    row 1, \top
    row 2, \top
    row 3, \top
    tst digit
    brpl 3f
    into sub, 4, \top, a0
    into sbc, 5, \top, a1
    into sbc, 6, \top, a2
    into sbc, 7, \top, a3
3:  tst a3
    brpl 4f
    ld digit, Z
    into sub, 4, \top, digit
    .if \top > 4
    ldd digit, Z + 1
    into sbc, 5, \top, digit
    .endif
    .if \top > 5
    ldd digit, Z + 2
    into sbc, 6, \top, digit
    .endif
    .if \top > 6
    ldd digit, Z + 3
    into sbc, 7, \top, digit
    .endif
4:  adiw r30, 4
    dec count
    breq 5f
    rjmp 2b
5:  clr r1
    round \fraction
    pop count
    pop s7
    pop s6
    pop s5
    pop s4
    pop s3
    pop s2
    pop s1
    pop s0
    ret
    .endm

    .macro kernels integer, fraction
    SECTION fixedpoint_dot_q\integer\()_\fraction
    ENTRY fixedpoint_dot2_q\integer\()_\fraction
    ldi r26, 2
    rjmp 1f
    ENDFUNC fixedpoint_dot2_q\integer\()_\fraction

    ENTRY fixedpoint_dot3_q\integer\()_\fraction
    ldi r26, 3
    dot \fraction, ((\fraction - 1) / 8 + 4)
    ENDFUNC fixedpoint_dot3_q\integer\()_\fraction
    .endm

#include "splits_32.inc"

#endif
