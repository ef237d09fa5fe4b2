// SPDX-License-Identifier: MIT
// int64_t fixedpoint_pow_q32_32_unsaturated(int64_t a, int64_t b)
// a^b within 0.65 ulp; a and the result are unsigned, and a result out of range is above 2^63. a
// must not be 0.
//
// In       a = r25:r18, b = r17:r10
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    26 bytes
// Tables   4044 bytes, fixedpoint_pow_64_table; 4451 bytes, fixedpoint_exp_64_table
//
// a = 2^e (1 + s). The leading bits of s choose a factor that brings 1 + s closer to 1 but not
// below it. After four such steps s is below 2^-23, where ln(1 + s) is s - s^2/2 + s^3/3 - s^4/4.
// With e ln 2 and minus the logarithms of the factors, that gives ln a. It is in units of 2^-104,
// since b and the power are up to 2^31. The product with |b| is formed column by column, in units
// of 2^-72; if it is out of range, it is replaced by 22 or -23. exp_q32_32.S does the rest.
//
// Error in units of 2^-72, where an ulp of the largest results is at least 256 units: the logarithm
// 20 units of 2^-104, hence 10, the product 7, plus that of the exponential function.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define zero r8
#include "exp_64.inc"
#define SPL 0x3d
#define SPH 0x3e
#define SREG 0x3f
#define first_records fixedpoint_pow_64_table
#define second_records first_records + 64 * 15
#define third_records second_records + 79 * 15
#define fourth_records third_records + 79 * 14
#define ln2 fourth_records + 65 * 12
#define carry r26

// Byte i of s after the point, from the first in r25 to the last in r13, is register 26 - i.

// s = (1 + s)(1 - digit 2^-8place) - 1, for s in the bytes `top` to `lowest`.
    .macro times_factor digit, place, top, lowest
    .set source, \lowest
    .rept \lowest - \top + 1
    .set target, source + \place
    mul 26 - source, \digit
    .if source < \lowest
    add r0, carry
    adc r1, zero
    .endif
    .if target < 14
    sub 26 - target, r0
    adc r1, zero
    .endif
    mov carry, r1
    .set source, source - 1
    .endr
    subtract_at \place + \top - 1, carry, \top
    subtract_at \place, \digit, \top
    .endm
    .macro subtract_at byte, subtrahend, top
    .set target, \byte
    sub 26 - target, \subtrahend
    .rept \byte - (\top)
    .set target, target - 1
    sbc 26 - target, zero
    .endr
    .endm

// r26:r13 += the logarithm of `count` bytes in the record whose address is on the stack.
    .macro add_logarithm count
    pop r31
    pop r30
    lpm r0, Z+
    add r13, r0
    .set byte, 14
    .rept \count - 1
    lpm r0, Z+
    adc byte, r0
    .set byte, byte + 1
    .endr
    .rept 14 - \count
    adc byte, zero
    .set byte, byte + 1
    .endr
    .endm

    .macro negate first, last
    .set byte, \first
    .rept \last - \first + 1
    com byte
    .set byte, byte + 1
    .endr
    .set byte, \first
    .rept \last - \first + 1
    adc byte, zero      // com has set the carry
    .set byte, byte + 1
    .endr
    .endm

