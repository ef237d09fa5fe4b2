// SPDX-License-Identifier: MIT
// int64_t fixedpoint_divide_64(int64_t a, int64_t b, uint8_t fraction)
// floor(a 2^fraction / b + 1/2), saturated. If b = 0: the largest number if a > 0, the smallest if
// a < 0, 0 if a = 0. fraction must be below 64.
//
// In       a = r25:r18, b = r17:r10, fraction = r8
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    24 bytes
// Table    256 bytes, fixedpoint_long_division_table
//
// Long division of magnitudes in base 256 by d = 2^k |b|, whose leading one is bit 63. The dividend
// is |a| 2^(fraction + k): a is shifted left by that exponent modulo 8, and each whole byte of the
// exponent gives one more digit, for which a zero byte is appended to the remainder u. A digit
// estimated from the highest bytes (long_division.inc) is at most 1 too large; then d is added
// back. Digits that are certainly zero do not cost a division. The first digit that is not
// certainly zero forms a nonzero number together with the next one: with more than nine digits left
// the quotient is out of range, and with nine the first must be zero. Finally, twice the remainder
// is compared with d.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

// |a|, then the remainder, finally the quotient
#define u0 r18
#define u1 r19
#define u2 r20
#define u3 r21
#define u4 r22
#define u5 r23
#define u6 r24
#define u7 r25
#define u8 r28
#define d0 r10
#define d1 r11
#define d2 r12
#define d3 r13
#define d4 r14
#define d5 r15
#define d6 r16
#define d7 r17
#define x0 d7
#define x1 d6
#define inverse r4
#define zero r5
#define count r6

#include "long_root.inc"

    .macro negate number
    com_bytes \number, 8
    adc_each \number, zero, 8
    .endm

    .macro next_byte
    mov u8, u7
    mov_from_top u1, u0, 7
    clr u0
    .endm

    // u -= digit (p4 2^32 + p2 2^16 + p0) 2^(8 byte), where u`byte` is r(18 + byte).
    .macro take_off byte, p0, p2, p4
    mul digit, \p0
    movw r30, r0
    mul digit, \p2
    movw r2, r0
    mul digit, \p4
    .if \byte == 0
    sub u0, r30
    sbc u1, r31
    sbc u2, r2
    sbc u3, r3
    sbc u4, r0
    sbc u5, r1
    sbc u6, zero
    .else
    sub u1, r30
    sbc u2, r31
    sbc u3, r2
    sbc u4, r3
    sbc u5, r0
    sbc u6, r1
    .endif
    sbc u7, zero
    sbc u8, zero
    .endm

    FUNCTION fixedpoint_divide_64
    push_all r28, r17, r16, r15, r14, r13, r12, r11, r10, r6, r5, r4, r3, r2
    clr zero
    mov r0, d7
    eor r0, u7
    bst r0, 7
    tst u7
    brpl 1f
    negate u0
1:  tst d7
    brpl 1f
    negate d0
1:  or_bytes r0, d0, 8
    brne 1f
    rjmp .Lzero_divisor
    // r30 = fraction + k
1:  mov r30, r8
    rjmp 2f
1:  mov_from_top d1, d0, 7
    clr d0
    subi r30, -8
2:  tst d7
    breq 1b
    brmi 2f
1:  lsl_bytes d0, 8
    inc r30
    tst d7
    brpl 1b
2:  clr u8
    mov r31, r30
    andi r31, 7
    breq 2f
1:  lsl_bytes u0, 8
    rol u8
    dec r31
    brne 1b
2:  lsr r30
    lsr r30
    lsr r30
    inc r30
    mov count, r30
    // Digits that are certainly zero
    rjmp 2f
1:  dec count
    breq .Lno_digit
    next_byte
2:  tst u8
    brne 1f
    cp u7, d7
    brcs 1b
1:  invert inverse, d7, d6
    mov r30, count
    cpi r30, 10
    brcs 1f
    rjmp .Lsaturate
.Lno_digit:
    clr r30
1:  cpi r30, 8
    brcc 1f
    push zero
    inc r30
    rjmp 1b
1:  tst count
    brne .Ldigit
    rjmp .Lcompare

.Ldigit:
    estimate u8, u7, u6
    take_off 0, d0, d2, d4
    take_off 1, d1, d3, d5
    brpl 2f
1:  dec digit
    add_bytes u0, d0, 8
    adc u8, zero
    brmi 1b
2:  mov r30, count
    cpi r30, 9
    brne 1f
    tst digit
    breq 2f
    rjmp .Lsaturate
1:  push digit
2:  dec count
    breq .Lcompare
    next_byte
    rjmp .Ldigit

    // Carry clear if 2 u >= d or, for a negative quotient, 2 u > d.
.Lcompare:
    lsl_bytes u0, 8
    brcs 2f
    brtc 1f
    sec
1:  cpc_bytes u0, d0, 8
    rjmp 3f
2:  clc
3:  pop_all r18, r19, r20, r21, r22, r23, r24, r25
    sbrc u7, 7
    rjmp .Lsaturate
    sbci_each u0, 0xff, 8
    brmi .Lsaturate
    brtc .Lrestore
    negate u0
    rjmp .Lrestore

.Lzero_divisor:
    or_bytes r0, u0, 8
    breq .Lrestore
.Lsaturate:
    ldi u0, 0xff
    brtc 1f
    clr u0
1:  mov u1, u0
    movw_each u2, u0, 6
    subi u7, 0x80
.Lrestore:
    clr r1
    pop_all r2, r3, r4, r5, r6, r10, r11, r12, r13, r14, r15, r16, r17, r28
    ret
    ENDFUNC fixedpoint_divide_64

#endif
