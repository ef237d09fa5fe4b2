// SPDX-License-Identifier: MIT
// int32_t fixedpoint_divide_q16_16(int32_t a, int32_t b)
// floor(a 2^16 / b + 1/2), saturated: the Q16.16 quotient rounded to nearest, half up. If b = 0:
// the largest number if a > 0, the smallest if a < 0, 0 if a = 0.
//
// In       a = r25:r22, b = r21:r18
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    4 bytes if |b| >= 2^24, otherwise at most 2
// Table    512 bytes, fixedpoint_reciprocal_table
//
// On the magnitudes n = |a| and d = |b|; T is the sign. Both are multiplied by the same w = p v. p
// is the power of two that moves the leading one of d to the top of its highest byte, and v is a
// 9-bit reciprocal of the result, so that d w = D = 2^k - E with 0 < E < 2^(k-8), where k is 8
// times one more than the number of bytes of d. (tables/reciprocal.py: the v of the table or, if E
// takes another bit, v + 1.) A base-256 digit of the quotient is then the highest byte of the
// dividend x = n w itself (A. Svoboda, An algorithm for division, 1963):
//
//     x - digit D = x - digit 2^k + digit E
//
// drops the byte and adds digit E below it. If that carries out of k bits, the digit is one larger,
// and E is added once more. That cannot carry again: digit E <= 255 (2^(k-8) - 1), so less than 2^k
// - 2^(k-8) remains after the carry. The larger digit may be 256, so it is added to all digits
// above.
//
// The product of the last digit uses only the highest byte of E, which leaves the highest byte of
// the remainder R at most 1 too small. The quotient grows by 0 if R < D/2, by 1 if R < 3/2 D, and
// otherwise by 2. Since D > 2^k - 2^(k-8), the thresholds are 7f.8..80.0 and 17e.8..180.0 in units
// of the highest byte: unless that byte is 7d, 7e or 7f, it decides; otherwise R is completed and
// compared. A tie, a 2^17 / d odd, requires that 2^17 divides d.
//
// Zero leading bytes of n and of x are skipped. If d < 2^16, overflow, n >= 2^15 d, is checked
// first; n < 2^24 with d >= 2^9 cannot overflow. For larger d, only -2^31 / -2^16 can.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define n0 r22
#define n1 r23
#define n2 r24
#define n3 r25

    SECTION fixedpoint_divide_q16_16

    // Bytes x1..x3 of (n1:n0) w, from x1:x0 = n0 w0; w = r27:r26.
    .macro multiply_low x1, x2, x3
    mul n0, r27
    clr \x2
    add \x1, r0
    adc \x2, r1
    mul n1, r26
    clr \x3
    add \x1, r0
    adc \x2, r1
    rol \x3
    mul_add n1, r27, \x2, \x3
    .endm
    // Adds byte w at x2, x3 and the new x4.
    .macro multiply_byte byte, x2, x3, x4
    mul \byte, r26
    clr \x4
    add \x2, r0
    adc \x3, r1
    rol \x4
    mul_add \byte, r27, \x3, \x4
    .endm

    // A digit in q, followed by the bytes x3..x0; E = r31:r19:r18, r24 = 0. Branches to 9 if the
    // digit was right, otherwise falls through, so that q is incremented.
    .macro digit24 q, x0, x1, x2, x3
    mul \q, r31
    movw r26, r0
    mul \q, r18
    add \x0, r0
    adc \x1, r1
    adc \x2, r26
    adc \x3, r27
    brcs 7f
    mul \q, r19
    add \x1, r0
    adc \x2, r1
    adc \x3, r24
    brcc 9f
    rjmp 8f
7:  mul_add \q, r19, \x1, \x2, r24, \x3
8:  add \x0, r18
    adc \x1, r19
    adc \x2, r31
    adc \x3, r24
    .endm
    // r1:r27..r24 = q E, E = r31..r28, r16 = 0.
    .macro multiply32 q
    mul \q, r28
    movw r24, r0
    mul \q, r30
    movw r26, r0
    mul_add \q, r29, r25, r26, r16, r27
    mul \q, r31
    add r27, r0
    adc r1, r16
    .endm

    // n >= 2^15 d, including d = 0; the result is 0 only for 0 / 0.
.Lsaturate:
    or_bytes r0, n0, 4
    breq 1f
    ldi r22, 0xff
    ldi r23, 0xff
    movw r24, r22
    andi r25, 0x7f
    brtc 1f
    com_bytes r22, 4
