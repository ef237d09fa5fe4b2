// SPDX-License-Identifier: MIT
// int16_t fixedpoint_reciprocal_sqrt_q8_8(int16_t a)
// 1 / sqrt(a) within 0.5164 ulp (exact); the largest number if a = 0, 0 if a < 0.
//
// In:       a r25:r24
// Out:      r25:r24
// Clobbers: r0, r18, r19, r22, r30, r31
// Stack:    0 bytes.
//
// a is shifted left by a byte and then by pairs of bits, until its leading one is in bit 14 or 15:
// 4^j a. Linear interpolation in the table of reciprocal_sqrt_q8_8.py, with 32 intervals for either
// bit, gives 2^8 / 2^j times the result. portable/reciprocal_sqrt_q8_8.hpp is the same, bit for
// bit.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "reciprocal_root_q8_8.inc"

#define a0 r24
#define a1 r25
#define power r22
#define value0 r18
#define value1 r19

    FUNCTION fixedpoint_reciprocal_sqrt_q8_8
    ldi power, 1
    tst a1
    brmi .Lnegative
    brne .Lpairs
    ldi power, 16
    mov a1, a0
    clr a0
    tst a1
    breq .Lzero
.Lpairs:
    cpi a1, 64
    brsh .Lmoved
.Lpair:
    lsl power
    lsl a0
    rol a1
    lsl a0
    rol a1
    cpi a1, 64
    brlo .Lpair
.Lmoved:
    reciprocal_root value1, value0, a1, a0
    mul value1, power
    movw r24, r0
    mul value0, power
    lsl r0
    adc r24, r1
    clr r1
    adc r25, r1
    ret

.Lzero:
    ldi r24, 0xff
    ldi r25, 0x7f
    ret
.Lnegative:
    clr r24
    clr r25
    ret
    ENDFUNC fixedpoint_reciprocal_sqrt_q8_8

#endif
