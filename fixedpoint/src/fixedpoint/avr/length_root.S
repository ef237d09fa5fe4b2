// SPDX-License-Identifier: MIT
// The root that the lengths share. Not a C function: its arguments are in the registers of their
// sums.
//
// r25:r24:r23:r22 = r, the integer nearest to sqrt(N), N = r23:r22:r21:r20:r19:r18 < 3 * 2^46.
// Changes r18-r21, r26, r27, r30, r31, r0 as well; r1 is zero at return.
//
// Technique. As in sqrt_q16_16.S: N is shifted left by 2 k bits, and a 16-bit root from tables gets
// eight more bits by the slope of the table. Here the fourth byte is dropped, so the 24-bit root is
// less than 6 above and less than 5.1 below sqrt(N 4^k). Minus 6 and shifted back by k, it is not
// above sqrt(N), and N - r (r + 1) - 1 says how often it is incremented: once or twice, but up to
// 12 times if k is 0.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define n0 r18
#define n1 r19
#define n2 r20
#define n3 r21
#define k r22
#define s0 r31
#define s1 r23
#define s2 r27
#define slope r24
#define m1 r25
#define m2 r26

    FUNCTION fixedpoint_length_root
    // k: 4 for each leading zero byte.
    movw r26, r22
    movw r24, n2
    movw r30, n0
    clr k
1:  tst r27
    brne 2f
    mov_from_top r25, r24, 3
    mov r24, r31
    mov r31, r30
    clr r30
    subi k, -4
    cpi k, 24
    brne 1b
    rjmp .Lzero
2:  ldi r23, 1
    cpi r27, 64
    brsh 3f
    inc k
    ldi r23, 4
    cpi r27, 16
    brsh 3f
    inc k
    ldi r23, 16
    cpi r27, 4
    brsh 3f
    inc k
    ldi r23, 64
3:  mul r27, r23
    mov r30, r0
    mul_or r26, r23, m2, r30
    mul_or r25, r23, m1, m2
    mul r24, r23
    or m1, r1
    ldi r31, hi8(fixedpoint_sqrt_table)
    lpm_pages s1, s2, slope
    mul slope, m2
    add s1, r1
    brcc 4f
    inc s2
4:  mul s1, s1
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
    brcc 5f
    inc s2
5:  subi s0, 6
    sbci s1, 0
    sbci s2, 0
6:  cpi k, 8
    brlo 7f
    mov s0, s1
    mov s1, s2
    clr s2
    subi k, 8
    rjmp 6b
    // Four bits by a product.
7:  cpi k, 4
    brlo 10f
    ldi r30, 16
    mul s0, r30
    mov s0, r1
    mul s1, r30
    or s0, r0
    mov s1, r1
    mul s2, r30
    or s1, r0
    mov s2, r1
    subi k, 4
    rjmp 10f
9:  lsr s2
    ror s1
    ror s0
10: dec k
    brpl 9b
    // N - r (r + 1) - 1 modulo 2^32
    sec
    sbc n0, s0
    sbc n1, s1
    sbc n2, s2
    sbci n3, 0
    mul s0, s0
    sub n0, r0
    sbc n1, r1
    sbci n2, 0
    sbci n3, 0
    mul s0, s1
    sub n1, r0
    sbc n2, r1
    sbci n3, 0
    sub n1, r0
    sbc n2, r1
    sbci n3, 0
    mul s0, s2
    sub n2, r0
    sbc n3, r1
    sub n2, r0
    sbc n3, r1
    mul s1, s2
    sub n3, r0
    sub n3, r0
    mul s1, s1
    sub n2, r0
    sbc n3, r1
    brmi 12f
11: subi s0, 0xff
    sbci s1, 0xff
    sbci s2, 0xff
    sub n0, s0
    sbc n1, s1
    sbc n2, s2
    sbci n3, 0
    sub n0, s0
    sbc n1, s1
    sbc n2, s2
    sbci n3, 0
    brpl 11b
12: mov r22, s0
    mov r24, s2
    clr r25
    clr r1
    ret
.Lzero:
    clr_bytes r22, 4
    ret
    ENDFUNC fixedpoint_length_root
#endif