1:  ret
    // a = -2^31: overflows for b = -2^16, which is r21 = r20 = 0xff, r19 = r18 = 0.
.Lsmallest:
    mov r0, r21
    and r0, r20
    com r0
    or r0, r19
    or r0, r18
    brne 1f
    rjmp .Lcomplement
1:  rjmp .Lpositive
.Lnot_short:
    rjmp .Lmedium_or_long

    // d < 2^9 or n >= 2^24. If d < 2^8, then n < 2^23, and both are shifted by a byte.
.Lcheck:
    mov r0, n1
    mov r26, n2
    mov r27, n3
    lsl r0
    rol r26
    rol r27
    brcs .Lsaturate
    cp r26, r18
    cpc r27, r19
    brsh .Lsaturate
    tst r19
    brne .Lshort
    mov r19, r18
    clr r18
    mov_from_top n1, n0, 3
    clr n0
    rjmp .Lshort

    ENTRY fixedpoint_divide_q16_16
    mov r0, r25
    eor r0, r21
    bst r0, 7
    tst r25
    brpl 1f
    negate_bytes r22, 4
    brmi .Lsmallest
1:
.Lpositive:
    tst r21
    brpl .Lmagnitudes
    negate_bytes r18, 4
.Lmagnitudes:
    mov r0, r20
    or r0, r21
    brne .Lnot_short
    cpi r19, 2
    brlo .Lcheck
    tst n3
    brne .Lcheck

    // d < 2^16, r21 = r20 = 0; k = 24, E = r18:r19 (high:low), x = r23..r20, r31, and two bytes 0.
.Lshort:
    ldi r31, hi8(fixedpoint_reciprocal_table)
    mov r30, r19
    lpm r20, Z              // p
    mul r18, r20
    movw r26, r0
    mul r19, r20
    add r27, r0
.Lshort_index:
    mov r30, r27
    mov r18, r26
    lsl r18
    rol r30
    inc r31
    lpm r30, Z              // v without its ninth bit
    // r19:r18:r0 = (d p) v
    mul r27, r30
    movw r18, r0
    add r18, r26
    adc r19, r27
    mul_add_upper r26, r30, r18, r21, r19
    com r18                 // E, and whether its third byte is 0
    neg r0
    sbci r18, 0xff
    adc r19, r21
    mov r19, r0
    breq .Lshort_scale
    sub r19, r26
    sbc r18, r27
    inc r30
.Lshort_scale:
    mul r20, r30            // w
    movw r26, r0
    add r27, r20
    mul n0, r26
    mov r31, r0
    mov r20, r1
    multiply_low r20, r21, r22
    mov r23, n2
    or r23, n3
    breq .Lshort_digit_2
    multiply_byte n2, r21, r22, r23
    tst n3
    brne .Lshort_large
.Lshort_digit_3:
    tst r23
    breq .Lshort_digit_2
    mul r23, r19            // bits 24..31 of the quotient
    movw r26, r0
    mul r23, r18
    add r0, r27
    adc r1, r25
    add r20, r26
    adc r21, r0
    adc r22, r1
    brcc .Lshort_digit_2
    inc r23
    add r20, r19
    adc r21, r18
    adc r22, r25
.Lshort_digit_2:
    tst r22
    breq .Lshort_digit_1
    mul r22, r19            // bits 16..23
    movw r26, r0
    mul r22, r18
    add r0, r27
    adc r1, r25
    add r31, r26
    adc r20, r0
    adc r21, r1
    brcc .Lshort_digit_1
    subi r22, 0xff
    sbci r23, 0xff
    add r31, r19
    adc r20, r18
    adc r21, r25
.Lshort_digit_1:
    mul r21, r19            // bits 8..15
    movw r26, r0            // r26 is the byte below r31
    mul r21, r18
    add r0, r27
    adc r1, r25
    add r31, r0
    adc r20, r1
    brcc .Lshort_digit_0
    increment_bytes r21, 3
    add r26, r19
    adc r31, r18
    adc r20, r25
.Lshort_digit_0:
    mul r20, r18            // bits 0..7
    add r26, r0
    adc r31, r1
    brcs .Lshort_carry
    cpi r31, 0x80
    brsh .Lshort_up
    cpi r31, 0x7d
    brsh .Lshort_exact
