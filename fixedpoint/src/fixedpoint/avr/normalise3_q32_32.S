// SPDX-License-Identifier: MIT
// void fixedpoint_normalise3_q32_32(const int64_t* v, int64_t* unit)
// unit[i] = v[i] 2^32 / length of v, within 0.6 ulp; a zero vector stays zero. unit may be v.
//
// In       v = r25:r24, unit = r23:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    27 bytes
// Table    1536 bytes, fixedpoint_reciprocal_sqrt_table
//
// The magnitudes are shifted left until the leading one of the largest is bit 62 (for -2^n, bit 63),
// and keep their upper five bytes. S, the sum of their squares in units of 2^32, has 46 to 48 bits;
// with less than 47, the magnitudes are doubled. y, 23 bits of 2^46 / sqrt(S), is biased by -9, so
// that e = 1 - S y^2 / 2^92 is never below 0 and below 2^-17.5. Only the bytes of S y^2 that
// contain e are computed. R = 2^17 y (1 + e / 2 + 3 e^2 / 8), at most 2^40 - 1, is the reciprocal root, and
// the upper 40 bits of each magnitude times R are the component in units of 2^-39, which are then
// rounded.
//
// Error, in units of 2^-39, of which an ulp has 128:
//     5        parts of the products that are omitted: 0 to 9, of which 4 are added
//     5        R: parts of S y^2 that are omitted, 2^-37 of it, and of y e and e^2
//     0.1      parts of the squares that are omitted
//     2        magnitudes, truncated to 39 bits
// and half an ulp for the rounding.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include <fixedpoint/avr/reciprocal_root.inc>

#define signs r17
#define zero r25
#define bytes r28
#define power r29
// S, the lowest byte first, and the sum of its products of different bytes.
#define s0 r21
#define s1 r22
#define s2 r23
#define s3 r24
#define s4 r28
#define s5 r29
#define c0 r18
#define c1 r19
#define c2 r20
#define c3 r26
#define c4 r27
#define c5 r30
// y, its square without the lowest byte, and e in units of 2^-49.
#define y0 r18
#define y1 r19
#define y2 r20
#define q1 r16
#define q2 r12
#define q3 r13
#define q4 r14
#define q5 r15
#define e0 r26
#define e1 r27
#define e2 r30
#define e3 r31
#define rise0 r21
#define rise1 r22
#define rise2 r23
#define rise3 r24
#define R0 r22
#define R1 r23
#define R2 r18
#define R3 r19
#define R4 r20
// A component in units of 2^-39, and a byte above.
#define p0 r26
#define p1 r27
#define p2 r30
#define p3 r31
#define p4 r24
#define p5 r21

    // r9:r2 |= the next component, with all bits inverted if it is negative. Its sign becomes the low
    // bit of `signs`.
    .macro or_component
    ld_each r18, Z+, 8
    mov r26, r25
    lsl r26
    sbc r26, r26
    rol signs
    .irp n, 0, 1, 2, 3, 4, 5, 6, 7
    eor 18 + \n, r26
    or 2 + \n, 18 + \n
    .endr
    .endm

    // The five bytes of each component take the place of those of the one before.
    .macro advance
    .irp n, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9
    mov 2 + \n, 7 + \n
    .endr
    .endm

    // x4:...:x0 = the upper five bytes of |next component|, shifted left.
    .macro load_magnitude x4, x3, x2, x1, x0
    ld_each r18, Z+, 8
    tst r25
    brpl 1f
    negate_bytes r18, 8
1:  mov r26, bytes
    rjmp 3f
2:  mov_from_top r19, r18, 7
    clr r18
