// SPDX-License-Identifier: MIT
// int32_t fixedpoint_length3_q16_16(const int32_t* v);
//
// The integer nearest to the root of the sum of the squares of v[0] .. v[2], at most 2^31 - 1.
//
// v in r25:r24, the result in r25:r24:r23:r22. Changes r18-r27, r30, r31, r0; r1 is zero at entry
// and return.
//
// Technique. The squares of components below 2^23 sum to less than 2^48, which fits in six
// registers, and length_root.S takes the root. From the first larger component on length_long.S
// takes over, with the sum so far and the number of remaining components in r28.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#include <fixedpoint/avr/sum_of_squares.inc>

    FUNCTION fixedpoint_length3_q16_16
    movw r30, r24
    load_magnitude .Llong_first
    first_square
    load_magnitude .Llong_second
    add_square
    load_magnitude .Llong_third
    add_square last
    XJMP fixedpoint_length_root
.Llong_first:
    push r28
    ldi r28, 3
    clr r18
    clr r19
    movw r20, r18
    movw r22, r18
    XJMP fixedpoint_length_long
.Llong_second:
    push r28
    ldi r28, 2
    XJMP fixedpoint_length_long
.Llong_third:
    push r28
    ldi r28, 1
    XJMP fixedpoint_length_long
    ENDFUNC fixedpoint_length3_q16_16
#endif
