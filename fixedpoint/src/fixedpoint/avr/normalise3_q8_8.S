// SPDX-License-Identifier: MIT
// void fixedpoint_normalise3_q8_8(const int16_t* v, int16_t* unit)
// unit[i] = v[i] 2^8 / length of v, within 0.66 ulp; a zero vector stays zero. unit may be v.
//
// In:       v r25:r24, unit r23:r22, in RAM
// Clobbers: r0, r18..r27, r30, r31
// Stack:    2 bytes.
//
// All magnitudes c are shifted left by the same number of bits, until the largest has its leading
// one in bit 14 (-2^15 counts as 2^15 - 1). The three are multiplied by a 13-bit reciprocal root of
// the upper 16 bits of the sum of their squares, which are at least 2^14, and the signs are
// restored. portable/normalise_q8_8.hpp is the same, bit for bit.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "reciprocal_root_q8_8.inc"

#define x0 r18
#define x1 r19
#define y0 r20
#define y1 r21
#define z0 r22
#define z1 r23
#define s1 r24
#define s2 r25
#define s3 r26
#define signs r27
#define power r30
#define zero r31
#define root0 r24
#define root1 r26
#define below r25

    // high:low = |next component|, at most 2^15 - 1; its sign becomes the lowest bit of r30.
    .macro load_magnitude low, high
    ld \low, X+
    ld \high, X+
    mov r0, \high
    lsl r0
    rol r30
    tst \high
    brpl 1f
    com \high
    neg \low
    sbci \high, 0xff
    brpl 1f
    com \low
    com \high
1:
    .endm

    .macro move_up_7_bits low, high
    mov \high, \low
    clr \low
    lsr \high
    ror \low
    .endm

    .macro scale low, high
    mul \high, power
    mov \high, r0
    mul \low, power
    mov \low, r0
    or \high, r1
    .endm

    // s3:s2:s1 += (high:low)^2 / 2^8
    .macro add_square low, high
    mul_add_upper \low, \low, s1, zero, s2, s3
    mul \low, \high
    lsl r0
    rol r1
    add s1, r0
    adc s2, r1
    adc s3, zero
    mul_add \high, \high, s2, s3
    .endm

    FUNCTION fixedpoint_normalise3_q8_8
    push r28
    push r29
    movw r26, r24
    movw r28, r22
    clr r30
    load_magnitude x0, x1
    load_magnitude y0, y1
    load_magnitude z0, z1
    // sss10000: the 1 marks the end of the signs.
    mov signs, r30
    swap signs
    lsl signs
    ori signs, 0x10

.Lbits:
    mov r30, x1
    or r30, y1
    or r30, z1
    brne 1f
    or r30, x0
    or r30, y0
    or r30, z0
    brne 2f
    rjmp .Lcomponent
2:  move_up_7_bits x0, x1
    move_up_7_bits y0, y1
    move_up_7_bits z0, z1
    rjmp .Lbits
1:  ldi r31, hi8(fixedpoint_long_division_table)
    lpm power, Z
    lsr power
    scale x0, x1
    scale y0, y1
    scale z0, z1
    clr zero
    clr_bytes s1, 3
    add_square x0, x1
    add_square y0, y1
    add_square z0, z1

    // 2^28 / length, or 2^27 / length where the sum is below 2^30: twice or four times the root.
    clt
    cpi s3, 0x40
    brsh 2f
    set
    lsl_bytes s1, 3
    lsl_bytes s1, 3
2:  reciprocal_root root1, root0, s3, s2
    lsl root0
    rol root1
    brtc .Lcomponent
    lsl root0
    rol root1

    // r31:r30 = (x root + 2^20) / 2^16, in units of 2^-5.
.Lcomponent:
    mul x1, root1
    movw r30, r0
    mul x1, root0
    mov below, r0
    add r30, r1
    brcc 1f
    inc r31
1:  mul x0, root1
    add below, r0
    adc r30, r1
    brcc 1f
    inc r31
1:  subi r30, -0x10
    sbci r31, -1
    lsl r30
    rol r31
    lsl r30
    rol r31
    lsl r30
    rol r31
    clr r30
    rol r30
    lsl signs
    brcc 1f
    com r30
    neg r31
    sbci r30, 0xff
1:  st Y+, r31
    st Y+, r30
    movw x0, y0
    movw y0, z0
    cpi signs, 0x80
    brne .Lcomponent
    clr r1
    pop r29
    pop r28
    ret
    ENDFUNC fixedpoint_normalise3_q8_8

#endif
