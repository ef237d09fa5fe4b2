// SPDX-License-Identifier: MIT
// int32_t fixedpoint_log_q<32 - F>_<F>(int32_t a)
// ln a for every a > 0 of each split of 32 bits but Q16.16, whose own is smaller; within 0.55 ulp,
// saturated where the format cannot hold it; the smallest number where a <= 0.
//
// int32_t fixedpoint_log_q16_16_correctly_rounded(int32_t a)
// ln a within 0.5 ulp; the smallest number where a <= 0. Where the core leaves a doubt a is put together
// again from its parts.
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Table    3456 bytes, fixedpoint_log_32_table
//
// The leading byte looks up its base-2 logarithm, and with the number of bytes below it that finds a
// record: the power of two that moves the leading one out of the byte, and e ln 2 in units of 2^-39.
// What is left of the number is the position in the table of ln(1 + x). A leading byte of 1 leaves
// whole bytes.
//
// Up to F = 24 the sum is formed in units of 2^-31 by the core of 32 bits (cubic_core_32.inc),
// beyond that in units of 2^-39. The constant -F ln 2 holds half an ulp for the rounding, and a unit
// for what the core cuts.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "cubic_32.inc"
#include "cubic_core_32.inc"

// The function of kernel/nearest.hpp that decides doubts, as the compiler names it.
#define DECIDED_LOG _ZN10fixedpoint6kernel11decided_logIlLi16EEET_S2_

#define records fixedpoint_log_32_table + 0xc00
#define factor r26

    // The factor and the record's address + 1 from the leading byte, 2 or more; r27 keeps the latter.
    .macro find_exponent leading, bytes_below
    mov r30, \leading
    lsr r30
    ldi r31, hi8(records + 0x100)
    lpm r27, Z
    subi r27, -56 * \bytes_below
    ldi r31, hi8(records)
    mov r30, r27
    lpm factor, Z
    .endm

    .macro kernels integer, fraction, variant=
    SECTION fixedpoint_log_q\integer\()_\fraction\variant
.Lone_byte_\fraction:
    cpi r22, 2
    brlo .Lzero_or_one_\fraction
    find_exponent r22, 0
    mul r22, factor
    mov r30, r0
    ldi r20, 0
    ldi r19, 0
    ldi r18, 0
    rjmp .Llook_up_\fraction
.Lzero_or_one_\fraction:
    tst r22
    breq .Lno_logarithm_\fraction
    ldi r27, 0
    ldi r30, 0
    ldi r20, 0
    ldi r19, 0
    ldi r18, 0
    rjmp .Llook_up_\fraction
.Lno_logarithm_\fraction:
    ldi_bytes r22, 0x80000000, 4
    ret
.Lone_leads_four_\fraction:
    ldi r27, 56 * 3
    mov r30, r24
    mov r20, r23
    mov r19, r22
    ldi r18, 0
    rjmp .Llook_up_\fraction
.Lone_leads_three_\fraction:
    ldi r27, 56 * 2
    mov r30, r23
    mov r20, r22
    ldi r19, 0
    ldi r18, 0
    rjmp .Llook_up_\fraction
.Ltwo_bytes_\fraction:
    tst r24
    brne .Lone_leads_three_\fraction
    cpi r23, 2
    brsh .Ltwo_\fraction
    tst r23
    breq .Lone_byte_\fraction
    ldi r27, 56
    mov r30, r22
    ldi r20, 0
    ldi r19, 0
    ldi r18, 0
    rjmp .Llook_up_\fraction
.Ltwo_\fraction:
    find_exponent r23, 1
    mul r23, factor
    mov r30, r0
    mul_or r22, factor, r20, r30
    ldi r19, 0
    ldi r18, 0
    rjmp .Llook_up_\fraction
.Lthree_bytes_\fraction:
    tst r25
    brne .Lone_leads_four_\fraction
    cpi r24, 2
    brlo .Ltwo_bytes_\fraction
    find_exponent r24, 2
    mul r24, factor
    mov r30, r0
    mul_or r23, factor, r20, r30
    mul_or r22, factor, r19, r20
    ldi r18, 0
    rjmp .Llook_up_\fraction

    ENTRY fixedpoint_log_q\integer\()_\fraction\variant
    cpi r25, 2
    brlo .Lthree_bytes_\fraction
    sbrc r25, 7
    rjmp .Lno_logarithm_\fraction
    find_exponent r25, 3
    mul r25, factor
    mov r30, r0
    mul_or r24, factor, r20, r30
    mul_or_bytes r22, factor, r18, 2
.Llook_up_\fraction:
    push r27
    find_record fixedpoint_log_32_table, r26
    clr zero
    .if \fraction > 24
    XCALL fixedpoint_cubic_40
    pop r30
    inc r30
    ldi r31, hi8(records)
    lpm r0, Z+
    add r23, r0
    lpm r0, Z+
    adc r24, r0
    lpm r0, Z+
    adc r25, r0
    lpm r0, Z+
    adc r26, r0
    lpm r0, Z+
    adc r27, r0
    lpm r22, Z
    adc r22, zero
    .set constant, \fraction * 381061692393 - (1 << (38 - \fraction))
    add_constant 23, (1 << (38 - \fraction)) - \fraction * 381061692393
    sbci r22, constant & 0xff
    mov r18, r22
    movw r22, r24
    movw r24, r26
    mov r26, r18
    clr r1
    .if \fraction > 30
    cpi r25, 256 - (1 << (38 - \fraction))
    sbci r18, 0xff
    brge 1f
    rjmp .Lno_logarithm_\fraction
1:
    .elseif \fraction > 26
    cpi r26, lo8(-(1 << (30 - \fraction)))
    brge 1f
    rjmp .Lno_logarithm_\fraction
1:
    .endif
    .else
    .ifb \variant
    XCALL fixedpoint_cubic_32
    .else
    cubic_32
    movw r0, r30
    .endif
    pop r30
    subi r30, -2
    ldi r31, hi8(records)
    lpm r27, Z+
    add r22, r27
    lpm r27, Z+
    adc r23, r27
    lpm r27, Z+
    adc r24, r27
    lpm r27, Z+
    adc r25, r27
    lpm r26, Z
    adc r26, zero
    .set constant_log, (1 << (30 - \fraction)) + 1 - (\fraction * 381061692393 >> 8)
    .ifb \variant
    add_constant 22, constant_log
    clr r1
    .endif
    .endif
    .ifb \variant
    shift_signed (31 - \fraction)
    ret
    .else
    add_constant 22, constant_log + DOUBT
    lsl_bytes r23, 4
    tst r23
    breq 8f
7:  movw r22, r24
    mov r24, r26
    lsl r26
    sbc r25, r25
    clr r1
    ret
8:  cpi r22, 2 * DOUBT
    brsh 7b
    // r1:r0 = address of the next interval's record, r30 = 7 e + 6: the number is the table's position
    // behind a one, shifted right by 32 - e bits.
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
    XJMP DECIDED_LOG
    .weak DECIDED_LOG
    .endif
    ENDFUNC fixedpoint_log_q\integer\()_\fraction\variant
    .endm

#include "splits_32.inc"
    kernels 16, 16, _correctly_rounded

#endif