// The register of byte `column` of the product: r18 to r27, r30 and r31. Column 8 is 2^-72, and
// column 7 is dropped.
    .macro to_place operation, column, source
    .set place, 10 + \column
    .if \column == 7
    .set place, 31
    .elseif \column > 17
    .set place, place + 2
    .endif
    \operation place, \source
    .endm

    FUNCTION fixedpoint_pow_q32_32_unsaturated
    push_all r8, r9, r10, r11, r12, r13, r14, r15, r16, r17, r28, r29
    clr zero
    // r28 = e + 32, s in r25:r18
    ldi r28, 63
    drop_leading_one r28
    push r28
    clr r17
    clr r16
    movw r14, r16
    clr r13

    mov r29, r25
    lsr r29
    lsr r29
    find first_records, r29, 15
    lpm r27, Z+
    push r30
    push r31
    times_factor r27, 1, 1, 8

    mov r29, r25
    swap r29
    mov r26, r24
    swap r26
    andi r26, 15
    or r29, r26
    find second_records, r29, 15
    lpm r27, Z+
    lpm r29, Z+
    push r30
    push r31
    times_factor r27, 1, 1, 9
    times_factor r29, 2, 1, 10

    mov r29, r24
    mov r26, r23
    lsl r26
    rol r29
    lsl r26
    rol r29
    find third_records, r29, 14
    lpm r27, Z+
    lpm r29, Z+
    push r30
    push r31
    times_factor r27, 2, 2, 12
    times_factor r29, 3, 2, 13

    find fourth_records, r23, 12
    lpm r27, Z+
    push r30
    push r31
    times_factor r27, 3, 3, 13

    // r22:r13 = s 2^103, r31:r25 = s^2/2 2^103, r12:r9 = s^3/2 2^102
    lsr_bytes r13, 11
    fraction_product 22, 22, 7, 25
    fraction_product 31, 22, 4, 9
    // s^2/2 - s^3/3 + s^4/4
    mul r31, r31
    lsl r0
    rol r1
    clr r24
    rol r24
    add r25, r1
    adc r26, r24
    adc_each r27, zero, 5
    sub_bytes r25, r9, 4
    sbc_each r29, zero, 3
    ldi r23, 85
    mul r9, r23
    mov r24, r1
    mul r10, r23
    add r0, r24
    adc r1, zero
    mov r9, r0
    mov r24, r1
    mul r11, r23
    add r0, r24
    adc r1, zero
    mov r10, r0
    mov r24, r1
    mul r12, r23
    add r0, r24
    adc r1, zero
    mov r11, r0
    mov r12, r1
    .set byte, 9
    .rept 4
    sub r25, byte
    .set place, 26
    .set byte, byte + 1
    .set source, byte
    .rept 6
    .if source < 13
    sbc place, source
    .else
    sbc place, zero
    .endif
    .set place, place + 1
    .set source, source + 1
    .endr
    .endr
    sub_bytes r13, r25, 7
    sbc_each r20, zero, 3
    // r26:r13 = ln a 2^104
    lsl_bytes r13, 10
    clr r23
    rol r23
    clr_bytes r24, 3
    add_logarithm 11
    add_logarithm 12
    add_logarithm 13
    add_logarithm 14
    pop r29
    ldi r30, lo8(ln2)
    ldi r31, hi8(ln2)
    clr r28
    .set byte, 13
    .rept 13
    lpm r27, Z+
    mul r27, r29
    add r0, r28
    adc r1, zero
    add byte, r0
    adc r1, zero
    mov r28, r1
    .set byte, byte + 1
    .endr
    add r26, r28

    // T = the sign of the product; |ln a| is in memory from Y + 1 on, r17:r10 = |b|
    bst r26, 7
    brtc 1f
    negate 13, 26
1:  .set byte, 26
    .rept 14
    push byte
    .set byte, byte - 1
    .endr
    in r28, SPL
    in r29, SPH
    .set byte, 17
    .rept 8
    ldd byte, Y + 34 - byte
    .set byte, byte - 1
    .endr
    clr r9
    bld r9, 7
    eor r9, r17
    bst r9, 7
    tst r17
    brpl 1f
    negate 10, 17
1:
    .set column, 7
    to_place clear, column
    to_place clear, (column + 1)
    .rept 11
    to_place clear, (column + 2)
    .set byte, 0
    .rept 8
    .if column - byte >= 0 && column - byte < 14
    ldd r9, Y + 1 + column - byte
    mul 10 + byte, r9
    to_place add, column, r0
    to_place adc, (column + 1), r1
    to_place adc, (column + 2), zero
    .endif
    .set byte, byte + 1
    .endr
    .set column, column + 1
    .endr
    // Any bit from 2^8 on means out of range.
    or r30, r31
    .set byte, 5
    .rept 3
    .set column, 18 - byte
    .rept byte - 4
    ldd r9, Y + 1 + column
    mul 10 + byte, r9
    or r30, r0
    or r30, r1
    .set column, column + 1
    .endr
    .set byte, byte + 1
    .endr
    adiw r28, 14
    in r0, SREG
    cli
    out SPH, r29
    out SREG, r0
    out SPL, r28

    ldi r31, 22
    brtc 1f
    inc r31
1:  tst r30
    brne 2f
    cp r27, r31
    brlo 3f
2:  mov r27, r31
    .set byte, 18
    .rept 9
    clr byte
    .set byte, byte + 1
    .endr
3:  brtc 1f
    negate 18, 27
1:  multiple_of_ln2 r27, r26, r17
    sub_bytes r8, r18, 9
    clr r17
    clt
    XJMP fixedpoint_power_of_rest_q32_32
    ENDFUNC fixedpoint_pow_q32_32_unsaturated
#endif
