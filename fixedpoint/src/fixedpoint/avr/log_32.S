// SPDX-License-Identifier: MIT
// int32_t fixedpoint_log_q<32 - F>_<F>(int32_t a)
// ln a for every a > 0 in every 32-bit format except Q16.16, which has a smaller kernel of its own;
// within 0.55 ulp, saturated; the smallest number if a <= 0.
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Table    3456 bytes, fixedpoint_log_32_table
//
// Up to F = 24 the sum is formed in units of 2^-31 with the 32-bit core (cubic_core_32.inc), beyond
// that in units of 2^-39. The constant -F ln 2 includes half an ulp for rounding, and a unit for
// the truncation in the core.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "cubic_32.inc"
#include "log_32.inc"

    .macro kernels integer, fraction
    position_of_logarithm fixedpoint_log_q\integer\()_\fraction, \fraction
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
    XCALL fixedpoint_cubic_32
    add_multiple_of_ln2
    add_constant 22, (1 << (30 - \fraction)) + 1 - (\fraction * 381061692393 >> 8)
    clr r1
    .endif
    shift_signed (31 - \fraction)
    ret
    ENDFUNC fixedpoint_log_q\integer\()_\fraction
    .endm

#include "splits_32.inc"

#endif
