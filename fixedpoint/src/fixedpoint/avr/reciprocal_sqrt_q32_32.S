// SPDX-License-Identifier: MIT
// int64_t fixedpoint_reciprocal_sqrt_q32_32(int64_t a)
// 2^48 / sqrt(a), the reciprocal root of a 2^-32 in units of 2^-32, within 0.65 ulp; the largest
// number if a = 0; 0 if a < 0.
//
// In       a = r25:r18
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    9 bytes
// Tables   1536 bytes, fixedpoint_reciprocal_sqrt_table
//
// a is shifted left by whole bytes and then by an even number of bits until its highest byte is 64
// or more; it is then m, 1/4 <= m < 1. reciprocal_root gives Y, 24 bits of 1 / sqrt(m), at most
// 2^-20.8 too small and biased by -9 2^-22, so that e = 1 - m Y^2 is never below 0. Then 1 /
// sqrt(m) is Y (1 + e/2 + 3/8 e^2 + ...), in which 5/16 e^3 is below 2^-54. E = e/4 is 1/4 minus
// the product of m and the six bytes of (Y/2)^2, of which the bytes of weight 2^-24 to 2^-56 are
// computed; those above are known.
//
// The result has 48 bits minus half as many as a has. The longer a is, the less its lower bytes
// matter; they and their products are computed only as far as they influence a significant byte.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include <fixedpoint/avr/reciprocal_root.inc>

#define zero r25
// m, the first byte first.
#define m1 r17
#define m2 r16
#define m3 r15
#define m4 r14
#define m5 r13
// (Y/2)^2, the first byte first.
#define s1 r27
#define s2 r26
#define s3 r24
#define s4 r23
#define s5 r22
#define s6 r21
// E, and E + 3 E^2; bytes 2^-24 to 2^-56.
#define e3 r31
#define e4 r30
#define e5 r29
#define e6 r28
#define e7 r12
// The mantissa, seven bytes.
#define z0 r26
#define z1 r18
#define z2 r19
#define z3 r20
#define z4 r21
#define z5 r22
#define z6 r23

    SECTION fixedpoint_reciprocal_sqrt_q32_32
.Lnegative:
    ldi r24, 0
    ldi r25, 0
    movw_each r18, r24, 6
    ret
.Lzero:
    ldi r18, 0xff
    ldi r19, 0xff
    movw_each r20, r18, 6
    lsr r25
    ret

    ENTRY fixedpoint_reciprocal_sqrt_q32_32
    tst r25
    brmi .Lnegative
    // r27 = one less than the number of bits by which the mantissa will be shifted right
    ldi r27, 38
    mov r0, r25
    or r0, r24
    or r0, r23
    or r0, r22
    brne 1f
    movw r24, r20
    movw r22, r18
    clr r18
    clr r19
    movw r20, r18
    ldi r27, 38 - 16
1:  mov r0, r25
    or r0, r24
    brne 1f
    movw_from_top r20, r18, 6
    clr r19
    subi r27, 8
1:  tst r25
    brne 1f
    mov_from_top r20, r19, 6
    subi r27, 4
    tst r25
    breq .Lzero
1:  cpi r25, 64
    brsh 3f
    ldi r26, 4
    dec r27
    cpi r25, 16
    brsh 2f
    ldi r26, 16
    dec r27
    cpi r25, 4
    brsh 2f
    ldi r26, 64
    dec r27
2:  mul r25, r26
    mov r25, r0
    mul_or_bytes r21, r26, r21, 4
    mul r20, r26
    or r21, r1