.Lshort_down:
    movw r24, r22
    movw r22, r20
    clr r1
    brts .Lnegate
    ret
.Lshort_large:
    mul_add n3, r26, r22, r23
    mul n3, r27
    add r23, r0
    clr r25
    rjmp .Lshort_digit_3
.Lshort_up:
    movw r24, r22
    movw r22, r20
.Lup:
    clr r1
    brts .Lcomplement
    increment_bytes r22, 4
    ret
.Lcomplement:
    com_bytes r22, 4
    ret
.Lnegate:
    negate_bytes r22, 4
    ret
.Lshort_carry:
    cpi r31, 0x7d
    brlo .Lshort_up
    cpi r31, 0x80
    brlo 1f
    rcall .Lshort_increment
    rjmp .Lshort_up
1:  mul_add_upper r20, r19, r26, r25, r31
    add r0, r19
    adc r26, r18
    adc r31, r25
    rcall .Lshort_increment
    rjmp 2f
.Lshort_exact:
    mul_add_upper r20, r19, r26, r25, r31
2:  lsl r0
    rol r26
    rol r31
    brcs .Lshort_up
    add r0, r19
    adc r26, r18
    adc r31, r25
    brcc .Lshort_down
    rjmp .Lshort_up
.Lshort_increment:
    increment_bytes r20, 4
    ret

    // 2^16 <= d < 2^24; k = 32, E = r31:r19:r18, x = r25, r23, r30, r22, r21, r20, and two bytes 0.
.Lmedium_or_long:
    tst r21
    breq .Lmedium
    rjmp .Llong
.Lmedium:
    ldi r31, hi8(fixedpoint_reciprocal_table)
    mov r30, r20
    lpm r21, Z              // p
    // d p = r20:r27:r26
    mul r20, r21
    mov r20, r0
    mul r18, r21
    movw r26, r0
    mul_add r19, r21, r27, r20
.Lmedium_index:
    mov r30, r20
    mov r18, r27
    lsl r18
    rol r30
    inc r31
    lpm r30, Z
    // r1:r31:r19:r18 = (d p) v
    mul r26, r30
    movw r18, r0
    mul r27, r30
    clr r31
    add r19, r0
    adc r31, r1
    mul r20, r30
    add r31, r0
    adc r1, r20
    clr r0
    add r19, r26
    adc r31, r27
    adc r1, r0
    com r31
    com r19
    neg r18
    sbci r19, 0xff
    sbci r31, 0xff
    adc r1, r0
    breq .Lmedium_scale
    sub r18, r26
    sbc r19, r27
    sbc r31, r20
    inc r30
.Lmedium_scale:
    mul r21, r30
    movw r26, r0
    add r27, r21
    mul n0, r26
    movw r20, r0
    multiply_low r21, r22, r30
    mov r23, n2
    or r23, n3
    breq .Lmedium_digit_1
    multiply_byte n2, r22, r30, r23
    tst n3
    brne .Lto_medium_large
    clr r24
.Lmedium_digit_2:
    tst r23
    breq .Lmedium_digit_1
    digit24 r23, r20, r21, r22, r30
    subi r23, 0xff
    sbci r25, 0xff
9:
.Lmedium_digit_1:
    mul r30, r31            // bits 8..15
    movw r26, r0
    mul r30, r18
    add r20, r1
    adc r21, r26
    adc r22, r27
    mov r26, r0
    brcs 7f
    mul r30, r19
    add r20, r0
    adc r21, r1
    adc r22, r24
    brcs 8f
.Lmedium_digit_0:
    mul r22, r31            // bits 0..7
    add r20, r0
    adc r21, r1
    brcs .Lmedium_carry
    cpi r21, 0x80
    brsh .Lmedium_up
    cpi r21, 0x7d
    brsh .Lmedium_exact
.Lmedium_down:
    mov r24, r23
    mov r23, r30
    clr r1
    brts 1f
    ret
1:  rjmp .Lnegate
.Lmedium_up:
    mov r24, r23
    mov r23, r30
    rjmp .Lup
.Lto_medium_large:
    rjmp .Lmedium_large
7:  mul_add r30, r19, r20, r21, r24, r22
8:  subi r30, 0xff
    sbci r23, 0xff
    sbci r25, 0xff
    add r26, r18
    adc r20, r19
    adc r21, r31
    adc r22, r24
    rjmp .Lmedium_digit_0
.Lmedium_exact:
    rcall .Lmedium_rest
