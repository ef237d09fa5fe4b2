// SPDX-License-Identifier: MIT
// int16_t fixedpoint_divide_q8_8(int16_t a, int16_t b)
// floor(2^8 a / b + 1/2), saturated. If b = 0: the largest number if a > 0, the smallest if a < 0,
// 0 if a = 0.
//
// In:       a r25:r24, b r23:r22
// Out:      r25:r24
// Clobbers: r0, r18..r23, r26, r27, r30, r31
// Stack:    0 bytes.
//
// On magnitudes; the sign is restored at the end. A negative quotient is rounded by half a divisor
// less one unit, so that ties round half up.
//
// |b| < 1: b has one byte. With its leading one shifted to bit 7, it divides 2^9 |a|, shifted
// likewise, exactly and in two digits by Moeller and Granlund's reciprocal; 2 |a| < 2^8 b unless
// the result saturates, so the first digit fits. In the second step the remainder never reaches the
// divisor (all 2^14 pairs of divisor and remainder were tried), so it omits the second correction.
// The quotient has one bit more than the result, which rounds; only a negative tie must look at the
// remainder. Rounding does not carry beyond the low byte: the fraction of a quotient by one byte is
// at most 254/255, less than the 511/512 needed for that.
//
// |b| >= 1, |a| < |b|: one digit, from the reciprocal of the leading eight bits of b plus one. It
// is therefore never too large, and at most 4 too small (all dividends and divisors were tried):
// subtractions bring the remainder below b. Half a divisor, added to the remainder beforehand,
// rounds the digit. |b| = 128 is a shift.
//
// |b| >= 1, |a| >= |b|: all bits in one step. Let d = 2^k |b| have its leading one in bit 15, v be
// the largest number with d v < 2^24, and e = 2^24 - d v <= d. A Newton step turns v into the
// reciprocal v (1 + e / 2^24); times 2^k that is u, which is 2^24 / |b| less about 1 unit. q = (u
// |a| + 2^14) / 2^16, rounded down, is the rounded quotient or 1 less: all dividends and divisors
// were tried, and any number from 60 2^8 to 64 2^8 would do for 2^14. So half a divisor plus the
// remainder is at least 0 and below 2 |b| < 2^16, and its lower 16 bits tell which. Only 2^15 / 2^8
// is out of range.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include <fixedpoint/avr/long_division.inc>

#define a0 r24
#define a1 r25
#define b0 r22
#define b1 r23
#define d0 r26
#define d1 r27
#define u0 r26
#define u1 r27
#define q0 r18
#define q1 r19
#define zero r20
#define sign r21

    FUNCTION fixedpoint_divide_q8_8
    mov sign, a1
    eor sign, b1
    tst a1
    brpl 1f
    com a1
    neg a0
    sbci a1, 0xff
1:  ldi r31, hi8(fixedpoint_long_division_table)
    tst b1
    brne .Llong

.Lshort:
    lsl a0
    rol a1
    brcs .Lsaturate_short
    cp a1, b0
    brsh .Lsaturate_unless_zero_short
    movw d0, a0
    sbrc b0, 7
    rjmp 1f
    mov r30, b0
    lpm r18, Z
    mul b0, r18
    mov b0, r0
    mul a0, r18
    movw d0, r0
    mul a1, r18
    add d1, r0
1:  mov r30, b0
    lpm r18, Z
    mul r18, d1
    add r0, d0
    adc r1, d1
    movw a0, r0
    inc a1
    mul a1, b0
    sub d0, r0
    cp a0, d0
    brcc 1f
    dec a1
    add d0, b0
1:  cp d0, b0
    brcc .Lfirst_digit_low
.Lsecond_digit:
    mul r18, d0
    add r1, d0
    mov r19, r0
    mov a0, r1
    inc a0
    mul a0, b0
    neg r0
    cp r19, r0
    brcc 1f
    dec a0
    add r0, b0
1:  clr r1
    lsr a1
    ror a0
    tst sign
    brmi .Lround_negative
    adc a0, r1
    ret

    // At a tie of a negative quotient the remainder is 0.
