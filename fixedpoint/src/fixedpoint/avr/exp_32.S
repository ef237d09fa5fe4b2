// SPDX-License-Identifier: MIT
// int32_t fixedpoint_exp_q<32 - F>_<F>(int32_t a)
// e^a in every 32-bit format except Q16.16, which has a smaller kernel of its own; within 0.7 ulp,
// of results below 2^30 within 0.6 ulp; saturated to the largest number.
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    4 bytes
// Table    2496 bytes, fixedpoint_exp_32_table
//
// Argument reduction: a = k ln 2 - r with 0 <= r < 0.79. k comes from the upper bytes of a, with
// 185/128 = 1.4453 for 1/ln 2 and a constant that covers the error of that; r has 40 fraction bits.
// 1 - e^-r is the function of the table; the 40-bit core is within 0.2 units of 2^-31, and the
// lowest byte of r is interpolated with the slope. scale_40.S shifts the mantissa e^-r into place.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "exp_32.inc"

// Bytes of r, the lowest first.
#define rest0 r26
#define rest1 r18
#define rest2 r19
#define rest3 r20
#define rest4 r30

    // Branches if r25:r22 >= limit, or if it is less.
    .macro branch_to_limit branch, limit, target
    .set limit_bytes, \limit
    cpi r22, limit_bytes & 0xff
    ldi r18, (limit_bytes >> 8) & 0xff
    cpc r23, r18
    ldi r18, (limit_bytes >> 16) & 0xff
    cpc r24, r18
    ldi r18, (limit_bytes >> 24) & 0xff
    cpc r25, r18
    \branch \target
    .endm

    // r25:r21 = r25:r22 2^(32 - fraction); r25 is the signed integer part, and r21 matters only
    // beyond 24 fraction bits.
    .macro align fraction
    .set bytes_up, (35 - \fraction) / 8 - 1
    .if \fraction == 3     // whose numbers, up to 155, do not fit a signed byte
    .set bytes_up, 2
    .endif
    .set bits_up, 24 - \fraction - 8 * bytes_up
    .if bytes_up == 3
    mov r25, r22
    ldi r24, 0
    ldi r23, 0
    ldi r22, 0
    .elseif bytes_up == 2
    mov r25, r23
    mov r24, r22
    ldi r23, 0
    ldi r22, 0
    .elseif bytes_up == 1
    mov_from_top r23, r22, 3
    ldi r22, 0
    .elseif bytes_up == -1
    mov_bytes r21, r22, 4
    lsl r25
    sbc r25, r25
    .elseif \fraction > 24
    ldi r21, 0
    .endif
    .if bits_up > 0
    .rept bits_up
    .if \fraction > 24
    lsl r21
    rol r22
    .else
    lsl r22
    .endif
    rol_bytes r23, 3
    .endr
    .elseif bits_up < 0
    .rept -bits_up
    asr_bytes r22, 4
    .if \fraction > 24
    ror r21
    .endif
    .endr
    .endif
    .endm

    SECTION fixedpoint_exp_32
    // r27 = k + F + 9
    ENTRY fixedpoint_exp_32
    exponential
    XJMP fixedpoint_scale_40
    ENDFUNC fixedpoint_exp_32

    .macro kernels integer, fraction
    FUNCTION fixedpoint_exp_q\integer\()_\fraction
    .if \fraction < 24
    branch_to_limit brge, (((31 - \fraction) * LN2 >> (40 - \fraction)) + 1), 1f
    branch_to_limit brge, (-((\fraction + 2) * LN2 >> (40 - \fraction))), 3f
    .else
    // Decided by the upper byte: a multiple of it lies between 31 and 32 octaves, and between -F -
    // 4 and -F - 2.
    .if \fraction < 32
    cpi r25, ((31 - \fraction) * LN2 + (1 << (64 - \fraction)) - 1) >> (64 - \fraction)
    .else
    cpi r25, 0
    .endif
    brge 1f
    .if \fraction < 27
    cpi r25, lo8(-((\fraction + 3) * LN2 >> (64 - \fraction)))
    brge 3f
    .else
    rjmp 3f
    .endif
    .endif
    XJMP fixedpoint_zero_32
1:  XJMP fixedpoint_largest_32
3:  align \fraction
    ldi r27, 185
    mul r24, r27
    mov r30, r1
    clr r31
    subi r25, -24
    mul_add r25, r27, r30, r31
    .set constant, 24 * 185 - 128 * (\fraction + 10) - 9
    subi r30, constant & 0xff
    sbci r31, (constant >> 8) & 0xff
    lsl r30
    rol r31
    mov r27, r31
    multiple_of_ln2 (\fraction + 9), rest0, rest1, rest2, rest3, rest4
    .if \fraction > 24
    sub rest1, r21
    sbc rest2, r22
    .else
    sub rest2, r22
    .endif
    sbc rest3, r23
    sbc rest4, r24
    XJMP fixedpoint_exp_32
    ENDFUNC fixedpoint_exp_q\integer\()_\fraction
    .endm

#include "splits_32.inc"

#endif
