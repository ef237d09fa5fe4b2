// SPDX-License-Identifier: MIT
#ifdef __AVR__
#include <fixedpoint/avr/sum_of_squares.inc>

    .section .text.fixedpoint_length2_q16_16, "ax", @progbits
    .global fixedpoint_length2_q16_16
    .type fixedpoint_length2_q16_16, @function
fixedpoint_length2_q16_16:
    movw r30, r24
    load_magnitude 0, .Llong
    first_square .Llong
    load_magnitude 4, .Llong
    add_square .Llong
    jmp fixedpoint_length_root
.Llong:
    ldi r26, 2
    jmp fixedpoint_length_long
    .size fixedpoint_length2_q16_16, . - fixedpoint_length2_q16_16
#endif
