// SPDX-License-Identifier: MIT
// int64_t fixedpoint_sin_q32_32(int64_t angle)
// int64_t fixedpoint_cos_q32_32(int64_t angle)
// Sine and cosine of an angle in radians, for every input; within 0.65 ulp, in [-1, 1].
//
// void fixedpoint_sincos_q32_32(int64_t angle, int64_t* sine_and_cosine)
// Both, bit for bit as above: one argument reduction, two evaluations.
//
// int64_t fixedpoint_sine_of_quarter_turns_q32_32(uint64_t turns)
// The sine of turns / 2^40 quarter turns, whose low 42 bits count; as above, but without the error
// of the reduction.
//
// In       angle = r25:r18; sine_and_cosine = r17:r16
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    4 bytes, sincos 14
// Table    3328 bytes, fixedpoint_sine_64_table
//
// Argument reduction: the angle times 2/pi 2^8 is the angle in quarter turns, of which 40 fraction
// bits count. Column by column: byte k of the product is the sum of all a_i m_j with i - j = k,
// where m_0 is the first byte of 2/pi after the point. Of the column below the lowest one only the
// upper bytes are included; 3/4 of a unit for each byte of the angle compensates for the mean of
// that truncation. An angle below 128 rad has five bytes. In odd quadrants the position runs
// backwards (one's complement); in quadrants 2 and 3 the result is negated.
//
// Error in units of 2^-39: the core 11.5, the quarter turns 6 times pi/4, the rounding 64, half an ulp.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "cubic_64.inc"

#define quadrant r31

    // The turns are in r26, r27, r30, r31, r18, r19: when bytes 4 and 5 begin, the lowest two bytes
    // of the angle are no longer needed.
    .macro to_column operation, column, source
    .if \column < 2
    .set place, 26 + \column
    .elseif \column < 4
    .set place, 28 + \column
    .else
    .set place, 14 + \column
    .endif
    .if \column < 6
    \operation place, \source
    .endif
    .endm

    // a_i m_j, i - j = column.
    .macro product column, m
    .set j, i - \column
    .if j != loaded
    .if j < 4
    ldi \m, (0xa2f9836e >> (24 - 8 * j)) & 0xff
    .elseif j < 8
    ldi \m, (0x4e441529 >> (56 - 8 * j)) & 0xff
    .else
    ldi \m, 0xfc
    .endif
    .set loaded, j
    .endif
    mul 18 + i, \m
    .if \column < 0
    add r26, r1
    adc r27, zero
    .else
    to_column add, \column, r0
    to_column adc, (\column + 1), r1
    to_column adc, (\column + 2), zero
    .endif
    .endm

    // The first with the byte of 2/pi that the column below ends with.
    .macro products bytes, column, m
    .set taken, \column + loaded
    .if loaded >= 0 && taken < \bytes
    .set i, taken
    product \column, \m
    .endif
    .set i, \bytes - 1
    .rept \bytes
    .if i >= \column && i != taken
    product \column, \m
    .endif
    .set i, i - 1
    .endr
    .endm

    // The quarter turns of an angle of that many bytes; takes a register for constants.
    .macro quarter_turns bytes, m
    .set loaded, -2
    ldi r26, 4 + \bytes / 8 * 2
    ldi r27, 0
    products \bytes, -1, \m
    .set column, 0
    .rept 6
    to_column ldi, (column + 2), 0
    products \bytes, column, \m
    .set column, column + 1
    .endr
    sbrs 17 + \bytes, 7
    rjmp 1f
    // A negative angle is its unsigned value minus 2^40 or 2^64.
    .if \bytes == 5
    to_column subi, 0, 0x44
    to_column sbci, 1, 0x4e
    to_column sbci, 2, 0x6e
    to_column sbci, 3, 0x83
    to_column sbci, 4, 0xf9
    to_column sbci, 5, 0xa2
    .else
    to_column subi, 0, 0xfc
    to_column sbci, 1, 0x29
    to_column sbci, 2, 0x15
    to_column sbci, 3, 0x44
    to_column sbci, 4, 0x4e
    to_column sbci, 5, 0x6e
    .endif
1:
    .endm

    SECTION fixedpoint_sin_q32_32
    ENTRY fixedpoint_cos_q32_32
    push r17
    clr zero
    XCALL .Lquarter_turns
    inc quadrant
    rjmp .Lsine
    ENDFUNC fixedpoint_cos_q32_32

    ENTRY fixedpoint_sin_q32_32
    push r17
    clr zero
    clt
    rjmp .Lreduce

    // r31:r30, r25:r22 = the quarter turns of r25:r18
.Lquarter_turns:
    set
.Lreduce:
    mov r26, r22
    lsl r26
    sbc r26, r26
    cp_each r23, r26, 3
    breq 1f
    rjmp .Llong
1:  quarter_turns 5, r23
.Lreduced:
    movw r22, r26
    movw r24, r30
    movw r30, r18
    brtc .Lsine
    ret

    // r25:r18 = the sine of quarter turns; pops r17
.Levaluate:
    push r17
.Lsine:
    bst quadrant, 1
    sbrs quadrant, 0
    rjmp 1f
    com_bytes r22, 4
    com r30
1:  find_record_64 fixedpoint_sine_64_table, r26
    XCALL fixedpoint_cubic_64
    clr r22
    lsl r26
    rol_bytes r18, 5
    clr r1
    pop r17
    brtc 2f
    com_bytes r18, 5
    increment_bytes r18, 5
    mov r23, r22
    movw r24, r22
    ret
2:  clr_bytes r23, 3
    ret

.Llong:
    push r16
    quarter_turns 8, r16
    pop r16
    rjmp .Lreduced
    ENDFUNC fixedpoint_sin_q32_32

    FUNCTION fixedpoint_sincos_q32_32
    push_all r28, r29, r17
    movw r28, r16
    clr zero
    XCALL .Lquarter_turns
    push_all r22, r23, r24, r25, r30, r31
    XCALL .Levaluate
    std_bytes Y + 0, r18, 8
    pop_all r31, r30, r25, r24, r23, r22
    inc quadrant
    XCALL .Levaluate
    std_bytes Y + 8, r18, 8
    pop_all r17, r29, r28
    ret
    ENDFUNC fixedpoint_sincos_q32_32

    // In a section of its own, so that programs with sines of radians do not include it.
    FUNCTION fixedpoint_sine_of_quarter_turns_q32_32
    movw r30, r22
    movw r24, r20
    movw r22, r18
    push r17
    clr zero
    XCALL .Levaluate
    pop r17
    ret
    ENDFUNC fixedpoint_sine_of_quarter_turns_q32_32
#endif
