// SPDX-License-Identifier: MIT
// void fixedpoint_transposed_quotients_q<32 - F>_<F>(int32_t* q, const int32_t* a, int32_t d, uint8_t n)
// Of a square matrix a of n rows, n = 2 or 3, the quotients q_ij = a_ji / d, d not 0: each is that of
// fixedpoint_divide_q<32 - F>_<F>. Of each split of 32 bits but Q16.16.
//
// In       q = r25:r24, a = r23:r22, in RAM, d = r21:r18, n = r16; q is not in a
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    22 bytes and a call
// Table    512 bytes, fixedpoint_reciprocal_table
//
// The reciprocal R = 2^(F + 8 k) / |d| of five bytes, below the exact one by less than 2, comes from the
// digits of divide_32.S, j = 8 - k. For k = 5, 2^F < |d|, the quotient is |a| R / 2^40. Columns 0 to 2 of that
// product are dropped, which makes less than 3 of its byte 4, and R's error less than 2: byte 4 says how to
// round unless it is 0x7b to 0x80, where a tie may be. For k = 4, |a| 2^8 takes the place of |a| where
// that has four bytes, too. In these rare cases, for other k and beyond the range the quotient is divided.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "digits_32.inc"

#define R0 r2
#define R1 r3
#define R2 r4
#define R3 r5
#define R4 r6
// The digits j, then 0 for k = 5, 1 for k = 4, 2 for others.
#define mode r7
#define divisor r8
#define left r12
#define rows r13
// 2^(F mod 8) and floor(F / 8).
#define split r14
// From an element of a to the next one of its column, in bytes, less the four that are read.
#define step r17

#define a0 r18
#define a1 r19
#define a2 r20
#define a3 r21
// Bytes of the product.
#define p3 r22
#define p4 r23
#define p5 r24
#define p6 r25
#define p7 r30
#define p8 r31

    SECTION fixedpoint_transposed_quotients_32
    // |a| 2^8
.Lshift:
    tst a3
    brne .Ldivide
    mov_from_top a1, a0, 3
    clr a0
    rjmp .Lproduct
.Ldivide:
    push_all r26, r27
    movw r30, r26
    sbiw r30, 4
    ld_each r22, Z+, 4
    movw rB0, divisor
    movw rB2, r10
    movw r30, split
    XCALL fixedpoint_divide_32
    pop_all r27, r26
    rising 0, 4, st, Y+, .Lr22 + \n
    rjmp .Lnext

    // r30 = 2^(F mod 8), r31 = floor(F / 8)
    ENTRY fixedpoint_transposed_quotients_32
    push_all r2, r3, r4, r5, r6, r7, r8, r9, r10, r11, r12, r13, r14, r15, r16, r17, r28, r29
    push_all r25, r24, r23, r22
    movw R0, r30
    mov rows, r16
    movw divisor, d0
    movw r10, d2
    mov mode, r31
    clr nothing
    tst d3
    brpl 2f
    negate_bytes d0, 4
    rjmp 2f
1:  mov_from_top d1, d0, 3
    clr d0
    inc mode
2:  tst d3
    breq 1b
    ldi r31, hi8(fixedpoint_reciprocal_table)
    mov r30, d3
    lpm r17, Z          // 2^k without whole bytes
    mul r17, R0
    tst r1
    breq 1f
    inc mode
    mov r0, r1
1:  mov r26, r0         // 2^m
    mul d3, r17
    mov d3, r0
    mul d1, r17
    movw r28, r0
    mul d0, r17
    movw d0, r0
    mul d2, r17
    mov d2, r0
    add d3, r1
    add d1, r28
    adc d2, r29
    adc d3, nothing
    mov r30, d3
    mov r0, d2
    lsl r0
    rol r30
    inc r31
    find_reciprocal
    // The dividend 2^m v
    mul v, r26
    mov r24, r0
    add r26, r1
    mov r25, r26
    clr_bytes r17, 7
    digit r25, r24, r23, r22, r21, r20
    inc r25