3:  dec r26
    brpl 2b
    mul r25, power
    mov \x4, r0
    mul_or r24, power, \x3, \x4
    mul_or r23, power, \x2, \x3
    mul_or r22, power, \x1, \x2
    mul_or r21, power, \x0, \x1
    mul r20, power
    or \x0, r1
    .endm

    .macro add_square x4, x3, x2, x1, x0
    mul_add \x4, \x4, s4, s5
    mul_add \x3, \x3, s2, s3, zero, s4, s5
    mul_add \x2, \x2, s0, s1, zero, s2, s3, s4, s5
    mul_add \x4, \x3, c3, c4, zero, c5
    mul_add \x4, \x2, c2, c3, zero, c4, c5
    mul_add \x4, \x1, c1, c2, zero, c3, c4, c5
    mul_add \x3, \x2, c1, c2, zero, c3, c4, c5
    mul_add \x4, \x0, c0, c1, zero, c2, c3, c4, c5
    mul_add \x3, \x1, c0, c1, zero, c2, c3, c4, c5
    mul_add_upper \x3, \x0, c0, zero, c1, c2, c3, c4, c5
    mul_add_upper \x2, \x1, c0, zero, c1, c2, c3, c4, c5
    .endm

    // The products of byte 4 add their upper bytes, four of them one more.
    .macro add_upper x, R, more
    mul \x, \R
    .ifnb \more
    inc r1
    .endif
    add p0, r1
    .irp byte, p1, p2, p3, p4
    adc \byte, zero
    .endr
    .endm
    .macro store_component x4, x3, x2, x1, x0
    mul \x4, R4
    mov p3, r0
    mov p4, r1
    mul \x3, R3
    mov p1, r0
    mov p2, r1
    mul_add \x4, R3, p2, p3, zero, p4
    mul_add \x3, R4, p2, p3, zero, p4
    mul_add \x4, R2, p1, p2, zero, p3, p4
    mul_add \x2, R4, p1, p2, zero, p3, p4
    clr p0
    mul_add \x4, R1, p0, p1, zero, p2, p3, p4
    mul_add \x3, R2, p0, p1, zero, p2, p3, p4
    mul_add \x2, R3, p0, p1, zero, p2, p3, p4
    mul_add \x1, R4, p0, p1, zero, p2, p3, p4
    add_upper \x4, R0, more
    add_upper \x3, R1, more
    add_upper \x2, R2, more
    add_upper \x1, R3, more
    add_upper \x0, R4
    clr p5
    lsl p0
    .irp byte, p1, p2, p3, p4, p5
    rol \byte
    .endr
    lsl p0
    .irp byte, p1, p2, p3, p4, p5
    adc \byte, zero
    .endr
    clr p0
    sbrs signs, 7
    rjmp 1f
    .irp byte, p1, p2, p3, p4, p5, p0
    com \byte
    .endr
    .irp byte, p1, p2, p3, p4, p5, p0
    adc \byte, zero
    .endr
1:  .irp byte, p1, p2, p3, p4, p5, p0, p0, p0
    st Y+, \byte
    .endr
    .endm

    FUNCTION fixedpoint_normalise3_q32_32
    push_all r2, r3, r4, r5, r6, r7, r8, r9, r10, r11, r12, r13, r14, r15, r16, r17, r28, r29, r22, r23
    movw r30, r24
    clr signs
    clr_bytes r2, 8
    inc r2              // a zero vector has a leading one, too
    ldi r27, 3
1:  or_component
    dec r27
    brne 1b
    // The sign of the first component on top, and a bit behind that of the last
    swap signs
    lsl signs
    ori signs, 0x10
    // By whole bytes, until the leading one is among the upper nine bits.
    ldi bytes, 0
1:  tst r9
    brne 2f
    ldi power, 128
    sbrc r8, 7
    rjmp 6f
    mov_from_top r3, r2, 7
    clr r2
    inc bytes
    rjmp 1b
2:  mov r23, r9
    ldi power, 1
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
6:  sbiw r30, 24
    ldi r27, 3
7:  advance
    load_magnitude r16, r15, r14, r13, r12
    dec r27
    breq 8f
    rjmp 7b
