// SPDX-License-Identifier: MIT
// int32_t fixedpoint_divide_q16_16_small(int32_t a, int32_t b)
//
// What fixedpoint_divide_q16_16 returns, without a table: floor(a 2^16 / b + 1/2), clamped; for
// b = 0 the largest number where a > 0, the smallest where a < 0, 0 where a = 0.
//
// In       a = r25:r22, b = r21:r18
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
//
// N = 2^m |a| and D = 2^k |b| have their leading ones in bit 31, so that the quotient's magnitude
// N / D 2^(16 + k - m) has 17 + k - m bits before the point, the first of which may be 0. They are
// found one by one, eight to a byte: the remainder, N / 2 at first, is doubled and, if it is D or
// more, becomes smaller by D. More than 32 bits saturate, less than none are less than half a unit.
//
// At last the doubled remainder says which way to round: up from D on, but from D + 1 on where the
// quotient is negative, which is the compare's first borrow.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define d0 r22
#define d1 r23
#define d2 r24
#define d3 r25
// The remainder.
#define n0 r18
#define n1 r19
#define n2 r20
#define n3 r21
#define q0 r26
#define q1 r27
#define q2 r30
#define q3 r31
// Before the quotient: k - m, and a count of negative operands.
#define exponent r30
#define negatives r31
// The bits of the quotient's first byte, and the bytes behind it.
#define bits r0
#define bytes r1

    SECTION fixedpoint_divide_q16_16_small
    // r25:r22 = 2^j |r25:r22| with its leading one in bit 31, exponent += j; Z where it is 0.
.Lnormalise:
    tst r25
    brpl .Lpositive
    inc negatives
    rcall .Lnegate
.Lpositive:
    cp r1, r22
    cpc r1, r23
    cpc r1, r24
    cpc r1, r25
    breq .Lnormalised
1:  tst r25
    brne 2f
    mov_from_top r23, r22, 3
    clr r22
    subi exponent, -8
    rjmp 1b
2:  brmi .Lnormalised
    inc exponent
    lsl_bytes r22, 4
    rjmp 2b
.Lnegate:
    negate_bytes r22, 4
.Lnormalised:
    ret

.Lto_saturate:
    rjmp .Lsaturate

    ENTRY fixedpoint_divide_q16_16_small
    ldi exponent, 0
    ldi negatives, 0
    rcall .Lnormalise
    breq .Lnormalised
    neg exponent
    movw r26, r22
    movw r22, r18
    movw r18, r26
    movw r26, r24
    movw r24, r20
    movw r20, r26
    rcall .Lnormalise
    bst negatives, 0
    breq .Lto_saturate
    subi exponent, -17
    cpi exponent, 33
    brge .Lto_saturate
    mov bits, exponent
    asr exponent
    asr exponent
    asr exponent
    mov bytes, exponent
    ldi q0, 7
    and bits, q0
    clr q0
    clr q1
    movw q2, q0
    tst bytes
    brmi .Lvanishes
    lsr_bytes n0, 4
    inc bits
    rjmp .Lnext
.Lbyte:
    mov q3, q2
    mov q2, q1
    mov q1, q0
    ldi q0, 8
    mov bits, q0
    clr q0
.Lbit:
    lsl q0
    lsl_bytes n0, 4
    brcs .Ltake
    cp_bytes n0, d0, 4
    brcs .Lnext
.Ltake:
    sub_bytes n0, d0, 4
    inc q0
.Lnext:
    dec bits
    brne .Lbit
    dec bytes
    brpl .Lbyte
    clr bytes

    tst q3
    brmi .Lsaturate
    lsl_bytes n0, 4
    brcs .Lup
    bld bits, 0         // it is 0
    lsr bits
    cpc_bytes n0, d0, 4
    brcs .Lsigned
.Lup:
    subi q0, 0xff
    sbci q1, 0xff
    sbci q2, 0xff
    sbci q3, 0xff
.Lvanishes:
    clr r1
.Lsigned:
    movw r22, q0
    movw r24, q2
    brts .Lnegative
    tst r25
    brmi .Lsaturate
    ret
.Lnegative:
    rjmp .Lnegate
.Lsaturate:
    ldi_bytes r22, 0x7fffffff, 4
    brtc .Lreturn
    com_bytes r22, 4
.Lreturn:
    ret
    ENDFUNC fixedpoint_divide_q16_16_small
#endif