9:  digit r24, r23, r22, r21, r20, r19
    subi r24, 0xff
    sbci r25, 0xff
9:  digit r23, r22, r21, r20, r19, r18
    increment_bytes r23, 3
9:  digit r22, r21, r20, r19, r18, r17
    increment_bytes r22, 4
9:  movw split, R0
    tst r25
    brne 1f
    ldi r25, 0xff       // not 2^40
    mov r24, r25
    movw r22, r24
    mov r21, r25
1:  mov R0, r21
    mov R1, r22
    mov R2, r23
    mov R3, r24
    mov R4, r25
    mov r24, mode
    subi r24, 3
    cpi r24, 2
    brlo 1f
    ldi r24, 2
1:  mov mode, r24
    pop_all r26, r27, r28, r29
    mov step, rows
    dec step
    lsl step
    lsl step
    mov left, rows

.Lelement:
    ld_each a0, X+, 4
    sbrc mode, 1
    rjmp .Ldivide
    mov r0, a3
    eor r0, r11
    bst r0, 7
    tst a3
    brpl 1f
    negate_bytes a0, 4
1:  sbrc mode, 0
    rjmp .Lshift
.Lproduct:
    mul a0, R3
    movw p3, r0
    clr p5
    mul_add a1, R2, p3, p4, nothing, p5
    mul_add a2, R1, p3, p4, nothing, p5
    clr p6
    mul_add a0, R4, p4, p5, nothing, p6
    mul_add a1, R3, p4, p5, nothing, p6
    mul_add a2, R2, p4, p5, nothing, p6
    clr p7
    mul_add a1, R4, p5, p6, nothing, p7
    mul_add a2, R3, p5, p6, nothing, p7
    mul_add a2, R4, p6, p7
    clr p8
    tst a3
    breq 3f
    mul a3, R2
    movw a0, r0
    mul a3, R0
    add p3, r0
    adc p4, r1
    adc p5, a0
    adc p6, a1
    adc p7, nothing
    adc p8, nothing
    mul a3, R3
    movw a0, r0
    mul a3, R1
    add p4, r0
    adc p5, r1
    adc p6, a0
    adc p7, a1
    adc p8, nothing
    mul_add a3, R4, p7, p8
3:  subi p4, 0x7b
    cpi p4, 0x81 - 0x7b
    brlo .Lfar_divide
    cpi p4, 0x100 - 0x7b    // rounds
    adc p5, nothing
    adc p6, nothing
    adc p7, nothing
    adc p8, nothing
    brmi .Lfar_divide
    brtc 2f
    com p8
    com p7
    com p6
    neg p5
    sbci p6, 0xff
    sbci p7, 0xff
    sbci p8, 0xff
2:  st Y+, p5
    st Y+, p6
    st Y+, p7
    st Y+, p8
.Lnext:
    add r26, step
    adc r27, nothing
    dec left
    brne .Lelement_again
    dec rows
    breq 4f
    mov r24, step       // n columns back, and to the next one
    subi r24, 0xfc
    mov r0, r24
    lsr r24
    lsr r24
    mov left, r24
    mul r0, r24
    sub r26, r0
    sbc r27, nothing
    adiw r26, 4
.Lelement_again:
    rjmp .Lelement
.Lfar_divide:
    rjmp .Ldivide
4:  clr r1
    pop_all r29, r28, r17, r16, r15, r14, r13, r12, r11, r10, r9, r8, r7, r6, r5, r4, r3, r2
    ret
    ENDFUNC fixedpoint_transposed_quotients_32

    .macro kernels integer, fraction
    FUNCTION fixedpoint_transposed_quotients_q\integer\()_\fraction
    ldi r30, 1 << (\fraction % 8)
    ldi r31, \fraction / 8
    XJMP fixedpoint_transposed_quotients_32
    ENDFUNC fixedpoint_transposed_quotients_q\integer\()_\fraction
    .endm

#include "splits_32.inc"

#endif
