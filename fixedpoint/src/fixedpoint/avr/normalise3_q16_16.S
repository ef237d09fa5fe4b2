// SPDX-License-Identifier: MIT
// void fixedpoint_normalise3_q16_16(const int32_t* v, int32_t* unit);
//
// unit[i] = v[i] 2^16 / length of v, within 0.77 ulp; a zero vector stays zero. unit may be v.
//
// v in r25:r24, unit in r23:r22. Changes r18-r27, r30, r31, r0; r1 is zero at entry and return.
//
// Technique. All magnitudes are shifted left by the same number of bits, so that the largest has
// its top bit in bit 30, and keep their upper three bytes. The sum of their squares, without the
// part below 2^16, is normalised to 2^30 .. 2^32. The three are multiplied by its reciprocal root
// of 23 bits, and the signs are restored. portable/normalise.hpp is the same, bit for bit.
//
// Error, in ulp of a component (2^-16; the components are below 1 and the length is 1):
//     0.5      rounding
//     0.19     parts of the squares that are dropped: at most 3 (2^25 + 2^16) of a sum of 2^44
//     0.08     reciprocal root: less than 5 of 2^22
//     0.07     parts of the product that are dropped: less than 2 * 2^24 of 2^45, and 1 of 2^22
//     0.02     magnitude, truncated to 23 bits; its largest is 2^31 - 1
// That is 0.86 in all; tests/prove_normalise.py proves 0.77.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include <fixedpoint/avr/reciprocal_root.inc>

#define zero r25
#define signs r15

// r27:r26:r25:r24 = |next component|, at most 2^31 - 1; its sign becomes the low bit of `signs`.
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

// high:middle:low = x3:x2:x1:x0 r22 / 256, for r22 a power of two and a product below 2^32.
    .macro scale high, middle, low, x3, x2, x1, x0
    mul \x3, r22
    mov \high, r0
    mul_or \x2, r22, \middle, \high
    mul_or \x1, r22, \low, \middle
    mul \x0, r22
    or \low, r1
    .endm

// r21:r20:r19:r18 += (high:middle)^2 + 2 high low. high must be below 128.
    .macro add_square high, middle, low
    mul_add \high, \high, r20, r21
    mul_add \middle, \middle, r18, r19, zero, r20, r21
    mov r22, \high
    lsl r22
    mul_add r22, \middle, r19, r20, zero, r21
    mul_add r22, \low, r18, r19, zero, r20, r21
    .endm

// Stores the nearest integer to high:middle:low r20:r19:r18 / 2^30 with the sign in bit `sign`. The
// partial products middle r18, low r19 and low r18 are omitted, and the byte below 2^24 does not
// matter.
    .macro store_component high, middle, low, sign
    mul \high, r20
    movw r24, r0
    mul \middle, r19
    movw r22, r0
    clr r27
    mul_add \high, r19, r23, r24, r27, r25
    mul_add \middle, r20, r23, r24, r27, r25
    mul_add \high, r18, r22, r23, r27, r24, r25
    mul_add \low, r20, r22, r23, r27, r24, r25
    clr r26
    lsl_bytes r23, 4
    lsl_bytes r23, 4
    lsl r23
    adc_each r24, r27, 3
    sbrs signs, \sign
    rjmp 1f
    com_bytes r25, 3
    neg r24
    sbci_each r25, 0xff, 3
1:  st Y+, r24
    st Y+, r25
    st Y+, r26
    st Y+, r27
    .endm

    FUNCTION fixedpoint_normalise3_q16_16
    push_all r4, r5, r6, r7, r8, r9, r10, r11, r12, r13, r14, r15, r28, r29
    movw r30, r24
    movw r28, r22
    clr signs
    load_magnitude
    movw r4, r24
    movw r6, r26
    load_magnitude
    movw r8, r24
    movw r10, r26
    load_magnitude

    // Shifted left by whole bytes, until the top bit would be among the upper nine bits.
    ldi r21, 4
1:  mov r23, r7
    or r23, r11
    or r23, r27
    brne 2f
    mov r22, r6
    or r22, r10
    or r22, r26
    brmi 3f
    mov_from_top r5, r4, 3
    clr r4
    mov_from_top r9, r8, 3
    clr r8
    mov_from_top r25, r24, 3
    clr r24
    dec r21
    brne 1b
    rjmp .Lzero
    // r22 = the power of two that moves the top bit to bit 30
3:  ldi r22, 128
    rjmp 6f
2:  ldi r22, 1
    cpi r23, 8
    brsh 4f
    ldi r22, 16
    swap r23
4:  cpi r23, 64
    brsh 6f
5:  lsl r22
    lsl r23
    sbrs r23, 6
    rjmp 5b
6:  scale r7, r6, r5, r7, r6, r5, r4
    scale r11, r10, r9, r11, r10, r9, r8
    scale r14, r13, r12, r27, r26, r25, r24
    clr zero
    clr r18
    clr r19
    movw r20, r18
    add_square r7, r6, r5
    add_square r11, r10, r9
    add_square r14, r13, r12
    // Below 2^30 the sum is multiplied by four, and its reciprocal root then by two.
    set
    cpi r21, 64
    brsh 1f
    clt
    .rept 2
    lsl_bytes r18, 4
    .endr
1:  mov r30, r21
    mov r18, r20
    mov r21, r19
    reciprocal_root r21
.Lreciprocal_root:
    brts 1f
    lsl_bytes r18, 3
1:  store_component r7, r6, r5, 2
    store_component r11, r10, r9, 1
    store_component r14, r13, r12, 0
    clr r1
.Lrestore:
    pop_all r29, r28, r15, r14, r13, r12, r11, r10, r9, r8, r7, r6, r5, r4
    ret
.Lzero:
    ldi r24, 12
1:  st Y+, r1
    dec r24
    brne 1b
    rjmp .Lrestore
    ENDFUNC fixedpoint_normalise3_q16_16
#endif