.Lround_negative:
    brcc .Lnegate
    cp r1, r0
    adc a0, r1
.Lnegate:
    com a1
    neg a0
    sbci a1, 0xff
    ret

.Lsaturate_unless_zero_short:
    rjmp .Lsaturate_unless_zero
.Lsaturate_short:
    rjmp .Lsaturate

.Lfirst_digit_low:
    inc a1
    sub d0, b0
    rjmp .Lsecond_digit

    // d = 2^k b with its leading one in bit 15.
.Llong:
    brmi .Lnegative_divisor
.Llong_positive:
    mov r30, b1
    lpm r18, Z
    mul b0, r18
    movw d0, r0
    mul b1, r18
    add d1, r0
    cp a0, b0
    cpc a1, b1
    brsh .Lwhole

    // A = 2^k a < d. The quotient's digit is 2^8 A / d; v = the reciprocal of d's high byte + 1.
    mov r30, d1
    inc r30
    lpm r19, Z
    mul a0, r18
    movw b0, r0
    mul a1, r18
    add b1, r0
    mul b1, r19
    add r0, b0
    adc r1, b1
    mov a0, r1
    clr a1
    movw r30, d0
    lsr r31
    ror r30
    sbrc sign, 7
    sbiw r30, 1
    add r31, b0
    brcc 1f
    inc b1
1:  mul a0, d0
    sub r30, r0
    sbc r31, r1
    sbci b1, 0
    mul a0, d1
    sub r31, r0
    sbc b1, r1
    clr r1
    rjmp 2f
1:  adiw a0, 1
2:  sub r30, d0
    sbc r31, d1
    sbc b1, r1
    brcc 1b
    sbrc sign, 7
    rjmp .Lnegate
    ret

.Lnegative_divisor:
    com b1
    neg b0
    sbci b1, 0xff
    brmi .Lsmallest_divisor
    tst b1
    brne .Llong_positive
    rjmp .Lshort

    // |b| = 2^15: the quotient is |a| / 2^7.
.Lsmallest_divisor:
    sbrc sign, 7
    sbiw a0, 1
    adiw a0, 0x20
    adiw a0, 0x20
    lsl a0
    rol a1
    mov a0, a1
    mov a1, r1
    rol a1
    sbrc sign, 7
    rjmp .Lnegate
    ret

.Lwhole:
    clr zero
    invert q1, d1, d0       // v - 2^8
    com r30                 // e / 2^8
    // r30 = the byte below v in v (1 + e / 2^24)
    mul q1, r30
    add r30, r1
    // u = 2^k v:r30 / 2^8, rounded
    mul q1, r18
    movw u0, r0
    add u1, r18
    mul r30, r18
    lsl r0
    adc u0, r1
    adc u1, zero
    // q = (u |a| + 2^14) / 2^16
    mul u1, a1
    movw q0, r0
    mul u0, a0
    mov r30, r1
    mul_add u0, a1, r30, q0, zero, q1
    mul_add u1, a0, r30, q0, zero, q1
    subi r30, 0xc0
    sbci q0, 0xff
    sbci q1, 0xff
    // r31:r30 = the remainder and half a divisor
    movw r30, b0
    sbrc sign, 7
    sbiw r30, 1
    lsr r31
    ror r30
    add r31, a0
    mul q0, b0
    sub r30, r0
    sbc r31, r1
    mul q0, b1
    sub r31, r0
    mul q1, b0
    sub r31, r0
    clr r1
    cp r30, b0
    cpc r31, b1
    sbci q0, 0xff
    sbci q1, 0xff
    brmi .Lsaturate
    movw a0, q0
    sbrc sign, 7
    rjmp .Lnegate
    ret

    // Out of range, or 0 / 0.
.Lsaturate_unless_zero:
    mov r18, a0
    or r18, a1
    breq .Lreturn
.Lsaturate:
    ldi a0, 0xff
    ldi a1, 0x7f
    sbrc sign, 7
    adiw a0, 1
.Lreturn:
    ret

    ENDFUNC fixedpoint_divide_q8_8

#endif
