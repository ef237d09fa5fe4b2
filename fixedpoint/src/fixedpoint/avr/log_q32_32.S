// SPDX-License-Identifier: MIT
// int64_t fixedpoint_log_q32_32(int64_t a)
// ln a for every a > 0, within 0.6 ulp; the smallest number if a <= 0.
//
// fixedpoint_unrounded_log_q32_32 is not a C function: r22:r18, r26 = ln a in units of 2^-39, plus
// 64. Requires T = 1 and a > 0.
//
// In       a = r25:r18
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    4 bytes
// Tables   3706 bytes, fixedpoint_log_64_table; 256 bytes, fixedpoint_leading_one_table
//
// normalise_64 finds the leading one; the 40 bits below it are the position in the table of ln(1 + x).
// The multiples of ln 2 come from a table.
//
// Error in units of 2^-39: the core 8.7, the multiple of ln 2 and the position 1, the rounding 64, half
// an ulp.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "cubic_64.inc"

#define multiples fixedpoint_log_64_table + 0xd00

    SECTION fixedpoint_log_q32_32
.Lnot_positive:
    ldi r18, 0
    ldi r19, 0
    movw r20, r18
    movw r22, r18
    ldi r24, 0
    ldi r25, 0x80
    ret

    ENTRY fixedpoint_log_q32_32
    tst r25
    brmi .Lnot_positive
    clt
    ENTRY fixedpoint_unrounded_log_q32_32
    normalise_64 .Lnot_positive
    push r17
    push r27
    clr zero
    find_record_64 fixedpoint_log_64_table, r26
    XCALL fixedpoint_cubic_64
    pop r30
    ldi r31, 6
    mul r30, r31
    movw r30, r0
    subi r30, lo8(-(multiples))
    sbci r31, hi8(-(multiples))
    lpm r0, Z+
    add r26, r0
    lpm r0, Z+
    adc r18, r0
    lpm r0, Z+
    adc r19, r0
    lpm r0, Z+
    adc r20, r0
    lpm r0, Z+
    adc r21, r0
    lpm r22, Z
    adc r22, zero
    brts 1f
    lsl r26
    rol_bytes r18, 5
    sbc r23, r23
    mov r24, r23
    mov r25, r23
1:  clr r1
    pop r17
    ret
    ENDFUNC fixedpoint_log_q32_32
#endif
