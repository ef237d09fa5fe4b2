// SPDX-License-Identifier: MIT
// The root that the lengths share. Not a C function: its arguments are in the registers of their
// sums.
//
// r25:r24:r23:r22 = r, the integer nearest to sqrt(N), N = r23:r22:r21:r20:r19:r18 < 3 * 2^46.
// Changes r18-r21, r26, r27, r30, r31, r0 as well; r1 is zero at return.
//
// Technique. As in sqrt_q16_16.S: N is shifted left by 2 k bits, and a 16-bit root from tables gets
// eight more bits by the slope of the table. Here the fourth byte is dropped, so the 24-bit root is
// less than 6 above and less than 5.1 below sqrt(N 4^k). Minus 6, it is R, less than 12 below it.
// R / 2^k, rounded, is not above r, and it is r unless its fraction and 12 / 2^k carry. If they do,
// or if k <= 3, N - r (r + 1) - 1 says how often it is incremented: once or twice, but up to 12
// times if k is 0.
//
// From 2^32 to 2^40 N takes the shortest way. Other numbers have bit 0 set in `back`, and T if they
// are larger.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define n0 r18
#define n1 r19
#define n2 r20
#define n3 r21
#define n4 r22
#define n5 r23
// N 4^k, its upper three bytes, and what moves it there.
#define m3 r30
#define m2 r26
#define m1 r25
#define m0 r24
#define power r22
#define power_of_five r24
// 2^(8 - k mod 8) modulo 2^8.
#define back r27
#define s0 r31
#define s1 r22
#define s2 r23
#define slope r24
// The result, and the byte below it.
#define c0 r22
#define c1 r23
#define c2 r24
#define fraction r31

    // c2:c1:c0:fraction = R back
    .macro shift_back
    mul s2, back
    mov c2, r1
    mov c1, r0
    mul_or s1, back, c0, c1
    mul_or s0, back, fraction, c0
    .endm
    // c2:c1:c0 is rounded; the fraction counts from -1/2 then.
    .macro round
    subi fraction, 128
    sbci c0, 0xff
    sbci c1, 0xff
    sbci c2, 0xff
    .endm

    SECTION fixedpoint_length_root
.Lthree_bytes:
    clr m0
    mov m1, n0
    mov m2, n1
    mov m3, n2
    tst m3
    brne .Lodd
    mov m3, m2
    mov m2, m1
    clr m1
    tst m3
    brne .Leven
    mov m3, m2
    clr m2
    tst m3
    brne .Lodd
    clr c0
    clr c1
    rjmp .Ldone         // c2 is m0
.Lodd:
    ldi power, 64
    ldi back, 3
    cpi m3, 4
    brlo .Lscale
    ldi power, 16
    ldi back, 5
    cpi m3, 16
    brlo .Lscale
    ldi power, 4
    ldi back, 9
    cpi m3, 64
    brlo .Lscale
    ldi power, 1
    ldi back, 17
    rjmp .Lscale
.Lfour_bytes:
    clt
    tst n3
    breq .Lthree_bytes
    mov m3, n3
    mov m2, n2
    movw m0, n0
.Leven:
    ldi power, 64
    ldi back, 33
    cpi m3, 4
    brlo .Lscale
    ldi power, 16
    ldi back, 65
    cpi m3, 16
    brlo .Lscale
    ldi power, 4
    ldi back, 129
    cpi m3, 64
    brlo .Lscale
    ldi power, 1
    ldi back, 1
.Lscale:
    mul m3, power
    mov m3, r0
    mul_or m2, power, m2, m3
    mul_or m1, power, m1, m2
    mul m0, power
    or m1, r1
    rjmp .Ltable
.Lsix_bytes:
    set
    mov m3, n5
    mov m2, n4
    movw m0, n2
    rjmp .Leven
.Lunscaled:
    mov m3, n4
    mov m2, n3
    mov m1, n2
    rjmp .Ltable

    ENTRY fixedpoint_length_root
    tst n5
    brne .Lsix_bytes
    tst n4
    breq .Lfour_bytes
    ldi back, 16
    cpi n4, 64
    brsh .Lunscaled
    ldi power_of_five, 4
    ldi back, 8
    cpi n4, 16
    brsh 1f
    ldi power_of_five, 16
    ldi back, 4
    cpi n4, 4
    brsh 1f
    ldi power_of_five, 64
    ldi back, 2
1:  mul n4, power_of_five
    mov m3, r0
    mul_or n3, power_of_five, m2, m3
    mul_or n2, power_of_five, m1, m2
    mul n1, power_of_five
    or m1, r1
.Ltable:
    ldi r31, hi8(fixedpoint_sqrt_table)
    lpm_pages s1, s2, slope
    mul slope, m2
    add s1, r1
    brcc 1f
    inc s2
1:  mul s1, s1
    sub m1, r1
    sbci m2, 0
    mul s2, s2
    sub m2, r0
    mul s1, s2
    lsl r0
    rol r1
    sub m1, r0
    sbc m2, r1
    mul m1, slope
    mov s0, r1
    mul m2, slope
    add s0, r0
    adc s1, r1
    brcc 1f
    inc s2
1:  subi s0, 6
    sbci s1, 0
    sbci s2, 0
.Lback:
    sbrc back, 0
    rjmp .Lother
    shift_back
    round
    ldi r30, 12
    mul back, r30
    add fraction, r0
    brcs .Lnear
.Ldone:
    clr r25
    clr r1
    ret

.Lother:
    andi back, 0xfe
    breq 1f
    shift_back
    rjmp 2f
1:  mov c2, s2
    mov c1, s1
    mov c0, s0
    clr fraction
2:  brts 4f
    mov fraction, c0
    mov c0, c1
    mov c1, c2
    clr c2
    mov r0, n2
    or r0, n3
    brne 3f
    mov fraction, c0
    mov c0, c1
    clr c1
3:  round
    cpi fraction, 256 - 12
    brlo .Ldone
    rjmp .Lnear
4:  round

    // N - r (r + 1) - 1 modulo 2^32
.Lnear:
    sec
    sbc n0, c0
    sbc n1, c1
    sbc n2, c2
    sbci n3, 0
    mul c0, c0
    sub n0, r0
    sbc n1, r1
    sbci n2, 0
    sbci n3, 0
    mul c0, c1
    sub n1, r0
    sbc n2, r1
    sbci n3, 0
    sub n1, r0
    sbc n2, r1
    sbci n3, 0
    mul c0, c2
    sub n2, r0
    sbc n3, r1
    sub n2, r0
    sbc n3, r1
    mul c1, c2
    sub n3, r0
    sub n3, r0
    mul c1, c1
    sub n2, r0
    sbc n3, r1
    brmi 2f
1:  increment_bytes c0, 3
    sub n0, c0
    sbc n1, c1
    sbc n2, c2
    sbci n3, 0
    sub n0, c0
    sbc n1, c1
    sbc n2, c2
    sbci n3, 0
    brpl 1b
2:  rjmp .Ldone
    ENDFUNC fixedpoint_length_root
#endif
