// SPDX-License-Identifier: MIT
// int32_t fixedpoint_divide_q16_16_small(int32_t a, int32_t b)
//
// The result of fixedpoint_divide_q16_16, without a table: floor(a 2^16 / b + 1/2), saturated. If
// b = 0: the largest number if a > 0, the smallest if a < 0, 0 if a = 0.
//
// In       a = r25:r22, b = r21:r18
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
//
// D = 2^(8 n + k) |b| has its leading one in bit 31, k < 8. The magnitude of the quotient is
// 2^k |a| / D 2^(16 + 8 n): one base-256 digit, then 2 + n more. Leading zeros are skipped; more
// than four remaining digits saturate. b = 0 is taken as 2^-17: every a but 0 then saturates.
//
// A digit is estimated from the upper byte of the dividend X and a reciprocal of D; digit D is
// subtracted. The estimate is off by -3 to 3 units: D is subtracted until X is negative, then added
// until it no longer is. The digit is thus exact whatever the estimate.
//
// Finally the remainder R decides the rounding: up if R >= D - R, but for a negative quotient only
// if R > D - R, which is the first borrow of the comparison.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define d0 r22
#define d3 r25
#define q0 r18
#define q1 r19
#define q2 r20
#define q3 r21
#define x0 r26
#define x1 r27
#define x2 r28
#define x3 r29
#define x4 r30
// The number of digits that follow.
#define behind r31
// 2^40 / D - 256.
#define reciprocal r17

// The coefficients with the fewest corrections among those whose estimates are at most 256.
#define C0 145
#define C2 223

    FUNCTION fixedpoint_divide_q16_16_small
    push_all r17, r28, r29
    mov r0, r25
    eor r0, r21
    bst r0, 7
    sbrc r25, 7
    rcall .Lnegate
    movw_bytes x0, r22, 4
    clr x4
    movw_bytes d0, r18, 4
    sbrc d3, 7
    rcall .Lnegate
    ldi behind, 2
.Lbyte:
    tst d3
    brne .Lnormal
    mov_from_top r23, d0, 3
    clr d0
    inc behind
    sbrc behind, 3
    ldi d3, 0x80        // b = 0
    rjmp .Lbyte
.Lbit:
    lsl_bytes x0, 5
    lsl_bytes d0, 4
.Lnormal:
    brpl .Lbit

    // w (C0 + C2 w^2 / 2), w = 2 - D / 2^31
    mov reciprocal, d3
    com reciprocal
    fmul reciprocal, reciprocal
    ldi q0, C2
    mul r1, q0
    ldi q0, C0
    add q0, r1
    fmul reciprocal, q0
    mov reciprocal, r1

    clr q0
    clr q1
    movw q2, q0
    rjmp .Lfirst
.Ldigit:
    mov_from_top q1, q0, 3
    mov q0, x4
    mul x4, reciprocal
    sec
    adc q0, r1
    sbci q0, 0          // 256 becomes 255
.Lmultiple:
    mul q0, d0
    sub x0, r0
    sbc x1, r1
    sbci x2, 0
    sbci x3, 0
    sbci x4, 0
    mul q0, r23
    sub x1, r0
    sbc x2, r1
    sbci x3, 0
    sbci x4, 0
    mul q0, r24
    sub x2, r0
    sbc x3, r1
    sbci x4, 0
    mul q0, d3
    sub x3, r0
    sbc x4, r1
    brmi .Ladd
.Lsubtract:
    inc q0
    sub_bytes x0, d0, 4
    sbci x4, 0
    brcc .Lsubtract
.Ladd:
    dec q0
    add_bytes x0, d0, 4
    brcc .Ladd
    subi x4, 0xff       // clears the carry if x4 becomes 0
    brne .Ladd
.Lnext:                 // with the carry set while digits are skipped
    mov_from_top x1, x0, 4
    clr x0
    dec behind
    brmi .Lround
    brcc .Ldigit
.Lfirst:
    cp x3, d3
    cpc x4, q0
    brcs .Lnext
    cpi behind, 4
    brlo .Ldigit
    rjmp .Lsaturate

.Lround:
    sub_bytes d0, x1, 4
    brtc 1f
    sec
1:  cpc_bytes x1, d0, 4
    sbci_each q0, 0xff, 4
    brcc .Lsaturate     // rounded up to 2^32, which is 0 here
    brpl .Lsigned
.Lsaturate:
    clr q0
    brts 1f
    com q0
1:  mov q1, q0
    movw q2, q0
    subi q3, 0x80
.Lsigned:
    movw_bytes r22, q0, 4
    pop_all r29, r28, r17
    clr r1
    brtc .Lreturn
.Lnegate:
    negate_bytes r22, 4
.Lreturn:
    ret
    ENDFUNC fixedpoint_divide_q16_16_small
#endif
