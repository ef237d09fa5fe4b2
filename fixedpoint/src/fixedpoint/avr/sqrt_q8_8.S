// SPDX-License-Identifier: MIT
// int16_t fixedpoint_sqrt_q8_8(int16_t a)
// The nearest number to the square root of a (there are no ties); 0 if a < 0.
//
// In:       a r25:r24
// Out:      r25:r24
// Clobbers: r0, r18..r20, r22, r23, r30, r31
// Stack:    0 bytes.
//
// The roots of raw numbers below 2^8 are in the table. Above, linear interpolation gives r, which
// is the root or one less (sqrt_q8_8.py ensures that). It is r + 1 if r^2 + r < 2^8 a, that is, if
// r + 1/2 < sqrt(2^8 a): the difference fits in 16 bits, and only these are computed.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define r_0 r22
#define r_1 r23
#define slope r18
#define next r20

    FUNCTION fixedpoint_sqrt_q8_8
    tst r25
    brmi .Lnegative
    breq .Lsmall
    mov next, r24
    mov r30, r25
    cpi r25, 16
    brlo .Lbelow_16

.Lchord:
    ldi r31, hi8(fixedpoint_sqrt_q8_8_table + 256)
    lpm_pages r_0, r_1, slope
    mul slope, next
    mov r19, r_1
    andi r19, 0xf0
    andi r_1, 0x0f
    add r0, r19
    adc r_0, r1
    clr r1
    adc r_1, r1

    // r19 = the high byte of r^2 + r - 2^8 a
    mul r_0, r_0
    movw r18, r0
    add r18, r_0
    adc r19, r_1
    sub r19, r24
    mul r_0, r_1
    lsl r0
    add r19, r0
    clr r1
    movw r24, r_0
    sbrc r19, 7
    adiw r24, 1
    ret

.Lbelow_16:
    andi next, 0x1f
    mov r31, r24
    lsl r31
    rol r30
    lsl r31
    rol r30
    lsl r31
    rol r30
    ori r30, 0x80
    rjmp .Lchord

.Lsmall:
    mov r30, r24
    ldi r31, hi8(fixedpoint_sqrt_q8_8_table)
    lpm r24, Z
    ret

.Lnegative:
    clr r24
    clr r25
    ret
    ENDFUNC fixedpoint_sqrt_q8_8

#endif
