// SPDX-License-Identifier: MIT
// int64_t fixedpoint_sqrt_q32_32(int64_t a)
// The nearest number to the square root of a (there are no ties); 0 if a < 0.
//
// In:       a r25..r18
// Out:      r25..r18
// Clobbers: r0, r26, r27, r30, r31
// Stack:    10 bytes.
//
// a is shifted left by whole bytes and then by an even number of bits until its highest byte is 64
// or more. The first two bytes of the root s come from linear interpolation and are at most 3 too
// small for the highest four bytes of a: subtractions bring the remainder to at most 2 s. Each
// further byte d of the root is the largest with 2 (2^8 s) d + d^2 <= 2^16 R2 + the next two bytes,
// where R2 is the remainder, so d is about 2^8 R / s with R = R2 / 2. The digit estimated from the
// highest three bytes of R and the highest two of s is at most 256, which becomes 255, and slightly
// too large, since it ignores the lower bytes of s and d^2 / 2: if R turns negative, d is
// decremented and 2^8 s + d - 1/2 is added back to R. The lowest bit of R2 is the highest of the
// byte that follows R; the shift by one bit puts it there.
//
// The root is then shifted right by half as many bits as a was shifted left: 0 to 7, since bytes
// that would be shifted out entirely are not computed. The highest bit shifted out rounds: no
// integer has a root at exactly half an ulp. If no bit is shifted out, one more byte is computed
// or, for the longest a, the remainder is compared with s.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define a0 r18
#define a1 r19
#define a2 r20
#define a3 r21
#define a4 r22
#define a5 r23
#define a6 r24
#define a7 r25
// The root's bytes, the highest first.
#define x0 r29
#define x1 r28
#define x2 r17
#define x3 r16
#define x4 r15
#define x5 r14
#define inverse r13
#define zero r12
#define shift r11
#define count r10
#define power r26
#define half r30

#include "long_root.inc"

    FUNCTION fixedpoint_sqrt_q32_32
    tst a7
    brmi .Lnegative
    ldi r30, 4
1:  mov r0, a7
    or r0, a6
    brne 2f
    movw_from_top a2, a0, 6
    clr a0
    clr a1
    dec r30
    brne 1b
.Lzero:
    movw a0, a2
    movw a4, a2
    movw a6, a2
    ret
.Lnegative:
    clr a2
    clr a3
    rjmp .Lzero

2:  push_all r10, r11, r12, r13, r14, r15, r16, r17, r28, r29
    mov count, r30
    clr zero
    clt
    // power moves the leading one to bit 7 or 6; shift undoes that, and a shift by half a byte.
    ldi r31, 0
    tst a7
    brne 1f
    mov_from_top a1, a0, 7
    clr a0
    ldi r31, 1
1:  ldi r30, 1
    cpi a7, 64
    brsh .Lscaled
    ldi power, 4
    ldi r30, 0x80
    cpi a7, 16
    brsh 1f
    ldi power, 16
    ldi r30, 0x40
    cpi a7, 4
    brsh 1f
    ldi power, 64
    ldi r30, 0x20
1:  mul a7, power
    mov a7, r0
    mul_or_bytes a0, power, a0, 7
.Lscaled:
    sbrc r31, 0
    swap r30
    mov shift, r30
    // No bit is shifted out: one more byte or, for the longest, the remainder rounds.
    cpi r30, 1
    brne .Lseed
    inc count
    sbrs count, 2
    rjmp .Lseed
    sbrs count, 0
    rjmp .Lseed
    dec count
    set

    // x0:x1 = the root of a7:a6, at most 3 too small for a7..a4
.Lseed:
    mov r30, a7
    ldi r31, hi8(fixedpoint_sqrt_table)
    lpm_pages x1, x0, r0
    mul_add_upper r0, a6, x1, zero, x0
.Lsquare:
    mul x1, x1
    sub a4, r0
    sbc a5, r1
    sbc a6, zero
    mul x0, x0
    sub a6, r0
    mul x0, x1
    sub a5, r0
    sbc a6, r1
    sub a5, r0
    sbc a6, r1
    // Halved, with what follows.
    lsr_bytes a0, 7
    clr a7
    ror a7
    ldi half, 0x80
    rjmp .Lroot
1:  adiw x1, 1
.Lroot:
    sub a3, half
    sbc a4, x1
    sbc a5, x0
    sbc a6, zero
    brcc 1b
    add a3, half
    adc a4, x1
    adc a5, x0
    adc a6, zero
.Linvert:
    invert inverse, x0, x1

    // The third byte.
.Lthird_digit:
    estimate a5, a4, a3