3:  push_all r12, r13, r14, r15, r16, r17, r28, r29, r27
    movw m2, r24
    movw m4, r22
    mov m5, r21
    mov r30, r25
    mov r18, r24
    clr zero
    reciprocal_root m3
    subi r18, 9
    sbc r19, zero
    sbc r20, zero
    lsl_bytes r18, 3
    mul r18, r18
    mov s6, r0
    mov s5, r1
    mul r19, r19
    mov s4, r0
    mov s3, r1
    mul r20, r20
    movw s2, r0
    mul r18, r19
    .rept 2
    add s5, r0
    adc s4, r1
    adc s3, zero
    adc s2, zero
    adc s1, zero
    .endr
    mul r18, r20
    .rept 2
    add s4, r0
    adc s3, r1
    adc s2, zero
    adc s1, zero
    .endr
    mul r19, r20
    .rept 2
    add s3, r0
    adc s2, r1
    adc s1, zero
    .endr
    // The product of m and s.
    mul m2, s6
    mov e7, r1
    ldi e6, 0
    ldi e5, 0
    mul_add m1, s6, e7, e6, zero, e5
    mul_add m2, s5, e7, e6, zero, e5
    ldi e4, 0
    mul_add_upper m3, s4, e6, zero, e5, e4
    mul_add_upper m4, s3, e6, zero, e5, e4
    mul_add m1, s5, e6, e5, zero, e4
    mul_add m2, s4, e6, e5, zero, e4
    mul_add m3, s3, e6, e5, zero, e4
    mul_add m4, s2, e6, e5, zero, e4
    mul_add m5, s1, e6, e5, zero, e4
    ldi e3, 0
    mul_add m1, s4, e5, e4, zero, e3
    mul_add m2, s3, e5, e4, zero, e3
    mul_add m3, s2, e5, e4, zero, e3
    mul_add m4, s1, e5, e4, zero, e3
    mul_add m1, s3, e4, e3
    mul_add m2, s2, e4, e3
    mul_add m3, s1, e4, e3
    mul m1, s2
    add e3, r0
    mul m2, s1
    add e3, r0
    // E is 1/4 less that.
    com e3
    com e4
    com e5
    com e6
    neg e7
    sbci_each e6, 0xff, 4
    // r27:r26:r24 = (8 E)^2 2^56, 21 bits of E
    movw r22, e4
    mov r21, e5
    lsl_bytes r21, 3
    lsl_bytes r21, 3
    lsl_bytes r21, 3
    mul r23, r23
    movw r26, r0
    mul r22, r22
    mov r24, r1
    mul r22, r23
    .rept 2
    add r24, r0
    adc r26, r1
    adc r27, zero
    .endr
    ldi r21, 12
    mul_add r27, r21, e6, e5, zero, e4, e3
    mul_add r26, r21, e7, e6
    adc_each e5, zero, 3
    mul r24, r21
    add e7, r1
    adc_each e6, zero, 4
    // z = Y/2 + Y (E + 3 E^2)
    mov_from_top z4, r18, 3
    mul z6, e7
    mov z0, r1
    ldi z1, 0
    mul_add_upper z5, e6, z0, zero, z1
    mul_add_upper z4, e5, z0, zero, z1
    ldi z2, 0
    mul_add z6, e6, z0, z1, zero, z2
    mul_add z5, e5, z0, z1, zero, z2
    mul_add z4, e4, z0, z1, zero, z2
    ldi z3, 0
    mul_add z6, e5, z1, z2, zero, z3
    mul_add z5, e4, z1, z2, zero, z3
    mul_add z4, e3, z1, z2, zero, z3
    clr r24
    mul_add z6, e4, z2, z3, zero, r24
    mul_add z5, e3, z2, z3, zero, r24
    mul_add z6, e3, z3, r24
    lsl z0
    rol_bytes z1, 3
    rol r24
    add z4, r24
    adc z5, zero
    adc z6, zero
    // Shifted right by r27 + 1 bits, 8 to 39
    pop r27
    sbrs r27, 5
    rjmp 1f
    mov z0, z4
    mov z1, z5
    mov z2, z6
    clr_bytes z3, 4
1:  sbrs r27, 4
    rjmp 1f
    mov z0, z2
    mov_bytes z1, z3, 4
    clr z5
    clr z6
1:  sbrs r27, 3
    rjmp 1f
    mov z0, z1
    mov_bytes z1, z2, 5
    clr z6
1:  ldi r30, 128
    sbrc r27, 1
    ldi r30, 32
    sbrc r27, 0
    lsr r30
    sbrc r27, 2
    swap r30
    mul z6, r30
    mov z6, r0
    mov r24, r1
    mul_or_bytes z1, r30, z1, 5
    mul z0, r30
    or z1, r1
    lsl r0
    adc_each z1, zero, 6
    adc r24, zero
    clr r1
    pop_all r29, r28, r17, r16, r15, r14, r13, r12
    ret
    ENDFUNC fixedpoint_reciprocal_sqrt_q32_32
#endif