.Lmedium_compare:
    lsl r0
    rol r26
    rol r20
    rol r21
    brcs 1f
    add r0, r18
    adc r26, r19
    adc r20, r31
    adc r21, r24
    brcc .Lmedium_down
    brtc 1f
    or r0, r26
    or r0, r20
    or r0, r21
    breq .Lmedium_down
1:  rjmp .Lmedium_up
.Lmedium_carry:
    cpi r21, 0x7d
    brlo .Lmedium_up
    cpi r21, 0x80
    brsh 1f
    rcall .Lmedium_rest
    add r0, r18
    adc r26, r19
    adc r20, r31
    adc r21, r24
    rcall .Lmedium_increment
    rjmp .Lmedium_compare
1:  rcall .Lmedium_increment
    rjmp .Lmedium_up
.Lmedium_rest:
    mul_add r22, r19, r26, r20, r24, r21
    mul_add_upper r22, r18, r26, r24, r20, r21
    ret
.Lmedium_increment:
    subi r22, 0xff
    sbci r30, 0xff
    sbci r23, 0xff
    sbci r25, 0xff
    ret

.Lmedium_large:
    clr r24
    mul n3, r26
    add r30, r0
    adc r23, r1
    rol r24
    mul_add n3, r27, r23, r24
    mov r25, r24
    clr r24
.Lmedium_digit_3:
    digit24 r25, r21, r22, r30, r23
    inc r25
9:  rjmp .Lmedium_digit_2

    // 2^24 <= d; k = 40, E = r31..r28, x = r23..r18, and two bytes 0; r16 = 0.
.Llong:
    push_all r16, r17, r28, r29
    ldi r31, hi8(fixedpoint_reciprocal_table)
    mov r30, r21
    lpm r26, Z
    // d p = r21..r18
    clr r16
    mul r21, r26
    mov r21, r0
    mul r19, r26
    movw r28, r0
    mul r18, r26
    movw r18, r0
    mul r20, r26
    mov r20, r0
    add r21, r1
    add r19, r28
    adc r20, r29
    adc r21, r16
.Llong_index:
    mov r30, r21
    mov r0, r20
    lsl r0
    rol r30
    inc r31
    lpm r27, Z
    // r17:r31..r28 = (d p) v
    mul r18, r27
    movw r28, r0
    mul r20, r27
    movw r30, r0
    mul r21, r27
    add r31, r0
    adc r1, r21
    mov r17, r1
    mul_add r19, r27, r29, r30, r16, r31, r17
    add_bytes r29, r18, 3
    adc r17, r16
    negate_bytes r28, 4
    adc r17, r16
    breq .Llong_scale
    sub_bytes r28, r18, 4
    inc r27
.Llong_scale:
    mov r17, r26
    mul r26, r27
    movw r26, r0
    add r27, r17
    mul n0, r26
    movw r18, r0
    multiply_low r19, r20, r21
    multiply_byte n2, r20, r21, r22
    multiply_byte n3, r21, r22, r23
.Llong_digit_2:
    multiply32 r23          // bits 16..23
    add_bytes r18, r24, 4
    adc r22, r1
    brcc .Llong_digit_1
    inc r23
    add_bytes r18, r28, 4
    adc r22, r16
.Llong_digit_1:
    multiply32 r22          // bits 8..15
    mov r17, r24
    add_bytes r18, r25, 3
    adc r21, r1
    brcc .Llong_digit_0
    subi r22, 0xff
    sbci r23, 0xff
    add_bytes r17, r28, 4
    adc r21, r16
.Llong_digit_0:
    multiply32 r21          // bits 0..7
    add_bytes r17, r25, 3
    adc r20, r1
    brcc 1f
    increment_bytes r21, 3
    add r24, r28
    adc_bytes r17, r29, 3
    adc r20, r16
1:  lsl r24
    rol_bytes r17, 4
    brcs 1f
    add r24, r28
    adc_bytes r17, r29, 3
    adc r20, r16
    brcc .Llong_down
    brtc 1f
    or r24, r17
    or r24, r18
    or r24, r19
    or r24, r20
    breq .Llong_down
1:  increment_bytes r21, 3
.Llong_down:
    pop_all r29, r28, r17, r16
    mov_from_top r22, r21, 3
    clr r25
    clr r1
    brts 1f
    ret
1:  rjmp .Lnegate
    ENDFUNC fixedpoint_divide_q16_16

#endif
