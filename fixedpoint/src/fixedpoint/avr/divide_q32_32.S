// SPDX-License-Identifier: MIT
// int64_t fixedpoint_divide_q32_32(int64_t a, int64_t b)
// floor(2^32 a / b + 1/2), saturated. If b = 0: the largest number if a > 0, the smallest if a < 0,
// 0 if a = 0.
//
// In:       a r25..r18, b r17..r10
// Out:      r25..r18
// Clobbers: r0, r26, r27, r30, r31
// Stack:    11 bytes, 23 if |b| >= 256.
//
// Long division of magnitudes in base 256 by d = 2^k |b|, whose leading one is the highest bit of
// five bytes or, if |b| >= 256, of eight; a is multiplied by 2^k too. A digit estimated from the
// highest three bytes of the remainder and the highest two of d ignores the lower bytes of d, so it
// is at most 1 too large. The digit is at most 256, and the lower bytes are less than d / 2^15: a
// negative remainder is therefore above -d / 2^7. In that case the digit is decremented, and
// instead of another division the next digit is -1 or -2, as many times as d is added to 2^8 times
// the remainder plus the next byte. So a digit that is too large costs nothing extra. The last
// digit need not be corrected, since a remainder that close to d rounds back.
//
// The remainder stays below d, so its highest bytes are at most those of d; if they are equal, the
// digit estimated is 256 and certainly too large. Finally, twice the remainder is compared with d:
// the quotient is rounded away from zero if it is not less or, for a negative quotient, more. So
// ties round half up.
//
// Five bytes: the remainder, the rest of the dividend and the quotient are one row of bytes that is
// shifted by a byte for each digit. Unless |a| < 2^31 |b|, the result saturates before the
// division. If only two bytes of d are nonzero, the digits from them are exact. Eight bytes: after
// the first digit the dividend is all zeros; the digits are kept on the stack. The quotient is
// below 2^55. It is longest for divisors of six bytes, for which two products of each digit are
// omitted.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include <fixedpoint/avr/long_division.inc>

// |a|, later the quotient
#define q0 r18
#define q1 r19
#define q2 r20
#define q3 r21
#define q4 r22
#define q5 r23
#define q6 r24
#define q7 r25
// b, then d = 2^k |b|
#define d0 r10
#define d1 r11
#define d2 r12
#define d3 r13
#define d4 r14
#define d5 r15
#define d6 r16
#define d7 r17
#define power r26

    // digit = u2:u1:u0 / h1:h0, u1:u0 = the remainder; digit 0 continues at
    // .L<name>_next, 256 at .L<name>_whole.
    .macro estimate u2, u1, u0, h1, h0, inverse, name
    estimate_digit \u2, \u1, \u0, \h1, \h0, \inverse, .L\name\()_full, .L\name\()_none
.L\name\()_tried:
    cp \u0, \h0
    cpc \u1, \h1
    brcc .L\name\()_low
.L\name\()_estimated:
    .endm
    // Out of line, and followed by .L<name>_whole: 0, 256, and estimates that are 1 too small.
    .macro unlikely_estimates u1, u0, h1, h0, name
.L\name\()_none:
    add \u0, \h0
    adc \u1, \h1
    cp \u0, \h0
    cpc \u1, \h1
    brcc .L\name\()_low
.L\name\()_zero:
    rjmp .L\name\()_next
.L\name\()_full:
    cp \u1, estimate_low
    brcs .L\name\()_whole
    dec digit
    add \u0, \h0
    adc \u1, \h1
    rjmp .L\name\()_tried
.L\name\()_low:
    sub \u0, \h0
    sbc \u1, \h1
    inc digit
    brne .L\name\()_estimated
    .endm

    // power = 2^k that moves the leading one of `byte` to bit 7.
    .macro find_power byte
    mov r30, \byte
    ldi r31, hi8(fixedpoint_long_division_table)
    ldi power, 1
    sbrs r30, 7
    lpm power, Z
    .endm

    .macro negate_q
    com_bytes q1, 7
    neg q0
    sbci_each q1, 0xff, 7
    .endm

    SECTION fixedpoint_divide_q32_32

    // Divisors of at most five bytes. u4..u0:q7..q0 is shifted left by a byte for each digit, which
    // enters at the bottom.
#define u0 r7
#define u1 r8
#define u2 r9
#define u3 r28
#define u4 r29
#define inverse r15
#define zero r16
#define count r17

    .macro move_up_dividend
    mov u4, u3
    mov u3, u2
    mov u2, u1
    mov u1, u0
    mov u0, q7
    mov_from_top q4, q3, 4
    .endm
    .macro move_up
    move_up_dividend
    mov_from_top q1, q0, 3
    .endm

    ENTRY fixedpoint_divide_q32_32
    push_all r14, r13, r12, r11, r10, r29, r28, r9, r8, r7, r17
    mov r26, q7
    eor r26, d7
    bst r26, 7
    tst q7
    brpl 1f
    negate_q
