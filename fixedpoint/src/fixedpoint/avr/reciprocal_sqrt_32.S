// SPDX-License-Identifier: MIT
// int32_t fixedpoint_reciprocal_sqrt_q<32 - F>_<F>(int32_t a)
// 2^F sqrt(2^F / a) in every 32-bit format except Q16.16, which has a smaller kernel of its own;
// within 0.55 ulp, and for results from 2^29 on within 0.75 ulp; saturated to the largest number,
// which is also the result for a = 0; 0 if a < 0.
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    3 bytes
// Table    3328 bytes, fixedpoint_reciprocal_sqrt_32_table
//
// a = m 2^e, 1 <= m < 2: the leading byte looks up its base-2 logarithm and the power of 2 that
// shifts its leading one out; the rest is the position in the table of 1 - 1/sqrt(1 + x). If 3F - e
// is odd, the mantissa is multiplied by 1/sqrt(2); scale_40.S shifts it into place.
//
// Error in units of 2^-31: the 40-bit core 0.2, the product with 1/sqrt(2) 0.02.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "cubic_32.inc"

#define factors fixedpoint_reciprocal_sqrt_32_table + 0xc00
#define factor r26
#define twice r27

    // The factor, and the exponent of 2 off from `twice`, of the leading byte, 2 or more.
    .macro find_exponent leading
    mov r30, \leading
    lsr r30
    ldi r31, hi8(factors)
    lpm factor, Z
    subi r30, 128
    lpm r0, Z
    sub twice, r0
    .endm

#define m0 r23
#define m1 r24
#define m2 r25
#define m3 r26
#define m4 r27
#define product0 r18
#define product1 r19
#define product2 r20
#define product3 r22
#define product4 r30
#define upper r31
#define lower r23

    SECTION fixedpoint_reciprocal_sqrt_32
.Lnot_positive:
    tst r25
    brmi 1f
    XJMP fixedpoint_largest_32
1:  XJMP fixedpoint_zero_32
.Lone_byte:
    cpi r22, 2
    brlo 1f
    find_exponent r22
    mul r22, factor
    mov r30, r0
    ldi r20, 0
    rjmp .Lone_byte_of_t
1:  tst r22
    breq .Lnot_positive
    ldi r30, 0
    ldi r20, 0
.Lone_byte_of_t:
    ldi r19, 0
    ldi r18, 0
    rjmp .Llook_up
.Ltwo_bytes:
    tst r24
    brne .Lone_leads_three
    subi twice, -8
    cpi r23, 2
    brlo 1f
    find_exponent r23
    mul r23, factor
    mov r30, r0
    mul_or r22, factor, r20, r30
    rjmp .Lone_byte_of_t
1:  tst r23
    brne .Lone_leads_two
    subi twice, -8
    rjmp .Lone_byte
.Lone_leads_two:
    mov r30, r22
    ldi r20, 0
    rjmp .Lone_byte_of_t
.Lone_leads_three:
    mov r30, r23
    mov r20, r22
    rjmp .Lone_byte_of_t
.Lone_leads_four:
    mov r30, r24
    mov r20, r23
    mov r19, r22
    ldi r18, 0
    rjmp .Llook_up
.Lthree_bytes:
    tst r25
    brne .Lone_leads_four
    subi twice, -8
    cpi r24, 2
    brlo .Ltwo_bytes
    find_exponent r24
    mul r24, factor
    mov r30, r0
    mul_or r23, factor, r20, r30
    mul_or r22, factor, r19, r20
    ldi r18, 0
    rjmp .Llook_up

    // twice = 3F + 19 - 24
    ENTRY fixedpoint_reciprocal_sqrt_32
    cpi r25, 2
    brlo .Lthree_bytes
    sbrc r25, 7
    rjmp .Lnot_positive
    find_exponent r25
    mul r25, factor
    mov r30, r0
    mul_or r24, factor, r20, r30
    mul_or_bytes r22, factor, r18, 2
.Llook_up:
    clr zero
    cpi twice, 82
    brge .Ltoo_large
    cpi twice, 14
    brlt .Ltoo_small
    push twice
    find_record fixedpoint_reciprocal_sqrt_32_table, r22
    XCALL fixedpoint_cubic_40
    com_bytes m0, 5
    subi m4, 0x80
    pop product1
    lsr product1
    brcc .Lodd
    XJMP fixedpoint_scale_40
.Ltoo_large:
    clr r1
    XJMP fixedpoint_largest_32
.Ltoo_small:
    clr r1
    XJMP fixedpoint_zero_32
.Lodd:
    push product1
    ldi upper, 0xb5
    mul m0, upper
    mov product0, r1
    clr product1
    clr product2
    ldi lower, 0x04
    mul_add_upper m1, lower, product0, zero, product1
    ldi lower, 0xf3
    mul_add_upper m2, lower, product0, zero, product1
    ldi lower, 0x34
    mul_add_upper m3, lower, product0, zero, product1
    mul_add m4, lower, product0, product1, zero, product2
    ldi lower, 0xf3
    mul_add m3, lower, product0, product1, zero, product2
    ldi lower, 0x04
    mul_add m2, lower, product0, product1, zero, product2
    mul_add m1, upper, product0, product1, zero, product2
    clr product3
    mul_add m3, lower, product1, product2, zero, product3
    mul_add m2, upper, product1, product2, zero, product3
    ldi lower, 0xf3
    mul_add m4, lower, product1, product2, zero, product3
    clr product4
    ldi lower, 0x04
    mul_add m4, lower, product2, product3, zero, product4
    mul_add m3, upper, product2, product3, zero, product4
    mul_add m4, upper, product3, product4
    mov m4, product4
    mov m3, product3
    mov_from_top m0, product0, 3
    pop r19
    XJMP fixedpoint_scale_40
    ENDFUNC fixedpoint_reciprocal_sqrt_32

    .macro kernels integer, fraction
    FUNCTION fixedpoint_reciprocal_sqrt_q\integer\()_\fraction
    ldi twice, 3 * \fraction + 19 - 24
    XJMP fixedpoint_reciprocal_sqrt_32
    ENDFUNC fixedpoint_reciprocal_sqrt_q\integer\()_\fraction
    .endm

#include "splits_32.inc"

#endif
