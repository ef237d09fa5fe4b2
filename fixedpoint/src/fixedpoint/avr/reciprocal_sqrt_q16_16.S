// SPDX-License-Identifier: MIT
// int32_t fixedpoint_reciprocal_sqrt_q16_16(int32_t a);
//
// 2^24 / sqrt(a), the reciprocal root of a 2^-16 in units of 2^-16, within 0.6441 ulp; 2^31 - 1 if
// a = 0; 0 if a < 0.
//
// int32_t fixedpoint_reciprocal_sqrt_q16_16_correctly_rounded(int32_t a);
//
// The same within 0.5 ulp. There are no ties: 2^50 is not an odd square times a.
//
// a and the result in r25:r24:r23:r22. Changes r18-r27, r30, r31, r0, the latter T; r1 is zero at
// entry and return.
//
// Technique. a is shifted left by an even number of bits, so that its top byte is at least 64. The
// mantissa 2^22 / sqrt(t / 2^16) of its upper 24 bits comes from the tables, by a chord minus a
// parabola, and is shifted back with one rounding. A fourth byte of a is dropped: it is beyond the
// 12 bits of such a result.
//
// Error. The mantissa is off by at most 2^s (0.1441) in units of its 23 bits, where the result is
// the mantissa shifted right by s bits; the tables are chosen for that.
// portable/reciprocal_sqrt.hpp is the same, bit for bit, so its largest error over all inputs,
// 0.64405 ulp at a = 1037, is also the kernel's.
//
// Correct rounding. Before the last rounding the mantissa is r 2^-8 ulp. Over all a, it is -32.0 to
// 39.8 of these from the exact value if a < 2^16, and -4.8 to 12.1 otherwise. Unless r is that
// close to the tie q + 1/2, it decides the rounding. If it is, the exact value reaches the tie if
// D = 2^50 - (2 q + 1)^2 a is above 0. Since |D| < 2^39, bit 39 of the product decides.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include <fixedpoint/avr/reciprocal_root.inc>

#define zero r25

    // Adds a product of two bytes to the columns from `low` on.
    .macro add_product x, y, low, high, carry1, carry2
    mul \x, \y
    add \low, r0
    .ifnb \high
    adc \high, r1
    .endif
    .ifnb \carry1
    adc \carry1, zero
    .endif
    .ifnb \carry2
    adc \carry2, zero
    .endif
    .endm

    // r24:r22 = q, r18 = the byte below it: rounds unless that is within -`below`..`above` of a
    // tie.
    .macro round_unless_close below, above
    subi r18, 128 - \below
    cpi r18, \below + \above
    brlo 9f
    cpi r18, 128 + \below
    .endm

    // With `correctly`, the number stays in r24:r22 for the code that decides close cases, and q is
    // elsewhere.
    .macro kernel name, correctly
    .ifnb \correctly
    .set low, 26
    .else
    .set low, 22
    .endif
    FUNCTION \name
    sbiw r24, 0
    brne 0f
    // 2^8 .. 2^16: r20 = 4^j normalises, r21 = 4 2^j shifts back by 6 - j bits, all but a byte.
    cpi r23, 64
    brlo 1f
    ldi r21, 4
    mov r30, r23
    mov r18, r22
    rjmp 3f
0:  rjmp .Labove_one\@
1:  ldi r20, 4
    ldi r21, 8
    cpi r23, 16
    brsh 2f
    ldi r20, 16
    ldi r21, 16
    cpi r23, 4
    brsh 2f
    ldi r20, 64
    ldi r21, 32
    cpi r23, 1
    brsh 2f
    rjmp .Lbyte\@
2:  mul r23, r20
    mov r30, r0
    mul_or r22, r20, r18, r30
3:  reciprocal_root
    mul r18, r21
    mov r18, r0
    mov low, r1
    mul r19, r21
    or low, r0
    mov low + 1, r1
    mul r20, r21
    or low + 1, r0
    mov r24, r1
    .ifnb \correctly
    round_unless_close 32, 40
    movw r22, low
    .else
    lsl r18
    .endif
    adc_each r22, zero, 3
    clr r1
    ret
    .ifnb \correctly
9:  movw r18, r22
    movw r22, r26
    rjmp .Ltwo_bytes\@
    .endif

.Lbyte\@:
    mov r30, r22
    ldi r31, hi8(fixedpoint_reciprocal_sqrt_table + 0x300)
    lpm_pages r22, r23, r24
    cpi r30, 64
    brsh 2f
    cpi r30, 2
    brsh 1f
    ldi r25, 0x7f
    sbrc r30, 0
    ldi r25, 1
