// SPDX-License-Identifier: MIT
// int32_t fixedpoint_divide_q<32 - F>_<F>(int32_t a, int32_t b)
// floor(a 2^F / b + 1/2), saturated. If b = 0: the largest number if a > 0, the smallest if a < 0,
// 0 if a = 0. The quotient, rounded to nearest, half up, of every 32-bit format except Q16.16,
// which has a faster kernel of its own.
//
// In       a = r25:r22, b = r21:r18
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    6 bytes
// Table    512 bytes, fixedpoint_reciprocal_table
//
// The method is that of divide_q16_16.S: the divisor d = 2^k |b| has its leading one in bit 31,
// and v in 2^8..2^9 gives D = d v = 2^40 - E, 0 < E < 2^32. A base-256 digit of the quotient is
// then the highest of the six bytes of the dividend,
//
//     x - digit D = x - digit 2^40 + digit E,
//
// or one more if that carries out of 40 bits. The dividend is n = 2^m |a|, m = (F + k) mod 8;
// j = floor((F + k) / 8) digits follow the first one, since n 2^(8 j) / d is the quotient. Leading
// digits are skipped while the highest byte of n shows that they are zero. If j is then 4 or more,
// the quotient is at least 2^32 128 / 129 and out of range; if it is 3, the quotient may be.
//
// The bytes of the quotient replace those of the dividend, in nine registers of which r22 is always
// the last digit: a dividend with fewer digits begins further down. Finally, twice the remainder is
// compared with D; a tie rounds up.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "digits_32.inc"

#define n4 r14
#define digits r15

    SECTION fixedpoint_divide_32
.Lzero_divisor:
    or_bytes r0, n0, 4
    breq .Lrestore
.Lsaturate:
    ldi r22, 0xff
    ldi r23, 0xff
    movw r24, r22
    andi r25, 0x7f
    brtc .Lrestore
    com_bytes r22, 4
.Lrestore:
    pop_all r29, r28, r17, r16, r15, r14
    clr r1
    ret
.Lsmall_divisor:
    or_bytes r0, d0, 3
    breq .Lzero_divisor
1:  mov_from_top d1, d0, 3
    clr d0
    inc r31
    tst d3
    breq 1b
    rjmp .Ldivisor

    // r30 = 2^(F mod 8), r31 = floor(F / 8)
    ENTRY fixedpoint_divide_32
    push_all r14, r15, r16, r17, r28, r29
    clr nothing
    mov r0, n3
    eor r0, d3
    bst r0, 7
    tst n3
    brpl 1f
    negate_bytes n0, 4
1:  tst d3
    brpl 1f
    negate_bytes d0, 4
1:  tst d3
    breq .Lsmall_divisor
.Ldivisor:
    movw r26, r30
    mov digits, r27
    ldi r31, hi8(fixedpoint_reciprocal_table)
    mov r30, d3
    lpm r17, Z              // 2^k without whole bytes
    mul r17, r26
    tst r1
    breq 1f
    inc digits
    mov r0, r1
1:  mov r26, r0             // 2^m
    mul n3, r26
    mov n4, r1
    mov n3, r0
    mul_or_bytes n0, r26, n0, 3
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
    // Digits that are certainly zero
1:  tst n4
    brne 2f
    cp n3, d3
    brsh 2f
    tst digits
    breq 2f
    mov n4, n3
    mov_from_top n1, n0, 3
    clr n0
    dec digits
    rjmp 1b
2:  ldi r27, 4
    cp digits, r27
    brlo 2f
    rjmp .Lsaturate
2:  mov r30, d3
    mov r0, d2
    lsl r0
    rol r30
    inc r31
    find_reciprocal
    // The dividend r25..r20 = n v
    mul n0, v
    movw r20, r0
    mul n2, v
    movw r18, r0
    mul n4, v
    movw r26, r0
    mul_add n3, v, r19, r26, nothing, r27
    mul_add n1, v, r21, r18, nothing, r19, r26, r27
    add r21, n0
    adc r18, n1
    adc r19, n2
    adc r26, n3
    adc r27, n4
    movw r22, r18
    movw r24, r26
    clr_bytes r17, 3
    sbrs digits, 1
    rjmp 1f
    sbrc digits, 0
    rjmp .Ldigit_3
    mov_bytes r19, r20, 6
    clr r25
    rjmp .Ldigit_2
1:  movw_bytes r18, r20, 6
    clr r24
    clr r25
    sbrc digits, 0
    rjmp .Ldigit_1
    mov_bytes r17, r18, 6
    clr r23
    rjmp .Ldigit_0

.Ldigit_3:
    digit r25, r24, r23, r22, r21, r20
    inc r25
9:
.Ldigit_2:
    digit r24, r23, r22, r21, r20, r19
    subi r24, 0xff
    sbci r25, 0xff
9:
.Ldigit_1:
    digit r23, r22, r21, r20, r19, r18
    increment_bytes r23, 3
9:
.Ldigit_0:
    digit r22, r21, r20, r19, r18, r17
    increment_bytes r22, 4
9:  lsl_bytes r17, 5
    brcs 1f
    add_bytes r17, e0, 4
    adc r21, nothing
    brcc 2f
    brtc 1f
    or r17, r18
    or r17, r19
    or r17, r20
    or r17, r21
    breq 2f
1:  increment_bytes r22, 4
2:  tst r25
    brpl 3f
    rjmp .Lsaturate
3:  brtc 4f
    negate_bytes r22, 4
4:  rjmp .Lrestore
    ENDFUNC fixedpoint_divide_32

    .macro kernels integer, fraction
    FUNCTION fixedpoint_divide_q\integer\()_\fraction
    ldi r30, 1 << (\fraction % 8)
    ldi r31, \fraction / 8
    XJMP fixedpoint_divide_32
    ENDFUNC fixedpoint_divide_q\integer\()_\fraction
    .endm

#include "splits_32.inc"

#endif
