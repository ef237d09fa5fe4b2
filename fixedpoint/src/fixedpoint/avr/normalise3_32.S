// SPDX-License-Identifier: MIT
// void fixedpoint_normalise3_q<32 - F>_<F>(const int32_t* v, int32_t* unit)
// unit[i] = v[i] 2^F / length of v, in the 32-bit formats with up to 27 fraction bits except
// Q16.16; within 0.56 ulp up to F = 24, and 0.61, 0.71 and 0.91 ulp with 25, 26 and 27. A zero vector
// stays zero. unit may be v.
//
// In       v = r25:r24, unit = r23:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    22 bytes
// Table    1536 bytes, fixedpoint_reciprocal_sqrt_table
//
// The magnitudes are shifted left until the leading one of the largest is bit 30. S, the sum of
// their squares in units of 2^24, has 38 to 40 bits; with less than 39, the magnitudes are doubled.
// y, 23 bits of 2^42 / sqrt(S), is biased by -9, so that e = 1 - S y^2 / 2^84 is never below 0 and
// below 2^-17.5. Only the bytes of S y^2 that contain e are computed. R = 2^9 y (1 + e / 2), at most
// 2^32 - 1, is the reciprocal root, and the upper 32 bits of each magnitude times R are the
// component in units of 2^-31, which are then rounded.
//
// Error, in units of 2^-31:
//     4        parts of the products that are omitted: 0 to 7, of which 3 are added
//     1.5      R: parts of S y^2 that are omitted, 2^-33.7 of it; of y e, -2 to 1; and 3 e^2 / 8
//     0.3      parts of the squares that are omitted: at most 15 2^24 of 2^60
//     0.5      magnitude; its largest is 2^31 - 1
// That is 6.3 in all, and half an ulp, 2^(30 - F), for the rounding.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include <fixedpoint/avr/reciprocal_root.inc>
#include "cubic_32.inc"
#undef zero

#define signs r16
// S, the lowest byte first, and the sum of its products of different bytes.
#define s0 r21
#define s1 r22
#define s2 r23
#define s3 r24
#define s4 r17
#define c0 r18
#define c1 r19
#define c2 r20
#define c3 r26
#define c4 r27
#define nothing r25
#define power r22
// y, its square without the lowest byte, and e in units of 2^-40.
#define y0 r18
#define y1 r19
#define y2 r20
#define q1 r27
#define q2 r30
#define q3 r31
#define q4 r2
#define q5 r3
#define e0 r26
#define e1 r21
#define e2 r27
#define rise0 r22
#define rise1 r30
#define rise2 r31
#define R0 r17
#define R1 r18
#define R2 r19
#define R3 r20

    // r27:r24 = |next component|, at most 2^31 - 1; its sign becomes the low bit of `signs`.
    .macro load_magnitude
    ld_each r24, Z+, 4
    mov r0, r27
    lsl r0
    rol signs
    tst r27
    brpl 1f
    com_bytes r25, 3
    neg r24
    sbci_each r25, 0xff, 3
    brpl 1f
    com_bytes r24, 4
1:
    .endm

    // The four bytes from x0 on times a power of 2; the product must be below 2^32.
    .macro scale x0, x3
    mul \x3, power
    mov \x3, r0
    mul_or_bytes \x0, power, \x0, 3
    .endm

    .macro first_square x3, x2, x1, x0
    mul \x3, \x3
    mov s3, r0
    mov s4, r1
    mul \x2, \x2
    movw s1, r0
    mul \x1, \x1
    mov s0, r1
    mul \x3, \x2
    mov c2, r0
    mov c3, r1
    mul \x3, \x1
    mov c1, r0
    add c2, r1
    adc c3, nothing
    mul \x2, \x1
    mov c0, r0
    add c1, r1
    adc c2, nothing
    adc c3, nothing
    mul_add \x3, \x0, c0, c1, nothing, c2, c3
    mul_add_upper \x2, \x0, c0, nothing, c1, c2, c3
    clr c4
    .endm
    .macro add_square x3, x2, x1, x0
    mul_add \x3, \x3, s3, s4
    mul_add \x2, \x2, s1, s2, nothing, s3, s4
    mul_add_upper \x1, \x1, s0, nothing, s1, s2, s3, s4
    mul_add \x3, \x2, c2, c3, nothing, c4
    mul_add \x3, \x1, c1, c2, nothing, c3, c4
    mul_add \x2, \x1, c0, c1, nothing, c2, c3, c4
    mul_add \x3, \x0, c0, c1, nothing, c2, c3, c4
    mul_add_upper \x2, \x0, c0, nothing, c1, c2, c3, c4
    .endm

    // Not a C function: r7:r4, r11:r8 and r15:r12 = the scaled magnitudes of the vector at r25:r24,
    // the low bits of r16 their signs, the first in bit 2, and r20:r17 = R, any number for a zero
    // vector; r21 = 0. Changes r2, r3 and all call-clobbered registers.
    FUNCTION fixedpoint_normalise3_32
    movw r30, r24
    clr signs
    load_magnitude
    movw r4, r24
    movw r6, r26
    load_magnitude
    movw r8, r24
    movw r10, r26
    load_magnitude
    movw r12, r24
    movw r14, r26
    // By whole bytes, until the leading one is among the upper nine bits.
    ldi r21, 4
