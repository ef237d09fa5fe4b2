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
#define signs r23

// r27:r26:r25:r24 = |next component|, at most 2^31 - 1; its sign becomes the low bit of `signs`.
    .macro load_magnitude
    ld_each r24, Z+, 4
    lsl signs
    tst r27
    brpl 1f
    inc signs
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

// The same from x2:x1:x0, for a product below 2^24.
    .macro scale_three_bytes high, middle, low, x2, x1, x0
    mul \x2, r22
    mov \high, r0
    mul_or \x1, r22, \middle, \high
    mul_or \x0, r22, \low, \middle
    .endm

// r22 = the power of two that moves the leading one of \byte, which is below 128, to bit 6.
    .macro find_power byte
    ldi r22, 1
    cpi \byte, 8
    brsh 1f
    ldi r22, 16
    swap \byte
1:  cpi \byte, 32
    brsh 1f
    .rept 2
    lsl r22
    lsl \byte
    .endr
1:  sbrs \byte, 6
    lsl r22
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
    movw r30, r0
    clr r27
    mul_add \high, r19, r31, r24, r27, r25
    mul_add \middle, r20, r31, r24, r27, r25
    mul_add \high, r18, r30, r31, r27, r24, r25
    mul_add \low, r20, r30, r31, r27, r24, r25
    clr r26
    lsl r31             // the product has 31 bits
    rol r24
    rol r25
    lsl r31
    rol_bytes r24, 3
    lsl r31
    adc_each r24, r27, 3
    sbrs signs, \sign
    rjmp 1f
    com r25
    com r26
    neg r24
    sbci r25, 0xff
    sbci r26, 0xff
    sbc r27, r27
1:  st Y+, r24
    st Y+, r25
    st Y+, r26
    st Y+, r27
    .endm

    FUNCTION fixedpoint_normalise3_q16_16
    push_all r5, r6, r7, r9, r10, r11, r12, r13, r14, r28, r29
    movw r30, r24
    movw r28, r22
    clr signs
    load_magnitude
    mov r18, r24
    mov r5, r25
    movw r6, r26
    load_magnitude
    mov r19, r24
    mov r9, r25
    movw r10, r26
    load_magnitude

    // Most vectors have components below 2^23 and one from 2^16 on.
    ldi r21, 4
6:  mov r30, r7
    or r30, r11
    or r30, r27
    brne 2f
    mov r30, r6
    or r30, r10
    or r30, r26
    breq 3f
    brmi 4f
    find_power r30
    scale_three_bytes r7, r6, r5, r6, r5, r18
    scale_three_bytes r11, r10, r9, r10, r9, r19
    scale_three_bytes r14, r13, r12, r26, r25, r24
    rjmp .Lscaled
    // Shifted left by whole bytes, until the top bit would be among the upper nine bits.
3:  mov r6, r5
    mov r5, r18
    clr r18
    mov r10, r9
    mov r9, r19
    clr r19
    mov r26, r25
    mov r25, r24
    clr r24
    dec r21
    brne 6b
    rjmp .Lzero
4:  ldi r22, 128
    rjmp 5f
2:  find_power r30
5:  scale r7, r6, r5, r7, r6, r5, r18
    scale r11, r10, r9, r11, r10, r9, r19
    scale r14, r13, r12, r27, r26, r25, r24
.Lscaled:
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
    pop_all r29, r28, r14, r13, r12, r11, r10, r9, r7, r6, r5
    ret
.Lzero:
    ldi r24, 12
1:  st Y+, r1
    dec r24
    brne 1b
    rjmp .Lrestore
    ENDFUNC fixedpoint_normalise3_q16_16
#endif
