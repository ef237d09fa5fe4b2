// SPDX-License-Identifier: MIT
// int32_t fixedpoint_sin_q<32 - F>_<F>(int32_t angle)
// int32_t fixedpoint_cos_q<32 - F>_<F>(int32_t angle)
// Sine and cosine of an angle in radians in every 32-bit format except Q16.16, for every input;
// within 0.56 ulp up to F = 24 and 0.75 ulp beyond, in [-1, 1], saturated if the format cannot
// represent 1.
//
// void fixedpoint_sincos_q<32 - F>_<F>(int32_t angle, int32_t* sine_and_cosine)
// Both, bit for bit as above: one argument reduction, two evaluations.
//
// int32_t fixedpoint_sine_of_quarter_turns_q<32 - F>_<F>(uint64_t turns)
// The sine of turns / 2^40 quarter turns, whose low 42 bits count; as above, but without the error
// of the reduction.
//
// In       angle = r25:r22; sine_and_cosine = r21:r20
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Table    3072 bytes, fixedpoint_sine_32_table
//
// Argument reduction: the angle times 2/pi 2^(32 - F) is the angle in quarter turns, of which 32
// fraction bits count, or 40 from F = 25 on. Column by column: byte k of the product is the sum of
// all a_i m_j with i + j = k + 4. Of the column below the lowest one only the upper bytes are
// included, and 2 units compensate for the mean of that truncation. If F is below 16, the lowest
// bytes do not matter and are left zero. In odd quadrants the position runs backwards (one's
// complement); in quadrants 2 and 3 the result is negated.
//
// Error in units of 2^-31: up to F = 24, where an ulp is 128 or more, the 32-bit core
// (cubic_core_32.inc) and the quarter turns 1.6; beyond, the 40-bit core 0.22, and the lowest byte
// of the turns times the slope of the sine 0.02. Rounding 0.5 ulp.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "cubic_32.inc"

#define quadrant r31

    // The turns are in r26 (column -1), r20:r18 (2..0), r31:r30 (4, 3).
    .macro locate column
    .set place, 18 + \column - 9 * (\column > 2) - 9 * (\column < 0)
    .endm
    .macro to_column operation, column, source
    .if \column < 5
    locate (\column)
    \operation place, \source
    .endif
    .endm

    // a_i m_j, i + j = column + 4, m_j in r27; a = r25:r22.
    .macro product i, column
    .set bits, 8 * (\column - \i - first_column_of_multiplier)
    .if bits >= 0 && bits < 64
    .set byte, (multiplier >> bits) & 0xff
    .if byte
    .if byte != loaded
    ldi r27, byte
    .set loaded, byte
    .endif
    mul 22 + \i, r27
    .if \column < first_column
    to_column add, first_column, r1
    to_column adc, (first_column + 1), zero
    .else
    to_column add, \column, r0
    to_column adc, (\column + 1), r1
    to_column adc, (\column + 2), zero
    .endif
    .endif
    .endif
    .endm
    .macro products column
    product 1, \column  // with the byte that the column below ends with
    product 3, \column
    product 2, \column
    product 0, \column
    .endm

    .macro quarter_turns fraction
    .if \fraction > 24
    .set first_column, -1
    .set first_column_of_multiplier, -5
    .set multiplier, 0x517cc1b727220a94 >> (\fraction - 9)
    .else
    .set first_column, -(\fraction < 16) - (\fraction < 9)    // true is -1
    .set first_column_of_multiplier, -4
    .if \fraction == 0
    .set multiplier, 0xa2f9836e4e441529
    .else
    .set multiplier, 0x517cc1b727220a94 >> (\fraction - 1)
    .endif
    .endif
    .set loaded, -1
    clr zero
    .set column, -1
    .rept 5
    .if column == first_column
    to_column ldi, column, 2
    .elseif column >= 0 || first_column < 0
    to_column ldi, column, 0
    .endif
    .set column, column + 1
    .endr
    .set column, first_column - 1
    .rept 6 - first_column
    products column
    .set column, column + 1
    .endr
    sbrs r25, 7
    rjmp 1f
    // A negative angle is its unsigned value minus 2^32.
    .set borrow, 0
    .set column, first_column
    .rept 5 - first_column
    .set byte, (multiplier >> (8 * (column - 4 - first_column_of_multiplier))) & 0xff
    .if borrow
    to_column sbci, column, byte
    .else
    to_column subi, column, byte
    .set borrow, 1
    .endif
    .set column, column + 1
    .endr
1:
    .endm

    .macro kernels integer, fraction
    SECTION fixedpoint_sin_q\integer\()_\fraction
    ENTRY fixedpoint_cos_q\integer\()_\fraction
    ldi quadrant, 1
    rjmp .Lreduce_\fraction
    ENDFUNC fixedpoint_cos_q\integer\()_\fraction

    ENTRY fixedpoint_sin_q\integer\()_\fraction
    ldi quadrant, 0
.Lreduce_\fraction:
    quarter_turns \fraction
.Levaluate_\fraction:
    bst quadrant, 1
    lsr quadrant
    brcc 1f
    com_bytes r18, 3
    com r30
    .if \fraction > 24
    com r26
    .endif
1:
    .if \fraction > 24
    push r26
    find_record fixedpoint_sine_32_table, r22
    XCALL fixedpoint_cubic_40
    pop r0
    mul r22, r0
    add r23, r1
    adc_each r24, zero, 4
    shift_and_round (39 - \fraction), 23, 0
    .else
    find_record fixedpoint_sine_32_table, r22
    XCALL fixedpoint_cubic_32
    mov r26, zero
    shift_and_round (31 - \fraction), 22, 8
    .endif
    clr r1
    .if \fraction > 30
    sbrc r25, 7
    rjmp 3f
    .endif
    brts 2f
    ret
2:  negate_bytes r22, 4
    ret
    .if \fraction > 30
3:  ldi r22, 0xff
    ldi r23, 0xff
    movw r24, r22
    lsr r25
    brtc 4f             // for radians, only cosines are that large
    com r25
    com r24
    com r23
    com r22
4:  ret
    .endif
    ENDFUNC fixedpoint_sin_q\integer\()_\fraction

    FUNCTION fixedpoint_sincos_q\integer\()_\fraction
    push r28
    push r29
    movw r28, r20
    ldi quadrant, 0
    quarter_turns \fraction
    push_all r18, r19, r20, r26, r30, r31
    XCALL .Levaluate_\fraction
    std_bytes Y + 0, r22, 4
    pop_all r31, r30, r26, r20, r19, r18
    inc quadrant
    XCALL .Levaluate_\fraction
    std_bytes Y + 4, r22, 4
    pop r29
    pop r28
    ret
    ENDFUNC fixedpoint_sincos_q\integer\()_\fraction

    // In a section of its own, so that programs with sines of radians do not include it.
    FUNCTION fixedpoint_sine_of_quarter_turns_q\integer\()_\fraction
    movw r30, r22
    mov r26, r18
    mov_bytes r18, r19, 3
    clr zero
    XJMP .Levaluate_\fraction
    ENDFUNC fixedpoint_sine_of_quarter_turns_q\integer\()_\fraction
    .endm

#include "splits_32.inc"

#endif
