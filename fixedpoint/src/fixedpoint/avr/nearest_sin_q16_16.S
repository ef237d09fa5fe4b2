// SPDX-License-Identifier: MIT
// int32_t fixedpoint_sin_q16_16_correctly_rounded(int32_t angle)
// int32_t fixedpoint_cos_q16_16_correctly_rounded(int32_t angle)
// Sine and cosine of a Q16.16 angle in radians, for every input; within 0.5 ulp.
//
// In       angle = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    5 bytes
// Table    3072 bytes, fixedpoint_sine_32_table
//
// Argument reduction: the angle times 2/pi 2^48, rounded downward, is the angle in quarter turns,
// of which 32 fraction bits count. Byte k of that is the sum of all a_i m_j with i + j = k + 4; of
// those below only the upper bytes are included. The upper byte of an angle within +-256 rad is a
// sign extension. In odd quadrants the position runs backwards (one's complement); in quadrants 2
// and 3 the result is negated. The angle is kept on the stack for the code that decides close
// cases.
//
// Error in units of 2^-31: the 32-bit core (cubic_core_32.inc); the turns, at most 5.1 units of
// 2^-32 too small, 4.0.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include <fixedpoint/portable/doubt.hpp>
#include "cubic_32.inc"
#include "cubic_core_32.inc"

// The function of kernel/nearest.hpp that decides close cases, under its mangled name.
#define DECIDED_SINE _ZN10fixedpoint6kernel12decided_sineIlLi16EEET_S2_h

// Bytes of 2/pi 2^48.
#define M0 0x44
#define M1 0x4e
#define M2 0x6e
#define M3 0x83
#define M4 0xf9
#define M5 0xa2
// The turns; the upper byte is the quadrant.
#define turns0 r18
#define turns1 r19
#define turns2 r20
#define turns3 r30
#define turns4 r31

    .macro subtract_from_turns byte0, byte1, byte2, byte3, byte4
    subi turns0, \byte0
    sbci turns1, \byte1
    sbci turns2, \byte2
    sbci turns3, \byte3
    sbci turns4, \byte4
    .endm
    .macro add_to_turns byte0, byte1, byte2, byte3, byte4
    add turns0, \byte0
    adc turns1, \byte1
    adc turns2, \byte2
    adc turns3, \byte3
    adc turns4, \byte4
    .endm

    SECTION fixedpoint_sin_q16_16_correctly_rounded
    ENTRY fixedpoint_cos_q16_16_correctly_rounded
    ldi turns4, 1
    rjmp .Lreduce
    ENDFUNC fixedpoint_cos_q16_16_correctly_rounded

    // The products of the upper byte, in every second column.
.Lfar:
    ldi r27, M1
    mul r25, r27
    movw r22, r0
    ldi r27, M3
    mul r25, r27
    movw r26, r0
    ldi r24, M5
    mul r25, r24
    add_to_turns r22, r23, r26, r27, r0
    ldi r24, M0
    mul r25, r24
    mov r24, r1
    ldi r27, M2
    mul r25, r27
    movw r22, r0
    ldi r27, M4
    mul r25, r27
    add_to_turns r24, r22, r23, r0, r1
    sbrc r25, 7
    rjmp .Lbelow
    rjmp .Lreduced
.Lbelow:
    subtract_from_turns M0, M1, M2, M3, M4
    rjmp .Lreduced

    ENTRY fixedpoint_sin_q16_16_correctly_rounded
    ldi turns4, 0
.Lreduce:
    push_all r22, r23, r24, r25, turns4
    clr zero
    ldi r27, M4
    mul r22, r27
    movw turns0, r0
    ldi r30, M2
    mul_add_upper r23, r30, turns0, zero, turns1
    ldi r20, M1
    mul_add_upper r24, r20, turns0, zero, turns1
    ldi r26, M3
    mul_add_upper r22, r26, turns0, zero, turns1    // at most 0xf8 + 3
    mul_add r23, r26, turns0, turns1
    ldi turns2, 0
    adc turns2, zero
    mul_add r24, r30, turns0, turns1, zero, turns2
    mul_add r24, r26, turns1, turns2                // at most 2 + 0x82 + 1
    ldi turns3, 0
    mul_add r23, r27, turns1, turns2, zero, turns3
    ldi r26, M5
    mul_add r22, r26, turns1, turns2, zero, turns3
    mul_add r23, r26, turns2, turns3                // at most 2 + 0xa1 + 1
    mul_add r24, r27, turns2, turns3, zero, turns4
    mul_add r24, r26, turns3, turns4
    tst r25
    breq .Lreduced
    cpi r25, 0xff
    breq 1f
    rjmp .Lfar
1:  subtract_from_turns M1, M2, M3, M4, M5          // the lower bytes minus 2^24
.Lreduced:
    bst turns4, 1
    lsr turns4
    brcc 1f
    com_bytes turns0, 3
    com turns3
1:  find_record fixedpoint_sine_32_table, r22
    cubic_32
    subi_bytes r22, -((1 << 14) + FIXEDPOINT_DOUBT), 4
    lsl r23
    breq .Lalmost_a_tie
    rol r24
    rol r25
    movw r22, r24
    ldi r24, 0
    ldi r25, 0
    rol r24
.Lrounded:
    clr r1
    pop_all r0, r0, r0, r0, r0
    brts 1f
    ret
1:  negate_bytes r22, 3
    sbc r25, r25
    ret

.Lalmost_a_tie:
    rol r24
    rol r25
    ldi r26, 0
    rol r26
    cpi r22, 2 * FIXEDPOINT_DOUBT
    movw r22, r24
    mov r24, r26
    ldi r25, 0
    brsh .Lrounded
    clr r1
    pop_all r20, r25, r24, r23, r22
    XJMP DECIDED_SINE
    ENDFUNC fixedpoint_sin_q16_16_correctly_rounded
#endif
