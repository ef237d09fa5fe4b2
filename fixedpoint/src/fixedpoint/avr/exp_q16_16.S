// SPDX-License-Identifier: MIT
// int32_t fixedpoint_exp_q16_16(int32_t a)
// e^a in Q16.16, within 0.66 ulp for every input; the largest number from ln 32768 on, 0 from
// -17 ln 2 down.
// int32_t fixedpoint_exp2_q16_16_unsaturated(int32_t a)
// 2^a within 0.72 ulp. a must be in [-17, 15).
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    2 bytes; 6 from 2.53 on
//
// Argument reduction: a - k ln 2, with k about a / ln 2, is between -0.26 and 0.49, where the table
// has e^x at 256 nodes. A multiple of ln 2 is stored as a 16-bit offset and a constant tail below
// these 16 bits, so the distance from the node is an integer s, a signed byte, plus that tail:
// r = s + tail, in units of 2^-16. The mantissa is power + power (e^r - 1), and 2^k is a
// multiplication by 2^((k + 1) mod 8) followed by a choice of bytes.
//   k = 0:   e^r - 1 = s: the nodes are offset by 1/16 unit, the mean of s^2 / 2.
//   k < 4:   the power's upper 24 bits; e^r - 1 = r + s^2 / 2, 16 bits.
//   k >= 4:  the power's 40 bits; e^r - 1 = r + s^2 / 2 + s tail + s^3 / 6, 32 bits.
//
// Error in ulp, including 0.5 for rounding. k = 0: s^2 / 2 less its mean is 2^-20 of a result of up
// to 1.65 2^16, 0.1; worst 0.594. k < 4: 2^-23 of the mantissa is 1/16 at k = 3, and the truncation
// of the products, apart from its mean, which the tail includes, amounts to 1.8 of these; worst
// 0.615. k >= 4: at 2^31 the truncation of the cube is 0.08, s times the lower bytes of the tail
// 0.06; worst 0.655 over all 2^32 inputs, at 675750.
//
// 2^a takes the nearest integer as k and the rest times ln 2 as r, with 24 bits of tail, of which
// 16 count in s tail; the 40-bit mantissa is used from k = 4 on. k < 4: worst 0.640. Beyond: at
// 2^31 the truncated ln 2 costs 0.06, the truncation of the cube 0.08; worst 0.711 over all inputs,
// at 982248.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

// The argument. rA0 becomes s, then the top byte of e^r - 1, the growth.
#define growth3 r22
#define growth2 r20
#define growth1 r21
#define growth0 r26
// k + 17.
#define k r27
#define zero r18
// The 40-bit mantissa starts as the power; m4 replaces rA1.
#define m0 r28
#define m1 r16
#define m2 r17
#define m3 r19
#define m4 r23
// Power times growth.
#define p0 r24
#define p1 r25
#define p2 r30
#define p3 r31
#define p4 r29
// The sign of a product; replaces growth0.
#define sign r26

#define POWER hi8(fixedpoint_exp_table)
#define REDUCTION hi8(fixedpoint_exp_table + 0x500)
// Rows of the reduction's page, k + 17 being the column.
#define COLUMNS 34
#define LARGE_COLUMNS 13

// For 2^a: the distance from the nearest integer, and 2^24 ln 2.
#define f0 r18
#define f1 r19
#define LN2_0 0x18
#define LN2_1 0x72
#define LN2_2 0xb1
// From a multiple of ln 2 to r, in units of 2^-40: the 1/16 of the nodes, minus the mean truncation
// of the products, and minus the rounding of the small tail.
#define SMALL_SHIFT 0x0c8000
#define LARGE_SHIFT 0x0fffc0

    FUNCTION fixedpoint_exp_q16_16
    mov r30, rA1
    mov r18, rA1
    lsl r18
    sbc r18, r18
    cp rA2, r18
    cpc rA3, r18
    brne .Lreduce

    // The integer part is 0 or -1 as the fraction's sign says.
    mov r20, rA0
    subi r20, 128
    ldi r31, POWER
    lpm_pages r23, r22, r21
    mulsu r20, r23
    movw r26, r0
    sbc r25, r25
    mulsu r20, r22
    sbc r24, r24
    add r26, r1
    adc r27, r24
    adc r25, r24
    add r21, r26
    adc r22, r27
    adc r23, r25
    clr r1
    ldi r24, 0
    ldi r25, 0
    subi r21, -64       // half the weight of the seven truncated bits
    sbci r22, -1
    sbci r23, -1
    lsl_bytes r21, 4
    ret

