// SPDX-License-Identifier: MIT
// int16_t fixedpoint_divide_q8_8(int16_t a, int16_t b)
// floor(2^8 a / b + 1/2), clamped; b = 0: the largest number where a > 0, the smallest where a < 0,
// 0 where a = 0.
//
// In:       a r25:r24, b r23:r22
// Out:      r25:r24
// Clobbers: r0, r18..r23, r26, r27, r30, r31
// Cycles, call and return included: |b| >= 1: |a| < |b| 74..115, |a| >= |b| 105..151;
// 1/2 <= |b| < 1: 63..87; |b| < 1/2: 75..99; clamped: 27..41. Stack: 0 bytes.
//
// On magnitudes, the sign put back at the end; for a negative quotient half a divisor less one unit
// rounds, so that ties go upward.
//
// |b| < 1: b has one byte. With its leading one moved to bit 7 it divides 2^9 |a|, moved likewise,
// in two digits by Moeller and Granlund's reciprocal, exactly; 2 |a| < 2^8 b where nothing clamps,
// so that the first digit fits. In the second step the remainder is never the divisor or more (all
// 2^14 pairs of divisor and remainder were tried), so that it lacks the second correction. The
// quotient has one bit more than the result: it is what rounds, and only a negative tie must look
// at the remainder.
//
// |b| >= 1: the integer part, not 0 only where |a| >= |b|, and one digit of fraction, both from the
// reciprocal of b's leading eight bits plus one. They are therefore never too large, and at most 2
// and 4 too small (all dividends and divisors were tried): the remainder is brought below b by
// subtraction. Half a divisor, added to the remainder beforehand, makes the last digit round.
// |b| = 128 is a shift.

#ifdef __AVR__

#define a0 r24
#define a1 r25
#define b0 r22
#define b1 r23
#define d0 r26
#define d1 r27
#define integer r20
#define sign r21

    .section .text.fixedpoint_divide_q8_8, "ax", @progbits
.Linteger_part:
    mul a0, r18
    mov r30, r1
    mul a1, r18
    add r30, r0
    adc r1, integer
    mov r31, r1
    mul r31, r19
    add r0, r30
    adc r1, r31
    mov integer, r1
    mul integer, b0
    sub a0, r0
    sbc a1, r1
    mul integer, b1
    sub a1, r0
    rjmp 2f
1:  inc integer
2:  sub a0, b0
    sbc a1, b1
    brcc 1b
    add a0, b0
    adc a1, b1
    sbrs integer, 7
    rjmp .Lfraction
    rjmp .Lsaturate

.Lnegative_divisor:
    com b1
    neg b0
    sbci b1, 0xff
    brmi 1f
    tst b1
    brne .Llong
    rjmp .Lshort
1:  rjmp .Lsmallest_divisor

    .global fixedpoint_divide_q8_8
    .type fixedpoint_divide_q8_8, @function
fixedpoint_divide_q8_8:
    mov sign, a1
    eor sign, b1
    tst a1
    brpl 1f
    com a1
    neg a0
    sbci a1, 0xff
1:  ldi r31, hi8(fixedpoint_long_division_table)
    tst b1
    breq .Lshort
    brmi .Lnegative_divisor

    // d = 2^k b with its leading one in bit 15, v = the reciprocal of its high byte + 1.
.Llong:
    mov r30, b1
    lpm r18, Z
    mul b0, r18
    movw d0, r0
    mul b1, r18
    add d1, r0
    mov r30, d1
    inc r30
    lpm r19, Z
    clr integer
    cp a0, b0
    cpc a1, b1
    brsh .Linteger_part

    // A = 2^k a < d. The quotient's digit is 2^8 A / d.
.Lfraction:
    mul a0, r18
    movw b0, r0
    mul a1, r18
    add b1, r0
    mul b1, r19
    add r0, b0
    adc r1, b1
    mov a0, r1
    mov a1, integer
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

.Lshort:
    lsl a0
    rol a1
    brcs .Lsaturate
    cp a1, b0
    brsh .Lclamp
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
    tst sign
    brmi .Lround_negative
    lsr a1
    ror a0
    adc a0, r1
    adc a1, r1
    ret
.Lround_negative:
    lsr a1
    ror a0
    brcc .Lnegate
    cp r1, r0
    adc a0, r1
    adc a1, r1
    rjmp .Lnegate

.Lnegate:
    com a1
    neg a0
    sbci a1, 0xff
    ret

.Lclamp:
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

.Lfirst_digit_low:
    inc a1
    sub d0, b0
    rjmp .Lsecond_digit

.Lsmallest_divisor:
    // |b| = 2^15: the quotient is |a| / 2^7
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

    .size fixedpoint_divide_q8_8, .-fixedpoint_divide_q8_8

#endif
