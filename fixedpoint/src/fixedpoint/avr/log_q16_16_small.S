// SPDX-License-Identifier: MIT
// int32_t fixedpoint_log_q16_16_small(int32_t a)
// ln a in Q16.16, within 0.74 ulp for every a > 0; the smallest number where a <= 0.
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Table    96 bytes, fixedpoint_log_small_table
//
// a is shifted left until its leading one leaves, and with every bit ln 2 is subtracted from
// 16 ln 2, in units of 2^-24. What is left of a is the fraction of a number from 1 to 2, of which
// parabola_small.S adds the logarithm.
//
// Error in ulp: parabola 0.2, ln 2 rounded 0.002. Rounding 0.5. The worst of all inputs is 0.73933,
// at 1126989248.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

// 2^24 ln 2
#define LN2 11629080
#define START (16 * LN2)

#define sum0 r18
#define sum1 r19
#define sum2 r20
#define sum3 r21

    SECTION fixedpoint_log_q16_16_small
.Lnone:
    ldi_bytes r22, 0x80000000, 4
    ret

    ENTRY fixedpoint_log_q16_16_small
    tst r25
    brmi .Lnone
    ldi_bytes sum0, START, 4
.Lbyte:
    tst r25
    brne .Lbit
    mov_from_top r23, r22, 3
    mov r22, r1
    subi_bytes sum0, (8 * LN2), 4
    brpl .Lbyte
    tst r25             // the lowest byte
    breq .Lnone
.Lbit:
    subi_bytes sum0, LN2, 4
    lsl_bytes r22, 4
    brcc .Lbit

    ldi r30, lo8(fixedpoint_log_small_table)
    ldi r31, hi8(fixedpoint_log_small_table)
    XCALL fixedpoint_parabola_small
    mov_bytes r22, sum1, 3
    lsl sum3
    sbc r25, r25
    clr r1
    ret
    ENDFUNC fixedpoint_log_q16_16_small
#endif