.Lout_of_range:
    tst rA3
    brmi 1f
.Lmaximum:
    ldi_bytes r22, 0x7fffffff, 4
    ret
1:  mov r22, r1
    mov r23, r1
    movw r24, r22
    ret

.Lone_or_two_bytes:
    sbrs k, 3
    rjmp 1f
    lsl r22             // k >= -9: two
    mov r22, r23
    mov r23, r24
    ldi r24, 0
    adc r22, r1
    adc r23, r1
    ret
1:  lsl r23
    mov r22, r24
    adc r22, r1
    ldi r23, 0
    ldi r24, 0
    ret

.Lreduce:
    movw r26, rA2
    adiw r26, 12
    cpi r26, 23
    cpc r27, r1
    brsh .Lout_of_range
    // k + 17 = floor((a + 12) 185 / 128)
    ldi r18, 185
    mul r26, r18
    movw r26, r0
    mul rA1, r18
    clr zero
    add r26, r1
    adc k, zero
    lsl r26
    rol k
    mov r30, k
    ldi r31, REDUCTION
    lpm r20, Z
    subi r30, -COLUMNS
    lpm r21, Z
    add rA0, r20
    adc rA1, r21
    subi rA0, 128
    subi r30, -COLUMNS
    lpm growth2, Z
    cpi k, 21
    brsh .Llarge

    subi r30, -COLUMNS
    lpm r25, Z
    mov r30, rA1
    muls growth3, growth3
    lsr r1
    add growth2, r1
    adc growth3, zero
.Lsmall:
    ldi r31, POWER
    lpm_pages r23, r19, r21
    mulsu growth3, r23
    movw r30, r0
    sbc r24, r24
    mulsu growth3, r19
    sbc r26, r26
    add r30, r1
    adc r31, r26
    adc r24, r26
    mul_add_upper growth2, r23, r21, zero, r19, r23
    add r21, r30
    adc r19, r31
    adc r23, r24
    // Products by a power of two do not overlap.
    mul r21, r25
    mov r21, r0
    mov r22, r1
    mul r23, r25
    mov r23, r0
    mov r24, r1
    mul r19, r25
    or r22, r0
    or r23, r1
    ldi r25, 0
    clr r1
    sbrs k, 4
    rjmp .Lone_or_two_bytes
    lsl r21             // k >= -1: three bytes
    adc_each r22, r1, 3
    ret
.Lnext_node:
    // s = 127: a growth of 128 units of 2^-16, plus g, does not fit. Seen from the next node it is
    // 256 units less, which is how the signed byte reads it, and 21 - 256 g units of 2^-32 more.
    inc rA1
    ldi r19, 21
    sub r19, growth2
    mov r24, r19
    lsl r24
    sbc r24, r24
    add growth1, r19
    adc growth2, r24
    adc growth3, r24
    rjmp .Lmultiply

.Llarge:
    subi r30, lo8(-(COLUMNS + LARGE_COLUMNS))
    lpm growth1, Z
    subi r30, -LARGE_COLUMNS
    lpm growth0, Z
    ldi r25, 0          // the carries into growth3, which stays s until the end
    muls growth3, growth3
    movw r30, r0
    mulsu growth3, growth2
    sbc r19, r19
.Lgrow:
    add growth0, r0
    adc growth1, r1
    adc growth2, r19
    adc r25, r19
    mov r19, r31        // s^3 / 6 = 43 s^3 / 256
    mulsu growth3, r19
    mov r19, r1
    ldi r24, 43
    muls r19, r24
    sbc r24, r24
    add growth0, r0
    adc growth1, r1
    adc growth2, r24
    adc r25, r24
    ldi r19, 0
    lsr r31
    ror r30
    ror r19
    add growth0, r19
    adc growth1, r30
    adc growth2, r31
    adc growth3, r25
    brvs .Lnext_node