1:  mov r23, r7
    or r23, r11
    or r23, r15
    brne 2f
    mov r22, r6
    or r22, r10
    or r22, r14
    brmi 3f
    mov_from_top r5, r4, 3
    clr r4
    mov_from_top r9, r8, 3
    clr r8
    mov_from_top r13, r12, 3
    clr r12
    dec r21
    brne 1b
    ret
3:  ldi power, 128
    rjmp 6f
2:  ldi power, 1
    cpi r23, 8
    brsh 4f
    ldi power, 16
    swap r23
4:  cpi r23, 64
    brsh 6f
5:  lsl power
    lsl r23
    sbrs r23, 6
    rjmp 5b
6:  scale r4, r7
    scale r8, r11
    scale r12, r15
    clr nothing
    first_square r7, r6, r5, r4
    add_square r11, r10, r9, r8
    add_square r15, r14, r13, r12
    lsl c0
    rol c1
    rol c2
    rol c3
    rol c4
    add s0, c0
    adc s1, c1
    adc s2, c2
    adc s3, c3
    adc s4, c4
    cpi s4, 64
    brsh 1f
    .rept 2
    lsl_bytes s0, 4
    rol s4
    .endr
    lsl_bytes r4, 4
    lsl_bytes r8, 4
    lsl_bytes r12, 4
1:  mov r30, s4
    mov r18, s3
    reciprocal_root s2
    subi y0, 9
    sbci y1, 0
    sbci y2, 0
    mul y0, y0
    mov q1, r1
    mul y1, y1
    movw q2, r0
    mul y2, y2
    movw q4, r0
    mov r26, y2
    lsl r26
    mul_add r26, y1, q3, q4, nothing, q5
    mul_add r26, y0, q2, q3, nothing, q4, q5
    mul y0, y1
    .rept 2
    add q1, r0
    adc q2, r1
    adc q3, nothing
    adc q4, nothing
    adc q5, nothing
    .endr
    // Bytes 6 to 8 of S y^2, of byte 5 only the carries, in place of bytes that have been used.
    mul q5, s0
    mov e0, r1
    clr e1
    mul_add_upper q1, s4, e0, nothing, e1
    clr e2
    mul_add_upper q4, s1, e0, nothing, e1
    mul_add_upper q3, s2, e0, nothing, e1
    mul_add_upper q2, s3, e0, nothing, e1
    mul_add q5, s1, e0, e1, nothing, e2
    mul_add q4, s2, e0, e1, nothing, e2
    mul_add q3, s3, e0, e1, nothing, e2
    mul_add q2, s4, e0, e1, nothing, e2
    mul_add q5, s2, e1, e2
    mul_add q4, s3, e1, e2
    mul_add q3, s4, e1, e2
    mul q5, s3
    add e2, r0
    mul q4, s4
    add e2, r0
    com e0
    com e1
    com e2
    .rept 4
    lsl e0
    rol e1
    rol e2
    .endr
    ldi rise0, 0xff
    mul y2, e2
    movw rise1, r0
    mul_add y2, e1, rise0, rise1, nothing, rise2
    mul_add y1, e2, rise0, rise1, nothing, rise2
    mov R0, rise1
    lsl_bytes R1, 3
    add R1, rise2
    adc R2, nothing
    adc R3, nothing
    clr r21
    brcc 1f
    ser R1
    mov R0, R1
    ser R2
    ser R3
1:  ret
    ENDFUNC fixedpoint_normalise3_32

#define zero r21
    // The products of byte 3 add their upper bytes, three of them one more.
    .macro add_upper x, R, more
    mul \x, \R
    .ifnb \more
    inc r1
    .endif
    add r22, r1
    adc_each r23, zero, 3
    .endm
    .macro store_component fraction, x3, x2, x1, x0, sign
    mul \x3, R3
    movw r24, r0
    mul \x2, R2
    movw r22, r0
    mul_add \x3, R1, r22, r23, zero, r24, r25
    mul_add \x1, R3, r22, r23, zero, r24, r25
    mul_add \x3, R2, r23, r24, zero, r25
    mul_add \x2, R3, r23, r24, zero, r25
    add_upper \x3, R0, more
    add_upper \x2, R1, more
    add_upper \x1, R2, more
    add_upper \x0, R3
    clr r26
    shift_and_round (31 - \fraction), 22, 8
    sbrs signs, \sign
    rjmp 1f
    negate_bytes r22, 4
1:  st Y+, r22
    st Y+, r23
    st Y+, r24
    st Y+, r25
    .endm

    .macro kernels integer, fraction
    .if \fraction <= 27
    FUNCTION fixedpoint_normalise3_q\integer\()_\fraction
    push_all r2, r3, r4, r5, r6, r7, r8, r9, r10, r11, r12, r13, r14, r15, r16, r17, r28, r29
    movw r28, r22
    XCALL fixedpoint_normalise3_32
    store_component \fraction, r7, r6, r5, r4, 2
    store_component \fraction, r11, r10, r9, r8, 1
    store_component \fraction, r15, r14, r13, r12, 0
    clr r1
    pop_all r29, r28, r17, r16, r15, r14, r13, r12, r11, r10, r9, r8, r7, r6, r5, r4, r3, r2
    ret
    ENDFUNC fixedpoint_normalise3_q\integer\()_\fraction
    .endif
    .endm

#include "splits_32.inc"

#endif