1:  ret
2:  lsr_bytes r22, 3
    lsr_bytes r22, 3
    .ifnb \correctly
    mov r18, r30
    clr r19
    // r24:r22 = q, r19:r18 = a.
.Ltwo_bytes\@:
    push r17
    sec
    rol_bytes r22, 3
    mul r18, r22
    movw r26, r0
    clr r30
    clr r31
    clr r17
    add_product r19, r22, r27, r30
    add_product r18, r23, r27, r30, r31
    add_product r19, r23, r30, r31
    add_product r18, r24, r30, r31, r17
    add_product r19, r24, r31, r17
    rjmp .Lsquare\@
    // The same, r21:r18 = a.
.Lclose\@:
    push r17
    sec
    rol_bytes r22, 3
    mul r18, r22
    movw r26, r0
    mul r20, r22
    movw r30, r0
    clr r17
    add_product r19, r22, r27, r30, r31, r17
    add_product r21, r22, r31, r17
    add_product r18, r23, r27, r30, r31, r17
    add_product r19, r23, r30, r31, r17
    add_product r20, r23, r31, r17
    add_product r21, r23, r17
    add_product r18, r24, r30, r31, r17
    add_product r19, r24, r31, r17
    add_product r20, r24, r17
.Lsquare\@:
    // r17:r31:r30:r27:r26 = (2 q + 1) a modulo 2^40; then times 2 q + 1 once more, with r21 as the
    // upper byte.
    mul r26, r22
    mov r18, r1
    mul r30, r22
    movw r20, r0
    mov r19, r20
    mov r20, r21
    mul r17, r22
    mov r21, r0
    add_product r27, r22, r18, r19, r20, r21
    add_product r31, r22, r20, r21
    add_product r26, r23, r18, r19, r20, r21
    add_product r27, r23, r19, r20, r21
    add_product r30, r23, r20, r21
    add_product r31, r23, r21
    add_product r26, r24, r19, r20, r21
    add_product r27, r24, r20, r21
    add_product r30, r24, r21
    lsr_bytes r22, 3
    lsl r21
    .endif
    adc_each r22, zero, 3
    .ifnb \correctly
    clr r1
    pop r17
    .endif
    ret

.Lnegative\@:
    mov r22, r1
    mov r23, r1
    movw r24, r22
    ret

    // r24:r23:r22 holds the three upper bytes, r20 = 4^j normalises; the mantissa is shifted right
    // by 7 + r26 bits.
.Labove_one\@:
    brmi .Lnegative\@
    tst r25
    mov r26, r25
    .ifnb \correctly
    clt
    .endif
    breq 1f
    .ifnb \correctly
    push r22
    set
    .endif
    mov_bytes r22, r23, 3
    clr zero
    ldi r26, 4
1:  ldi r20, 64
    cpi r24, 4
    brlo 2f
    inc r26
    ldi r20, 16
    cpi r24, 16
    brlo 2f
    inc r26
    ldi r20, 4
    cpi r24, 64
    brlo 2f
    inc r26
    ldi r20, 1
2:  mul r24, r20
    mov r30, r0
    mul_or r23, r20, r18, r30
    mul_or r22, r20, r21, r18
    .ifnb \correctly
    push r26
    reciprocal_root r21
    pop low
    .else
    mov low, r26
    reciprocal_root r21
    clr r24
    .endif
    subi low, 1
    brcs 4f
    breq 5f
3:  lsr_bytes r18, 3
    dec low
    brne 3b
    rjmp 5f
4:  lsl_bytes r18, 3
5:
    .ifnb \correctly
    round_unless_close 5, 13
    .else
    lsl r18
    .endif
    mov r22, r19
    mov r23, r20
    .ifnb \correctly
    clr r24
    .endif
    adc_each r22, zero, 3
    clr r1
    .ifnb \correctly
    brtc 1f
    pop r0
1:
    .endif
    ret
    .ifnb \correctly
    // r20:r19 = q, r24:r22 = the upper three bytes of a, of which there are four where T is set.
9:  mov r26, r19
    mov r27, r20
    movw r18, r22
    mov r20, r24
    clr r21
    brtc 1f
    mov r21, r24
    mov r20, r23
    mov r19, r22
    pop r18
1:  movw r22, r26
    clr r24
    rjmp .Lclose\@
    .endif
    ENDFUNC \name
    .endm

    kernel fixedpoint_reciprocal_sqrt_q16_16
    kernel fixedpoint_reciprocal_sqrt_q16_16_correctly_rounded, correctly
#endif
