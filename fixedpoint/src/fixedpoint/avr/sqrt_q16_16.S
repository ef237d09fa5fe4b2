// SPDX-License-Identifier: MIT
// int32_t fixedpoint_sqrt_q16_16(int32_t a);
//
// The integer r nearest to sqrt(a 2^16), which is never half-way between two; 0 if a < 0.
//
// a and r in r25:r24:r23:r22. Changes r18-r27, r30, r31, r0; r1 is zero at entry and return.
//
// Technique. a is shifted left by an even number of bits 2 k, so that its top byte h is at least
// 64; the root of that is shifted back by k. With l the byte below h, the tables give
//     c = root[h] + floor(slope[h] l / 256),
// at most 2 below the integer part of the root of h:l, in 16 bits; tables/sqrt.py asserts that for
// every h:l. If more bytes follow, the exact e = m - c^2, where m is the upper 32 bits of the
// shifted number, gives eight more bits: the slope of the root at c is 2^15 / c, which is slope[h]
// / 256 to within its rounding, so S = 256 c + e slope[h] / 2^16 is the root in 24 bits.
// tables/sqrt.py asserts that it is less than 5 off at either end of the numbers that share c; the
// floors and the dropped low byte of e add less than 1 to the upper bound and are part of the 5
// below.
//
// Rounding. Let r' be the shifted root without its k fraction bits f. r is r' or r' + 1, and it is
// r' + 1 if N = a 2^16 exceeds (r' + 1/2)^2, which for integers is N > r'^2 + r'. The difference of
// the two sides fits in the bytes it is computed in, since r' is less than 2 off, so the upper
// bytes do not need products. If f is further from 1/2 than the error of the root, r is known
// without that.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define c0 r22
#define c1 r23
#define c2 r24
#define zero r25

// high:low = root[r30] + slope[r30] next / 256.
    .macro root16 low, high, slope, next
    ldi r31, hi8(fixedpoint_sqrt_table)
    lpm_pages \low, \high, \slope
    mul_add_upper \slope, \next, \low, zero, \high
    .endm

// r26:r19:r18 = c^2 + c - a 2^16 modulo 2^24, from r26 = 2 c0 c2 - a0 with a0 the low byte of a.
// Negative if c must be rounded up.
    .macro test_half
    mul c0, c0
    movw r18, r0
    add r18, c0
    adc r19, c1
    adc r26, c2
    mul c1, c1
    add r26, r0
    mul_add c1, c0, r19, r26
    add r19, r0
    adc r26, r1
    .endm

    FUNCTION fixedpoint_sqrt_q16_16
    sbiw r24, 0
    brne .Labove_one
    cpi r23, 64
    brlo .Lbelow_quarter

    // 2^14 .. 2^16: k = 0. c is up to 2 below r.
    mov r30, r23
    mov r26, r22
    root16 c0, c1, r18, r26
    neg r26
    test_half
    brmi 1f
2:  clr r1
    ret
    // r is c + 2 if the difference is below -2 c - 2 <= -2^16 - 2: never if its top byte is 0xff.
1:  subi c0, 0xff
    sbci c1, 0xff
    cpi r26, 0xff
    breq 2b
    rjmp .Lremainder_of_two

.Lbelow_quarter:
    cpi r23, 16
    brsh 1f
    rjmp .Lbelow_sixteenth
    // 2^12 .. 2^14: k = 1. An odd c rounds up, whether it is 1 too small or not.
1:  movw r18, r22
    lsl r18
    rol r19
    lsl r18
    rol r19
    mov r30, r19
    mov r26, r22
    root16 c0, c1, r19, r18
    lsr c1
    ror c0
    brcs 1f
    rjmp .Lnear_half
1:  adc c0, zero
    adc c1, zero
    clr r1
    ret

.Labove_one:
    tst r25
    breq 2f
    brmi 1f
    rjmp .Labove_256
1:  mov r22, r1
    mov r23, r1
    movw r24, r22
    ret
2:
    // 2^16 .. 2^24: r20 = 2^(2 k - 8) normalises a, whose top byte is r24; r27 = 2^(8 - k) shifts
    // back, and leaves f in a byte. From r18 to 256 - r18, f is too close to 1/2.
    ldi r20, 64
    ldi r27, 2
    ldi r18, 0x80 - 6 * 2
    cpi r24, 4
    brlo 1f
    ldi r20, 16
    ldi r27, 4
    ldi r18, 0x80 - 6 * 4
    cpi r24, 16
    brlo 1f
    ldi r20, 4
    ldi r27, 8
    ldi r18, 0x80 - 6 * 8
    cpi r24, 64
    brlo 1f
    ldi r20, 1
    ldi r27, 16
    ldi r18, 0x80 - 6 * 16
