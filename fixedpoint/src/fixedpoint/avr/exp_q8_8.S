// SPDX-License-Identifier: MIT
// int16_t fixedpoint_exp_q8_8(int16_t a)
// e^a in Q8.8 within 0.519 ulp (exact bound); the largest number from ln 128 on.
//
// In:       a r25:r24
// Out:      r25:r24
// Clobbers: r0, r18..r23, r26, r27, r30, r31
// Stack:    0 bytes.
//
// Counted from -1600, the upper bits of a are a node and the lower six the distance j from it. The
// table has the power at the node in units of 2^-7 ulp, to which its product with the growth
//
//     e^(j/256) - 1 = 2^-17 (512 j + j (j + 5) + more)
//
// is added; `more` is a byte of the table. exp_q8_8.py chooses the numbers, and exp_q8_8.hpp is the
// same, bit for bit. Products are formed down to the upper byte of those below 2^-8 ulp.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define NEGATED_FIRST 1600
#define LIMIT 1243
#define NODES 45

#define distance r18
#define node r25
#define power0 r19
#define power1 r20
#define power2 r21
#define growth0 r22
#define growth1 r23
#define result_1 r27
#define result0 r24
#define result1 r25
#define zero r26

    FUNCTION fixedpoint_exp_q8_8
    subi r24, lo8(-(NEGATED_FIRST))
    sbci r25, hi8(-(NEGATED_FIRST))
    ldi r18, hi8(LIMIT + NEGATED_FIRST)
    cpi r24, lo8(LIMIT + NEGATED_FIRST)
    cpc r25, r18
    brsh .Lout_of_range
    mov distance, r24
    andi distance, 63
    lsl r24
    rol r25
    lsl r24
    rol node

    ldi r30, 3
    mul node, r30
    movw r30, r0
    subi r30, lo8(-(fixedpoint_exp_q8_8_table))
    sbci r31, hi8(-(fixedpoint_exp_q8_8_table))
    lpm power0, Z+
    lpm power1, Z+
    lpm power2, Z
    mov r30, distance
    ldi r31, 0
    subi r30, lo8(-(fixedpoint_exp_q8_8_table + 3 * NODES))
    sbci r31, hi8(-(fixedpoint_exp_q8_8_table + 3 * NODES))
    lpm growth0, Z
    mov growth1, distance
    subi distance, -5
    mul growth1, distance
    lsl growth1
    add growth0, r0
    adc growth1, r1

    clr zero
    mul power1, growth0
    mov result_1, r1
    mul power2, growth1
    movw result0, r0
    mul_add_upper power0, growth1, result_1, zero, result0, result1
    mul_add power2, growth0, result_1, result0, zero, result1
    mul_add power1, growth1, result_1, result0, zero, result1
    clr r1
    lsl_bytes power0, 3
    add result_1, power0
    adc result0, power1
    adc result1, power2
    lsl result_1
    adc result0, r1
    adc result1, r1
    ret

.Lout_of_range:
    // Zero if a is negative, that is, at least -2^15.
    ldi r18, hi8(0x8000 + NEGATED_FIRST)
    cpi r24, lo8(0x8000 + NEGATED_FIRST)
    cpc r25, r18
    sbc r24, r24
    sbc r25, r25
    lsr r25
    ret
    ENDFUNC fixedpoint_exp_q8_8

#endif