1:  tst d7
    brmi .Lnegative_divisor
    or_bytes r0, d5, 3
    breq .Lshort
    rjmp .Llong
2:  rjmp .Lnegative_long
.Lnegative_divisor:
    mov r0, d5
    and r0, d6
    and r0, d7
    com r0
    brne 2b
    com_bytes d1, 4
    neg d0
    sbc_each d1, d5, 4
    brcc 2b

.Lshort:
    or_bytes r0, q5, 3
    brne .Lcheck_range
    or_bytes r0, d2, 3
    brne .Lin_range
    // |a| < 2^31 |b|?
.Lcheck_range:
    movw r26, q4
    movw r30, q6
    mov r0, q3
    lsl r0
    rol r26
    rol r27
    rol r30
    rol r31
    clr r0
    rol r0
    cp r26, d0
    cpc r27, d1
    cpc r30, d2
    cpc r31, d3
    cpc r0, d4
    brcs .Lin_range
    rjmp .Lout_of_range

.Lin_range:
    clr zero
    ldi count, 5
1:  tst d4
    brne .Lshort_scale
    tst d3
    brne 2f
    mov d4, d2
    movw d2, d0
    clr d0
    clr d1
    subi count, -2
    rjmp 1b
2:  mov_from_top d1, d0, 4
    clr d0
    inc count
.Lshort_scale:
    find_power d4
    mul d4, power
    mov d4, r0
    mul_or_bytes d0, power, d0, 4
    or_bytes r0, q5, 3
    breq .Lshort_dividend
    tst q7
    brne 2f
    tst q6
    brne 1f
    movw_from_top q2, q0, 6
    clr q0
    clr q1
    subi count, 2
    rjmp 2f
1:  mov_from_top q1, q0, 7
    clr q0
    dec count
2:  subi count, -3
    mul q7, power
    movw u3, r0
    mul_or q6, power, u2, u3
    mul_or_bytes q4, power, u0, 2
    mul_or q3, power, q7, u0
    mul_or_bytes q0, power, q4, 3
    rjmp 3f
.Lshort_dividend:
    mul q4, power
    movw u3, r0
    mul_or q3, power, u2, u3
    mul_or_bytes q1, power, u0, 2
    mul_or q0, power, q7, u0
    clr q4
3:  clr q0
    clr q1
    movw q2, q0
.Lshort_invert:
    invert inverse, d4, d3
    // Digits that are certainly zero.
.Lskip:
    tst u4
    brne 2f
    cp u3, d4
    brsh 2f
    move_up_dividend
    dec count
    brne .Lskip
    rjmp .Lcompare
2:  tst d2
    brne .Lshort_digit
    mov r0, d1
    or r0, d0
    brne .Lshort_digit

    // Two bytes divide: the digits are exact.
.Lexact_digit:
    estimate_digit u4, u3, u2, d4, d3, inverse
    cp u2, d3
    cpc u3, d4
    brcs 1f
    inc digit
    sub u2, d3
    sbc u3, d4
1:  move_up
    mov q0, digit
    dec count
    brne .Lexact_digit
    rjmp .Lcompare

    unlikely_estimates u3, u2, d4, d3, short
.Lshort_whole:
    sub_bytes u0, d0, 3
    sbc u3, zero
    rjmp .Lshort_high

.Lshort_digit:
    estimate u4, u3, u2, d4, d3, inverse, short
    mul digit, d0
    movw r30, r0
    mul digit, d1
    add r31, r0
    mov estimate_low, r1
    adc estimate_low, zero
    mul digit, d2
    add r0, estimate_low
    adc r1, zero
    sub q7, r30
    sbc u0, r31
    sbc u1, r0
    sbc u2, r1
    sbc u3, zero
    brcs .Lshort_high
.Lshort_next:
    move_up
    mov q0, digit
    dec count
    brne .Lshort_digit

.Lcompare:
    lsl_bytes u0, 3
    rol u3
    rol u4
    brcs 2f
    brts 1f
    sec
1:  cpc_bytes d0, u0, 3
    cpc d3, u3
    cpc d4, u4
    // d7..d5 are the sign of b again.
2:  pop d7
    mov d6, d7
    mov d5, d7

    // One more if the carry is set; then the complement is the negative.
.Lround:
    clr r1
    brts .Lround_negative
    adc_each q0, r1, 8
    brmi .Lsaturate
.Lrestore:
    pop_all r7, r8, r9, r28, r29, r10, r11, r12, r13, r14
    ret

    // The remainder is negative: the digit is 1 less, and the next one -1 or -2.
.Lshort_high:
    dec digit
    move_up
    mov q0, digit
    dec count
    breq .Lround_up
    clr digit
