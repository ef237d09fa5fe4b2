// SPDX-License-Identifier: MIT
// uint64_t fixedpoint_exp_wide(int64_t x, uint8_t unit)
// e^(x 2^-40) 2^unit in units of 2^-32, with 8 significant fraction bits, for the functions
// composed of powers. unit must be in 0..29. 0 if x 2^-40 is below -24; 2^32 - 1 without a fraction
// from 2^32 on, possibly already from 0.9 2^32 on.
//
// In       x = r25:r18, unit = r16
// Out      r25:r18, of which r20:r18 are 0
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    4 bytes
// Table    2496 bytes, fixedpoint_exp_32_table
//
// x is k ln 2 - r as in exp_32.S: the mantissa e^-r is within 0.2 units of 2^-31.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "exp_32.inc"
#include "scale_40.inc"

// Bytes of r, the lowest first; the middle ones move to r18..r20 when x is used up.
#define rest0 r26
#define rest1 r23
#define rest2 r24
#define rest3 r25
#define rest4 r30
// k + 35, not negative for x from -24 on.
#define k r27
#define OFFSET 35

    SECTION fixedpoint_exp_wide
.Lout_of_range:
    tst r25
    brmi .Lnothing
.Llargest:
    ldi r22, 0xff
    ldi r23, 0xff
    movw r24, r22
    rjmp 1f
.Lnothing:
    ldi r22, 0
    ldi r23, 0
    movw r24, r22
1:  clr r1
    ldi r21, 0
    rjmp .Lno_more_digits

    ENTRY fixedpoint_exp_wide
    mov r27, r23
    lsl r27
    sbc r27, r27
    cp r24, r27
    cpc r25, r27
    brne .Lout_of_range
    cpi r23, 46
    brge .Llargest
    cpi r23, -24
    brlt .Lnothing
    // k + 35 = floor((185 x + 128 36 + 9) / 128), from the upper bytes of x
    ldi r27, 185
    mul r22, r27
    mov r30, r1
    clr r31
    subi r23, -24
    mul_add r23, r27, r30, r31
    .set constant, 24 * 185 - 128 * (OFFSET + 1) - 9
    subi r30, constant & 0xff
    sbci r31, (constant >> 8) & 0xff
    lsl r30
    rol r31
    mov k, r31
    multiple_of_ln2 (OFFSET), rest0, rest1, rest2, rest3, rest4
    sub rest0, r18
    sbc_bytes rest1, r19, 3
    sbc rest4, r22
    add k, r16
    subi k, OFFSET - 9
    brpl 2f
    rjmp .Lnothing
2:  cpi k, 42
    brlt 3f
    rjmp .Llargest
3:
    mov_bytes r18, rest1, 3
    exponential
    scale
.Lno_more_digits:
    ldi r20, 0
    ldi r19, 0
    ldi r18, 0
    ret
    ENDFUNC fixedpoint_exp_wide
#endif