1:  mul r24, r20
    mov r30, r0
    mul_or r23, r20, r26, r30
    mul_or r22, r20, r19, r26
    root16 r20, r21, r24, r26
    // e / 256 in r26:r19, S in r21:r20:r19
    mul r20, r20
    sub r19, r1
    sbc r26, zero
    mul r21, r21
    sub r26, r0
    mul r20, r21
    lsl r0
    rol r1
    sub r19, r0
    sbc r26, r1
    mul r19, r24
    mov r19, r1
    mul r26, r24
    mov r26, r22
    add r19, r0
    adc r20, r1
    adc r21, zero
    mul r19, r27
    mov r19, r0
    mov c0, r1
    mul r20, r27
    or c0, r0
    mov c1, r1
    mul r21, r27
    or c1, r0
    mov c2, r1
    cp r19, r18
    brlo .Ldone
    add r19, r18
    brcs .Lup
    // r' = c; a0 in r26
.Lnear_half:
    neg r26
    mul c0, c2
    add r26, r0
    add r26, r0
    test_half
    brpl .Ldone
.Lup:
    increment_bytes c0, 3
.Ldone:
    clr r1
    ret

    // The difference for c + 1, if c was not enough.
.Lremainder_of_two:
    add r18, c0
    adc r19, c1
    adc r26, zero
    add r18, c0
    adc r19, c1
    adc r26, zero
    brmi .Lup
    clr r1
    ret

    // 2^8 .. 2^12: k = 2, 3. r20 = 2^(2 k) and r27 = 2^(8 - k); only f = 1/2 - 2^-k is in doubt.
.Lbelow_sixteenth:
    ldi r20, 16
    ldi r27, 64
    cpi r23, 4
    brsh 1f
    cpi r23, 1
    brlo .Lbyte
    ldi r20, 64
    ldi r27, 32
1:  mul r23, r20
    mov r30, r0
    mul_or r22, r20, r19, r30
    root16 r20, r21, r18, r19
    mov r26, r22
    mul r20, r27
    mov r18, r0
    mov c0, r1
    mul r21, r27
    or c0, r0
    mov c1, r1
    subi r18, 0x80
    brsh .Lup
    add r18, r27
    breq .Lnear_half
    clr r1
    ret

.Lbyte:
    mov r30, r22
    ldi r31, hi8(fixedpoint_sqrt_table)
    cpi r22, 64
    lpm_pages c0, c1
    brlo 2f
    ldi r18, 4
1:  lsr c1
    ror c0
    dec r18
    brne 1b
    adc c0, zero
    adc c1, zero
2:  ret

    // 2^24 .. 2^31: r27 = 2^(2 k). S is decremented by 6, so that it is 1 to 11 below the root, and
    // then refined by the same slope times its exact remainder, of which the upper half of 32 bits
    // is enough. That leaves it at most 0.1 above and 1.2 below the root, so r is again r' or r' +
    // 1.
.Labove_256:
    ldi r27, 1
    cpi r25, 64
    brsh 1f
    ldi r27, 4
    cpi r25, 16
    brsh 1f
    ldi r27, 16
    cpi r25, 4
    brsh 1f
    ldi r27, 64
1:  mul r25, r27
    mov r30, r0
    mul_or r24, r27, r26, r30
    mul_or r23, r27, r19, r26
    mul_or r22, r27, r18, r19
    clr zero
    root16 r20, r21, r24, r26
    movw r30, r18
    mul r20, r20
    sub r18, r0
    sbc r19, r1
    sbc r26, zero
    mul r21, r21
    sub r26, r0
    mul r20, r21
    lsl r0
    rol r1
    sub r19, r0
    sbc r26, r1
    // S in r21:r20:r18
    mul r19, r24
    mov r18, r1
    mul_add r26, r24, r18, r20, zero, r21
    subi r18, 6
    sbc r20, zero
    sbc r21, zero
    // Its remainder's upper half in r31:r30
    mul r20, r18
    lsl r0
    rol r1
    sbc r31, zero
    sub r30, r1
    sbc r31, zero
    mul r20, r20
    sub r30, r0
    sbc r31, r1
    mul r21, r18
    lsl r0
    rol r1
    sub r30, r0
    sbc r31, r1
    mul r21, r20
    lsl r0
    sub r31, r0
    mul r30, r24
    mov r30, r1
    mul r31, r24
    add r0, r30
    adc r1, zero
    add r18, r1
    adc r20, zero
    adc r21, zero
    rjmp 2f
1:  lsr r21
    ror r20
    ror r18
2:  lsr r27
    lsr r27
    brne 1b
    // c^2 + c - a 2^16 modulo 2^32, with c = r' in r21:r20:r18
    com r23
    neg r22
    sbci r23, 0xff
    mul r18, r18
    movw r30, r0
    add r30, r18
    adc r31, r20
    adc r22, r21
    adc r23, zero
    mul_add r20, r18, r31, r22, zero, r23
    add r31, r0
    adc r22, r1
    adc r23, zero
    mul_add r20, r20, r22, r23
    mul_add r21, r18, r22, r23
    add r22, r0
    adc r23, r1
    mul r21, r20
    add r23, r0
    add r23, r0
    mov r22, r18
    mov r23, r20
    mov r24, r21
    brpl 1f
    rjmp .Lup
1:  clr r1
    ret
    ENDFUNC fixedpoint_sqrt_q16_16
#endif