1:  dec digit
    add q7, d0
    adc_bytes u0, d1, 3
    adc u3, d4
    adc u4, zero
    brcc 1b
    rjmp .Lshort_next

.Lsaturate:
    ldi q0, 0xff
    brtc 1f
    clr q0
1:  mov q1, q0
    movw_each q2, q0, 6
    subi q7, 0x80
    rjmp .Lrestore

.Lround_negative:
    brcc 1f
    com q0
    com_bytes q1, 7
    rjmp .Lrestore
1:  negate_q
    rjmp .Lrestore

.Lround_up:
    sec
    rjmp 2b

    // b may be zero, and then a, too.
.Lout_of_range:
    clr r1
    pop d7
    mov d6, d7
    mov d5, d7
    or_bytes r0, q0, 8
    brne .Lsaturate
    rjmp .Lrestore
#undef u0
#undef u1
#undef u2
#undef u3
#undef u4
#undef zero
#undef count
#undef inverse


    // Divisors of six to eight bytes. The quotient has at most seven bytes, and every dividend is
    // in range. u8..u0 = 2^k |a|, later the remainder.
#define u0 r18
#define u1 r19
#define u2 r20
#define u3 r21
#define u4 r22
#define u5 r23
#define u6 r24
#define u7 r25
#define u8 r29
#define zero r28
#define count r4
#define inverse r5

.Lsix_bytes:
    movw_from_top d2, d0, 6
    clr d0
    clr d1
    rjmp .Llong_scale
.Lseven_bytes:
    mov_from_top d1, d0, 7
    clr d0
    rjmp .Llong_scale

    .macro shift_remainder
    mov u8, u7
    mov_from_top u1, u0, 7
    clr u0
    .endm

.Lnegative_long:
    push d6
    push d5
    com_bytes d1, 7
    ldi r26, 0xff
    neg d0
    sbc_each d1, r26, 5
    sbci d6, 0xff
    sbci d7, 0xff
    rjmp .Llong_count

.Llong:
    push d6
    push d5
.Llong_count:
    push_all r6, r5, r4
    clr zero
    ldi r30, 7
    mov r0, d7
    or r0, d6
    breq .Lsix_bytes
    push zero
    dec r30
    tst d7
    breq .Lseven_bytes
    push zero
    dec r30
.Llong_scale:
    mov count, r30
    find_power d7
    mul d7, power
    mov d7, r0
    mul_or_bytes d0, power, d0, 7
    mul u7, power
    mov u8, r1
    mov u7, r0
    mul_or_bytes u0, power, u0, 7
.Llong_invert:
    invert inverse, d7, d6
    rjmp .Llong_digit

    unlikely_estimates u7, u6, d7, d6, long
.Llong_whole:
    sub_bytes u1, d0, 6
    sbc u7, zero
    rjmp .Llong_high

.Llong_six:
    mul digit, d2
    movw r30, r0
    mul digit, d4
    movw r8, r0
    mul_add digit, d3, r31, r8, zero, r9
    mul digit, d5
    add r9, r0
    adc r1, zero
    sub u2, r30
    sbc u3, r31
    sbc u4, r8
    sbc u5, r9
    sbc u6, r1
    sbc u7, zero
    brcc 1f
    rjmp .Llong_high
1:  rjmp .Llong_next

.Llong_digit:
    estimate u8, u7, u6, d7, d6, inverse, long
    cp d0, zero
    cpc d1, zero
    breq .Llong_six
    mul digit, d0
    movw r30, r0
    mul digit, d2
    movw r8, r0
    mul digit, d4
    movw r6, r0
    mul_add digit, d1, r31, r8, zero, r9
    mul_add digit, d3, r9, r6, zero, r7
    mul digit, d5
    add r7, r0
    adc r1, zero
    sub u0, r30
    sbc u1, r31
    sbc u2, r8
    sbc u3, r9
    sbc u4, r6
    sbc u5, r7
    sbc u6, r1
    sbc u7, zero
    brcs .Llong_high
.Llong_next:
    push digit
    dec count
    breq .Llong_round
    shift_remainder
    rjmp .Llong_digit

.Llong_high:
    dec digit
    push digit
    dec count
    breq .Llong_round_up
    shift_remainder
    clr digit
1:  dec digit
    add_bytes u0, d0, 8
    adc u8, zero
    brcc 1b
    rjmp .Llong_next

.Llong_round_up:
    sec
    rjmp 2f
    // Carry set if 2 r >= |d| or, for a negative quotient, 2 r > |d|.
.Llong_round:
    lsl_bytes u0, 8
    brcs 2f
    brts 1f
    sec
1:  cpc_bytes d0, u0, 8
2:  pop_all q0, q1, q2, q3, q4, q5, q6
    ldi q7, 0
    pop_all r4, r5, r6, d5, d6, d7
    rjmp .Lround
    ENDFUNC fixedpoint_divide_q32_32

#endif