8:  clr zero
    .irp byte, s0, s1, s2, s3, s4, s5, c0, c1, c2, c3, c4, c5
    clr \byte
    .endr
    add_square r6, r5, r4, r3, r2
    add_square r11, r10, r9, r8, r7
    add_square r16, r15, r14, r13, r12
    lsl c0
    .irp byte, c1, c2, c3, c4, c5
    rol \byte
    .endr
    add s0, c0
    adc s1, c1
    adc s2, c2
    adc s3, c3
    adc s4, c4
    adc s5, c5
    cpi s5, 64
    brsh 1f
    .rept 2
    lsl_bytes s0, 4
    rol s4
    rol s5
    .endr
    lsl_bytes r2, 5
    lsl_bytes r7, 5
    lsl_bytes r12, 5
1:  mov r30, s5
    mov r18, s4
    reciprocal_root s3
    push_all r12, r13, r14, r15, r16
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
    mul_add r26, y1, q3, q4, zero, q5
    mul_add r26, y0, q2, q3, zero, q4, q5
    mul y0, y1
    .rept 2
    add q1, r0
    adc q2, r1
    adc q3, zero
    adc q4, zero
    adc q5, zero
    .endr
    // Bytes 6 to 9 of S y^2, of byte 5 only the carries.
    mul q5, s0
    mov e0, r1
    clr e1
    clr e2
    clr e3
    mul_add_upper q4, s1, e0, zero, e1
    mul_add_upper q3, s2, e0, zero, e1
    mul_add_upper q2, s3, e0, zero, e1
    mul_add_upper q1, s4, e0, zero, e1
    mul_add q5, s1, e0, e1, zero, e2
    mul_add q4, s2, e0, e1, zero, e2
    mul_add q3, s3, e0, e1, zero, e2
    mul_add q2, s4, e0, e1, zero, e2
    mul_add q1, s5, e0, e1, zero, e2
    mul_add q5, s2, e1, e2, zero, e3
    mul_add q4, s3, e1, e2, zero, e3
    mul_add q3, s4, e1, e2, zero, e3
    mul_add q2, s5, e1, e2, zero, e3
    mul_add q5, s3, e2, e3
    mul_add q4, s4, e2, e3
    mul_add q3, s5, e2, e3
    mul q5, s4
    add e3, r0
    mul q4, s5
    add e3, r0
    com_bytes e0, 2
    com_bytes e2, 2
    .rept 5
    lsl e0
    rol e1
    rol e2
    rol e3
    .endr
    // e + 3 e^2 / 4
    mul e3, e3
    .rept 2
    lsr r1
    ror r0
    .endr
    .rept 2
    add e0, r0
    adc e1, r1
    adc e2, zero
    adc e3, zero
    lsr r1
    ror r0
    .endr
    mul y2, e3
    mov rise2, r0
    mov rise3, r1
    mul y2, e2
    mov rise1, r0
    add rise2, r1
    adc rise3, zero
    mul y2, e1
    mov rise0, r0
    add rise1, r1
    adc rise2, zero
    adc rise3, zero
    mul_add y1, e3, rise1, rise2, zero, rise3
    mul_add y1, e2, rise0, rise1, zero, rise2, rise3
    mul_add y0, e3, rise0, rise1, zero, rise2, rise3
    lsr_bytes rise1, 3
    lsl_bytes R2, 3
    add R2, rise3
    adc R3, zero
    adc R4, zero
    brcc 1f
    .irp byte, R0, R1, R2, R3, R4
    ser \byte
    .endr
1:  pop_all r16, r15, r14, r13, r12, r29, r28
7:  store_component r6, r5, r4, r3, r2
    advance
    lsl signs
    cpi signs, 0x80
    breq 8f
    rjmp 7b
8:  clr r1
    pop_all r29, r28, r17, r16, r15, r14, r13, r12, r11, r10, r9, r8, r7, r6, r5, r4, r3, r2
    ret
    ENDFUNC fixedpoint_normalise3_q32_32
#endif