.Lmultiply:
    push_all r16, r17, r28, r29
    mov r30, rA1
    ldi r31, POWER
    lpm_pages m4, m3, m2, m1, m0
    mul m4, growth1
    movw p0, r0
    mul_add_upper m4, growth0, p0, zero, p1
    mul m3, growth2
    ldi p2, 0
    add p0, r0
    adc p1, r1
    adc p2, zero
    mul_add_upper m3, growth1, p0, zero, p1, p2
    mul_add_upper m2, growth2, p0, zero, p1, p2
    mulsu growth3, m1
    sbc sign, sign
    add p0, r1
    adc p1, sign
    adc p2, sign
    mulsu growth3, m2
    sbc sign, sign
    add p0, r0
    adc p1, r1
    adc p2, sign
    mov p3, p2
    lsl p3
    sbc p3, p3
    mov p4, p3
    mulsu growth3, m4
    sbc sign, sign
    add p2, r0
    adc p3, r1
    adc p4, sign
    mul_add m4, growth2, p1, p2, zero, p3, p4
    mulsu growth3, m3
    sbc sign, sign
    add p1, r0
    adc p2, r1
    adc p3, sign
    adc p4, sign
    add m0, p0
    adc m1, p1
    adc m2, p2
    adc m3, p3
    adc m4, p4

    cpi k, 32
    brsh 2f
    mov r30, k
    subi r30, -3 * COLUMNS
    ldi r31, REDUCTION
    lpm r30, Z
    mul m4, r30
    movw r24, r0
    mul m2, r30
    movw r22, r0
    mul m3, r30
    or r23, r0
    or r24, r1
    mul m1, r30
    or r22, r1
    sbrs k, 3
    rjmp 1f
    lsl r0              // k >= 7: four bytes
    rjmp 3f
1:  lsl r22             // k = 4 to 6: three
    mov_bytes r22, r23, 3
    ldi r25, 0
    rjmp 3f
2:  lsl m0              // k = 15: all but the last of the mantissa
    mov r25, m4
    mov r24, m3
    mov r23, m2
    mov r22, m1
3:  adc_each r22, zero, 4
    pop_all r29, r28, r17, r16
    clr r1
    sbrs r25, 7
    ret
    rjmp .Lmaximum

    ENDFUNC fixedpoint_exp_q16_16

    FUNCTION fixedpoint_exp2_q16_16_unsaturated
    mov k, rA2
    sbrc rA1, 7
    inc k
    subi k, -17
    // f ln 2 in units of 2^-40, f being the lower half as a signed number, without 8 2^-32 f.
    movw f0, rA0
    ldi r30, LN2_0
    ldi r25, LN2_1
    ldi r24, LN2_2
    ldi r31, 0
    mul f0, r30
    mov growth0, r0
    mov growth1, r1
    mul f0, r24
    mov growth2, r0
    mov rA0, r1
    mul_add f0, r25, growth1, growth2, r31, rA0
    mul f1, r24
    add rA0, r0
    ldi rA1, 0
    adc rA1, r1
    mul_add f1, r30, growth1, growth2, r31, rA0, rA1
    mul_add f1, r25, growth2, rA0, r31, rA1
    sbrs f1, 7
    rjmp 1f
    subi growth2, LN2_0
    sbci rA0, LN2_1
    sbci rA1, LN2_2
1:  cpi k, 21
    brsh 2f
    subi growth1, lo8(SMALL_SHIFT >> 8)
    sbci growth2, hi8(SMALL_SHIFT >> 8)
    sbci rA0, 0
    sbci rA1, 0
    subi rA0, 128
    ldi zero, 0
    mov r30, k
    subi r30, -3 * COLUMNS
    ldi r31, REDUCTION
    lpm r25, Z
    mov r30, rA1
    muls growth3, growth3
    lsr r1
    add growth2, r1
    adc growth3, zero
    brvc 1f
    inc r30             // from the next node it is 256 units less
1:  XJMP .Lsmall
2:  ldi f0, 8
    mulsu f1, f0
    sbc r24, r24
    sub growth0, r0
    sbc growth1, r1
    sbc growth2, r24
    sbc rA0, r24
    sbc rA1, r24
    subi growth0, lo8(LARGE_SHIFT)
    sbci growth1, hi8(LARGE_SHIFT)
    sbci growth2, hlo8(LARGE_SHIFT)
    sbci rA0, 0
    sbci rA1, 0
    subi rA0, 128
    ldi zero, 0
    mulsu growth3, growth1
    sbc r25, r25
    mov r24, r1
    muls growth3, growth3
    movw r30, r0
    mulsu growth3, growth2
    add r0, r24
    adc r1, r25
    mov r19, r1
    lsl r19
    sbc r19, r19
    ldi r25, 0
    XJMP .Lgrow
    ENDFUNC fixedpoint_exp2_q16_16_unsaturated
#endif
