// SPDX-License-Identifier: MIT
// int64_t fixedpoint_lerp_q32_32(int64_t a, int64_t b, int64_t t)
// a + t (b - a) rounded to nearest, modulo 2^64.
//
// In       a = r25:r18, b = r17:r10, t on the stack
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    10 bytes and those of multiply_q32_32
//
// If b - a wraps, T is set and the product is off by t 2^32.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define SPL 0x3d
#define SPH 0x3e
#define SREG 0x3f
// The offset of t from Y: ten saved bytes and the return address are in between.
#ifdef __AVR_3_BYTE_PC__
#define T0 14
#else
#define T0 13
#endif

    FUNCTION fixedpoint_lerp_q32_32
    push_all r28, r29, r25, r24, r23, r22, r21, r20, r19, r18
    in r28, SPL
    in r29, SPH
    sub_bytes r10, r18, 8
    in r0, SREG
    bst r0, 3           // the overflow of signed numbers
    ldd_bytes r18, Y + T0, 8
    XCALL fixedpoint_multiply_q32_32
    brtc 2f
    ldd r26, Y + T0 + 0
    ldd r27, Y + T0 + 1
    ldd r30, Y + T0 + 2
    ldd r31, Y + T0 + 3
    sbrs r17, 7
    rjmp 1f
    add r22, r26
    adc r23, r27
    adc r24, r30
    adc r25, r31
    rjmp 2f
1:  sub r22, r26
    sbc r23, r27
    sbc r24, r30
    sbc r25, r31
2:  ldd r0, Y + 1
    add r18, r0
    ldd r0, Y + 2
    adc r19, r0
    ldd r0, Y + 3
    adc r20, r0
    ldd r0, Y + 4
    adc r21, r0
    ldd r0, Y + 5
    adc r22, r0
    ldd r0, Y + 6
    adc r23, r0
    ldd r0, Y + 7
    adc r24, r0
    ldd r0, Y + 8
    adc r25, r0
    // b again
    pop r0
    add r10, r0
    pop r0
    adc r11, r0
    pop r0
    adc r12, r0
    pop r0
    adc r13, r0
    pop r0
    adc r14, r0
    pop r0
    adc r15, r0
    pop r0
    adc r16, r0
    pop r0
    adc r17, r0
    pop r29
    pop r28
    ret
    ENDFUNC fixedpoint_lerp_q32_32
#endif
