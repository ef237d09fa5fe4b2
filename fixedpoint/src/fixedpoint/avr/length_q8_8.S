// SPDX-License-Identifier: MIT
// int16_t fixedpoint_length2_q8_8(const int16_t* v)
// int16_t fixedpoint_length3_q8_8(const int16_t* v)
// The square root of the sum of 2 or 3 squares, rounded to nearest (there are no ties), saturated:
// the fraction bits cancel, so it is the length in every 16-bit format.
//
// In:       v r25:r24, in RAM
// Out:      r25:r24
// Clobbers: r0, r18..r23, r26, r27, r30, r31
// Stack:    0 bytes.
//
// The sum S has 32 bits. With S 4^k at least 2^30, R = floor(sqrt(S 4^k)) has 16 bits, and the
// result is (R + 2^(k-1)) / 2^k, rounded down; if k is 0, it is out of range. R is computed as in
// P. Zimmermann, Karatsuba square root (1999): the root s of the upper 16 bits, then one 8-bit
// digit q, the remainder divided by 2 s, which is at most 1 too large.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define s0 r18
#define s1 r19
#define s2 r20
#define s3 r21
#define x0 r22
#define x1 r23
#define zero r31
#define count r30
#define root r25
#define q r24
#define k r26
#define double0 r22
#define double1 r23
#define low r22
#define estimate r23

    SECTION fixedpoint_length_q8_8
    ENTRY fixedpoint_length3_q8_8
    ldi count, 3
    rjmp 1f
    ENDFUNC fixedpoint_length3_q8_8

    ENTRY fixedpoint_length2_q8_8
    ldi count, 2
1:  movw r26, r24
    clr zero
    clr s0
    clr s1
    movw s2, s0
.Lcomponent:
    ld x0, X+
    ld x1, X+
    tst x1
    brpl 1f
    com x1
    neg x0
    sbci x1, 0xff
1:  mul_add x0, x0, s0, s1, zero, s2, s3
    mul_add x1, x1, s2, s3
    mul x0, x1
    lsl r0
    rol r1
    add s1, r0
    adc s2, r1
    adc s3, zero
    dec count
    brne .Lcomponent

    cpi s3, 0x40
    brsh .Ltoo_large
    clr k
    tst s3
    brne .Lpairs
.Lbytes:
    mov_from_top s1, s0, 3
    clr s0
    subi k, -4
    tst s3
    brne .Lpairs
    sbrs k, 4
    rjmp .Lbytes
    clr r24
    clr r25
    clr r1
    ret
.Ltoo_large:
    ldi r24, 0xff
    ldi r25, 0x7f
    clr r1
    ret
.Lpair:
    lsl_bytes s0, 4
    lsl_bytes s0, 4
    inc k
.Lpairs:
    cpi s3, 0x40
    brlo .Lpair

    // root = floor(sqrt(s3:s2)), s3:s2 = the remainder, at most 2 root. The table may be 1 less.
    mov r30, s3
    subi r30, 0x40
    ldi r31, hi8(fixedpoint_root_table)
    lpm root, Z
    mul root, root
    sub s2, r0
    sbc s3, r1
    mov double0, root
    clr double1
    sec
    rol double0
    rol double1
    cp s2, double0
    cpc s3, double1
    brlo 1f
    sub s2, double0
    sbc s3, double1
    inc root

    // q = (s3:s2:s1) / (2 root); the remainder is s3:s1, followed by s0.
1:  lsr_bytes s1, 3
    rol s3
    ldi q, 0xff
    cp s2, root
    breq .Lback
    mov r30, root
    ldi r31, hi8(fixedpoint_long_division_table)
    lpm q, Z
    mul q, s2
    add r0, s1
    adc r1, s2
    movw low, r0
    mov q, estimate
    inc q
    mul q, root
    sub s1, r0
    cp low, s1
    brcc 1f
    dec q
    add s1, root
1:  cp s1, root
    brcs 1f
    inc q
    sub s1, root
1:  lsr s3
    rol s1
    rol s3
    mul q, q
    clr zero
    cp s0, r0
    cpc s1, r1
    cpc s3, zero
    brcc .Lback
    dec q

.Lback:
    clr r1
    sbrs k, 3
    rjmp 1f
    lsl q
    mov q, root
    clr root
    andi k, 7
    breq 2f
1:  lsr root
    ror q
    dec k
    brne 1b
2:  adc q, r1
    adc root, r1
    sbrc root, 7
    sbiw r24, 1
    ret
    ENDFUNC fixedpoint_length2_q8_8

#endif
