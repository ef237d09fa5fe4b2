// SPDX-License-Identifier: MIT
// The core of sine, angle and logarithm in the 64-bit formats with 31 to 56 fraction bits other
// than Q32.32: a function of x in [0, 1) by polynomials of degree 7 on 64 intervals,
//
//     c0 + t (c1 + t (c2 + ... + t c7)),   where t in [0, 1) is the position in the interval.
//
// Not a C function.
//
// In       r25:r18 = 2^64 x, r31:r30 = the table (tables/septic_64.py)
// Out      r25:r18, in the table's unit; 0 if the value is below 0; r27 = 0
// Changes  r0..r27, r30, r31
//
// By Horner's rule. A product uses as many upper bytes of t as the other factor has. Of the columns
// below the product, only the carries of one are included. If the factor is negative, t is
// subtracted from the product with its two's complement.
//
// fixedpoint_round_64 is not a C function: r25:r18 = r17 and r25:r18 shifted right by r30 and
// rounded half up. Requires r30 in 1..40 and r27 = 0.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include "septic_64.inc"

    .macro step bytes, next
    fraction_product (17 + \bytes), 17, \bytes, 2
    sbrs 17 + \bytes, 7
    rjmp 1f
    sub 2, 18 - \bytes
    .set byte, 1
    .rept \bytes - 1
    sbc 2 + byte, 18 - \bytes + byte
    .set byte, byte + 1
    .endr
1:
    .if \next > \bytes
    mov 2 + \bytes, 1 + \bytes
    lsl 2 + \bytes
    sbc 2 + \bytes, 2 + \bytes
    .endif
    lpm 18, Z+
    add 18, 2
    .set byte, 1
    .rept \next - 1
    lpm 18 + byte, Z+
    adc 18 + byte, 2 + byte
    .set byte, byte + 1
    .endr
    .endm

    FUNCTION fixedpoint_septic_64
    clr zero
    // r25 = the interval, r24:r18 and r26 = t
    clr r26
    .rept 2
    lsr r25
    .irp n, 24, 23, 22, 21, 20, 19, 18, 26
    ror r\n
    .endr
    .endr
    mov_from_top r11, r18, 7
    mov r10, r26
    ldi r26, 46
    mul_add r25, r26, r30, r31
    lpm_each r18, Z+, 3
    step 3, 4
    step 4, 5
    step 5, 5
    step 5, 6
    step 6, 7
    step 7, 8
    step 8, 8
    cpi r25, 0xff
    breq 1f
    ret
1:  clr r18
    clr r19
    movw_each r20, r18, 6
    ret
    ENDFUNC fixedpoint_septic_64

    FUNCTION fixedpoint_round_64
    rjmp 2f
1:  mov r0, r18
    mov_bytes r18, r19, 7
    mov r25, r17
    lsl r17
    sbc r17, r17
2:  subi r30, 8
    brcc 1b
    subi r30, -8
    lsl r0
    tst r30
    breq 4f
3:  asr r17
    ror_bytes r18, 8
    dec r30
    brne 3b
4:  adc_each r18, zero, 8
    ret
    ENDFUNC fixedpoint_round_64
#endif
