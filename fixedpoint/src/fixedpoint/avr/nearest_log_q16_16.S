// SPDX-License-Identifier: MIT
// int32_t fixedpoint_log_q16_16_correctly_rounded(int32_t a)
// ln a of Q16.16 within 0.5 ulp; the smallest number if a <= 0.
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Table    3456 bytes, fixedpoint_log_32_table
//
// As in log_32.S. If the core leaves the rounding undecided, a is reassembled from its parts.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include <fixedpoint/portable/doubt.hpp>
#include "cubic_32.inc"
#include "cubic_core_32.inc"
#include "log_32.inc"

// The function of kernel/nearest.hpp that decides close cases, under its mangled name.
#define DECIDED_LOG _ZN10fixedpoint6kernel11decided_logIlLi16EEET_S2_S2_

    position_of_logarithm fixedpoint_log_q16_16_correctly_rounded, 16
    cubic_32
    movw r0, r30
    add_multiple_of_ln2
    add_constant 22, (1 << 14) + 1 - (16 * 381061692393 >> 8) + FIXEDPOINT_DOUBT
    lsl_bytes r23, 4
    tst r23
    breq 8f
7:  movw r22, r24
    mov r24, r26
    lsl r26
    sbc r25, r25
    clr r1
    ret
8:  cpi r22, 2 * FIXEDPOINT_DOUBT
    brsh 7b
    mov r27, r24        // r26:r31:r27 = the number above the tie
    mov r31, r25
    // r1:r0 = address of the next interval's record, r30 = 7 e + 6: the number is a one followed by
    // the position in the table, shifted right by 32 - e bits.
    movw r22, r0
    subi r22, lo8(fixedpoint_log_32_table + 12)
    sbci r23, hi8(fixedpoint_log_32_table + 12)
    lsr_bytes r22, 2
    lsr_bytes r22, 2
    ldi r25, 171        // 1/3 modulo 256
    mul r22, r25
    mov r25, r0
    clr r1
    movw r22, r18
    mov r24, r20
    sec
    ror_bytes r22, 4
1:  subi r30, -7
    cpi r30, 7 * 25
    brsh 3f
    mov_bytes r22, r23, 3
    clr r25
    subi r30, -7 * 7
    rjmp 1b
2:  lsr_bytes r22, 4
    subi r30, -7
3:  cpi r30, 7 * 32 + 6
    brne 2b
    mov r18, r27
    mov r19, r31
    mov r20, r26
    lsl r26
    sbc r21, r21
    XJMP DECIDED_LOG
    ENDFUNC fixedpoint_log_q16_16_correctly_rounded
#endif
