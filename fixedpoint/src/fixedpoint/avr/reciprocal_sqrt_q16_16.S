// SPDX-License-Identifier: MIT
// int32_t fixedpoint_reciprocal_sqrt_q16_16(int32_t a);
//
// 2^24 / sqrt(a), the reciprocal root of a 2^-16 in units of 2^-16, within 0.6441 ulp; 2^31 - 1
// where a = 0; 0 where a < 0.
//
// a and the result in r25:r24:r23:r22. Changes r18-r27, r30, r31, r0; r1 is zero at entry and
// return.
//
// Technique. a is shifted left by an even number of bits, so that its top byte is at least 64. The
// mantissa 2^22 / sqrt(t / 2^16) of its upper 24 bits comes from the tables, by a chord less a
// parabola, and is shifted back with one rounding. A fourth byte of a is dropped: it is beyond the
// 12 bits that such a result has.
//
// Error. The mantissa is too far off by at most 2^s (0.1441) in units of its 23 bits, where the
// result is the mantissa shifted right by s bits; the tables are chosen for that. portable/
// reciprocal_sqrt.hpp is bit for bit the same, so that its largest error over all inputs, 0.64405
// ulp at a = 1037, is the kernel's.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include <fixedpoint/avr/reciprocal_root.inc>

#define zero r25

    FUNCTION fixedpoint_reciprocal_sqrt_q16_16
    sbiw r24, 0
    brne 0f
    // 2^8 .. 2^16: r20 = 4^j normalises, r21 = 4 2^j shifts back by 6 - j bits, all but a byte.
    cpi r23, 64
    brlo 1f
    ldi r21, 4
    mov r30, r23
    mov r18, r22
    rjmp 3f
0:  rjmp .Labove_one
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
    rjmp .Lbyte
2:  mul r23, r20
    mov r30, r0
    mul r22, r20
    or r30, r1
    mov r18, r0
3:  reciprocal_root
    mul r18, r21
    mov r18, r0
    mov r22, r1
    mul r19, r21
    or r22, r0
    mov r23, r1
    mul r20, r21
    or r23, r0
    mov r24, r1
    lsl r18
    adc r22, zero
    adc r23, zero
    adc r24, zero
    clr r1
    ret

.Lbyte:
    mov r30, r22
    ldi r31, hi8(fixedpoint_reciprocal_sqrt_table + 0x300)
    lpm r22, Z
    inc r31
    lpm r23, Z
    inc r31
    lpm r24, Z
    cpi r30, 64
    brsh 2f
    cpi r30, 2
    brsh 1f
    ldi r25, 0x7f
    sbrc r30, 0
    ldi r25, 1
1:  ret
2:  lsr r24
    ror r23
    ror r22
    lsr r24
    ror r23
    ror r22
    adc r22, zero
    adc r23, zero
    adc r24, zero
    ret

.Lnegative:
    mov r22, r1
    mov r23, r1
    movw r24, r22
    ret

    // r24:r23:r22 holds the three upper bytes, r20 = 4^j normalises; the mantissa is shifted right
    // by 7 + r26 bits.
.Labove_one:
    brmi .Lnegative
    tst r25
    mov r26, r25
    breq 1f
    mov r22, r23
    mov r23, r24
    mov r24, r25
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
    mul r23, r20
    or r30, r1
    mov r18, r0
    mul r22, r20
    or r18, r1
    mov r21, r0
    mov r22, r26
    reciprocal_root r21
    clr r24
    subi r22, 1
    brcs 4f
    breq 5f
3:  lsr r20
    ror r19
    ror r18
    dec r22
    brne 3b
    rjmp 5f
4:  lsl r18
    rol r19
    rol r20
5:  lsl r18
    mov r22, r19
    mov r23, r20
    adc r22, zero
    adc r23, zero
    adc r24, zero
    clr r1
    ret
    ENDFUNC fixedpoint_reciprocal_sqrt_q16_16
#endif
