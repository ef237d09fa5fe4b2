// SPDX-License-Identifier: MIT
// int32_t fixedpoint_reciprocal_sqrt_q<32 - F>_<F>(int32_t a)
// 2^F sqrt(2^F / a) in every 32-bit format except Q16.16, which has a smaller kernel of its own;
// within 0.53 ulp, and for results from 2^29 on within 0.62 ulp; saturated to the largest number,
// which is also the result for a = 0; 0 if a < 0.
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    0 bytes
// Table    3328 bytes, fixedpoint_reciprocal_sqrt_32_table
//
// a = m 2^e, 1 <= m < 2. The leading byte looks up its base-2 logarithm and the power of 2 that
// shifts its leading one to the upper bit of the interval. That bit is then replaced by the parity of
// 3F - e: 128 intervals are for sqrt(1/m) and 128 for sqrt(1/2m), so that nothing has to be multiplied
// by sqrt(1/2). The bytes below are the position t in the interval. The mantissa,
//
//     value - t (slope - t (bend - 2 t twist)) in units of 2^-39,
//
// is shifted into place by scale_40.S. The core of cubic_32.S would not do: these intervals are twice
// as wide, so that the twist needs a bit more, and two bytes of t. Products are omitted as there.
//
// Error in units of 2^-31, over all 2^32 positions: -0.11 to 0.12.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define records fixedpoint_reciprocal_sqrt_32_table
#define factors fixedpoint_reciprocal_sqrt_32_table + 0xc00
#define place r19
#define zero r23
#define factor r26
#define t0 r22
#define t1 r24
#define t2 r25
#define twist r18
#define twisted0 r20
#define twisted1 r21
#define bend0 r20
#define bend1 r18
#define bend2 r26
#define fall0 r20
#define fall1 r21
#define fall2 r27
#define slope0 r18
#define slope1 r20
#define slope2 r26
#define slope3 r27
#define rise0 r18
#define rise1 r21
#define rise2 r22
#define rise3 r20

    // The factor, and the exponent of 2 off from `place`, of the leading byte.
    .macro find_exponent leading
    mov r30, \leading
    andi r30, 0xfe
    ldi r31, hi8(factors)
    lpm factor, Z+
    lpm r0, Z
    sub place, r0
    .endm

    SECTION fixedpoint_reciprocal_sqrt_32
.Lthree_bytes:
    subi place, -8
    tst r24
    breq .Ltwo_bytes
    find_exponent r24
    mul r24, factor
    mov r30, r0
    mul_or r23, factor, t2, r30
    mul_or r22, factor, t1, t2
    ldi t0, 0
    rjmp .Llook_up
.Ltwo_bytes:
    subi place, -8
    tst r23
    breq .Lone_byte
    find_exponent r23
    mul r23, factor
    mov r30, r0
    mul_or r22, factor, t2, r30
    ldi t0, 0
    rjmp .Llook_up
.Lone_byte:
    subi place, -8
    tst r22
    breq .Ltoo_large
    find_exponent r22
    mul r22, factor
    mov r30, r0
    ldi t0, 0
    rjmp .Llook_up
.Lout_of_range:
    clr r1
    sbrs place, 7
.Ltoo_large:
    XJMP fixedpoint_largest_32
.Ltoo_small:
    XJMP fixedpoint_zero_32

    // place = 3F - 19, twice the place of scale_40 less 14
    ENTRY fixedpoint_reciprocal_sqrt_32
    tst r25
    breq .Lthree_bytes
    brmi .Ltoo_small
    find_exponent r25
    mul r25, factor
    mov r30, r0
    mul_or r24, factor, t2, r30
    mul_or r23, factor, t1, t2
    mul_or r22, factor, t0, t1
.Llook_up:
    cpi place, 68
    brsh .Lout_of_range
    lsl r30
    lsr place
    ror r30
    subi place, -7
    ldi zero, 12
    mul r30, zero
    movw r30, r0
    subi r31, hi8(-(records))
    ldi zero, 0
    lpm twist, Z+
    mul twist, t2
    movw twisted0, r0
    mul twist, t1
    add twisted0, r1
    adc twisted1, zero
    lsl twisted0
    rol twisted1
    lpm bend1, Z+
    lpm bend2, Z+
    sbc bend2, zero
    neg bend0
    sbc bend1, twisted1
    sbc bend2, zero
    mul bend0, t2
    mov fall0, r1
    ldi fall1, 0
    mul_add_upper bend1, t1, fall0, zero, fall1
    mul_add_upper bend2, t0, fall0, zero, fall1
    mul_add bend2, t1, fall0, fall1
    mul bend2, t2
    add fall1, r0
    mov fall2, r1
    adc fall2, zero
    mul_add bend1, t2, fall0, fall1, zero, fall2
    lpm slope0, Z+
    sub slope0, fall0
    lpm slope1, Z+
    sbc slope1, fall1
    lpm slope2, Z+
    sbc slope2, fall2
    lpm slope3, Z+
    sbc slope3, zero
    mul slope0, t2
    mov rise0, r1
    ldi rise1, 0
    mul_add_upper slope1, t1, rise0, zero, rise1
    mul_add_upper slope2, t0, rise0, zero, rise1
    mul_add slope3, t0, rise0, rise1
    ldi rise2, 0        // t0 is used up
    mul_add slope2, t1, rise0, rise1, zero, rise2
    mul_add slope1, t2, rise0, rise1, zero, rise2
    ldi rise3, 0        // slope1 is used up
    mul_add slope3, t1, rise1, rise2
    mul_add slope2, t2, rise1, rise2, zero, rise3
    mul_add slope3, t2, rise2, rise3
    lpm r23, Z+
    sub r23, rise0
    lpm r24, Z+
    sbc r24, rise1
    lpm r25, Z+
    sbc r25, rise2
    lpm r26, Z+
    sbc r26, rise3
    lpm r27, Z+
    sbci r27, 0
    XJMP fixedpoint_scale_40
    ENDFUNC fixedpoint_reciprocal_sqrt_32

    .macro kernels integer, fraction
    FUNCTION fixedpoint_reciprocal_sqrt_q\integer\()_\fraction
    ldi place, 3 * \fraction - 19
    XJMP fixedpoint_reciprocal_sqrt_32
    ENDFUNC fixedpoint_reciprocal_sqrt_q\integer\()_\fraction
    .endm

#include "splits_32.inc"

#endif