.Lthird_estimated:
    half_square
    sub a1, half
    sbc a2, r0
    sbc a3, r1
    sbc a4, zero
    sbc a5, zero
    brmi .Lthird_high
.Lthird:
    mov x2, digit
    dec count
    brne .Lfourth_digit
    rjmp .Lthird_is_last

.Lthird_high:
    dec digit
    ldi half, 0x80
    add a1, half
    adc a2, digit
    adc a3, x1
    adc a4, x0
    adc a5, zero
    brmi .Lthird_high
    rjmp .Lthird

    // The fourth byte.
.Lfourth_digit:
    estimate a4, a3, a2
.Lfourth_estimated:
    mul digit, x2
    sub a1, r0
    sbc a2, r1
    sbc a3, zero
    sbc a4, zero
    half_square
    sub a7, half
    sbc a0, r0
    sbc a1, r1
    sbc_each a2, zero, 3
    brmi .Lfourth_high
.Lfourth:
    mov x3, digit
    dec count
    brne .Lfifth_digit
    rjmp .Lfourth_is_last

.Lfourth_high:
    dec digit
    ldi half, 0x80
    add a7, half
    adc a0, digit
    adc a1, x2
    adc a2, x1
    adc a3, x0
    adc a4, zero
    brmi .Lfourth_high
    rjmp .Lfourth

    // The fifth byte.
.Lfifth_digit:
    estimate a3, a2, a1
.Lfifth_estimated:
    mul digit, x3
    sub a7, r0
    sbc a0, r1
    sbc_each a1, zero, 3
    mul digit, x2
    sub a0, r0
    sbc a1, r1
    sbc a2, zero
    sbc a3, zero
    half_square
    sub a5, half
    sbc a6, r0
    sbc a7, r1
    sbc_each a0, zero, 4
    brmi .Lfifth_high
.Lfifth:
    mov x4, digit
    dec count
    brne .Lsixth_digit
    rjmp .Lfifth_is_last

.Lfifth_high:
    dec digit
    ldi half, 0x80
    add a5, half
    adc a6, digit
    adc a7, x3
    adc a0, x2
    adc a1, x1
    adc a2, x0
    adc a3, zero
    brmi .Lfifth_high
    rjmp .Lfifth

    // The sixth byte.
.Lsixth_digit:
    estimate a2, a1, a0
.Lsixth_estimated:
    mul digit, x4
    sub a5, r0
    sbc a6, r1
    sbc a7, zero
    sbc_each a0, zero, 3
    mul digit, x3
    sub a6, r0
    sbc a7, r1
    sbc_each a0, zero, 3
    mul digit, x2
    sub a7, r0
    sbc a0, r1
    sbc a1, zero
    sbc a2, zero
    half_square
    sub a3, half
    sbc a4, r0
    sbc a5, r1
    sbc a6, zero
    sbc a7, zero
    sbc_each a0, zero, 3
    brmi .Lsixth_high
.Lsixth:
    mov x5, digit
    brtc .Lshift_root

    // R > s?
.Lcompare:
    lsl_bytes a3, 5
    rol a0
    rol a1
    brcs 1f
    cp_bytes x5, a4, 4
    cpc x1, a0
    cpc x0, a1
1:  mov_bytes a0, x5, 4
    mov a4, x1
    mov a5, x0
    rjmp .Lround

.Lsixth_high:
    dec digit
    ldi half, 0x80
    add a3, half
    adc a4, digit
    adc_bytes a5, x4, 3
    adc a0, x1
    adc a1, x0
    adc a2, zero
    brmi .Lsixth_high
    rjmp .Lsixth

.Lthird_is_last:
    mov x5, x2
    mov x4, x1
    mov x3, x0
    clr x2
    rjmp 1f
.Lfourth_is_last:
    movw x5, x3
    movw x3, x1
1:  clr x1
    rjmp 1f
.Lfifth_is_last:
    mov_bytes x5, x4, 3
    mov x2, x1
    mov x1, x0
1:  clr x0

.Lshift_root:
    mul x5, shift
    mov a0, r1
    mov digit, r0
    mul x4, shift
    or a0, r0
    mov a1, r1
    mul x3, shift
    or a1, r0
    mov a2, r1
    mul x2, shift
    or a2, r0
    mov a3, r1
    mul x1, shift
    or a3, r0
    mov a4, r1
    mul x0, shift
    or a4, r0
    mov a5, r1
    lsl digit
.Lround:
    adc_each a0, zero, 6
    clr a6
    clr a7
    clr r1
    pop_all r29, r28, r17, r16, r15, r14, r13, r12, r11, r10
    ret
    ENDFUNC fixedpoint_sqrt_q32_32

#endif
