// SPDX-License-Identifier: MIT
// int64_t fixedpoint_lerp_q32_32(int64_t a, int64_t b, int64_t t)
// a + t (b - a) rounded to nearest, modulo 2^64.
//
// In       a = r25:r18, b = r17:r10, t on the stack
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    8 bytes and those of multiply_q32_32
//
// If b - a wraps, the product is off by t 2^32. Both the result and b need a again. Each of its
// bytes is popped once, five of them, then three, which is as many as there are registers for: the
// first carry of the result is in r1 while that of b is in use.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define SPL 0x3d
#define SPH 0x3e
// The offset of t from Z: eight saved bytes and the return address are in between.
#ifdef __AVR_3_BYTE_PC__
#define T0 12
#else
#define T0 11
#endif

    FUNCTION fixedpoint_lerp_q32_32
    push_all r25, r24, r23, r22, r21, r20, r19, r18
    in r30, SPL
    in r31, SPH
    sub_bytes r10, r18, 8
    ldd_bytes r18, Z + T0, 8
    brvs .Lwrapped
    XCALL fixedpoint_multiply_q32_32
.Lsum:
    pop_all r26, r27, r30, r31, r0
    add r18, r26
    adc r19, r27
    adc r20, r30
    adc r21, r31
    adc r22, r0
    rol r1
    add r10, r26
    adc r11, r27
    adc r12, r30
    adc r13, r31
    adc r14, r0
    pop_all r26, r27, r30
    adc r15, r26
    adc r16, r27
    adc r17, r30
    lsr r1              // 0 again
    adc r23, r26
    adc r24, r27
    adc r25, r30
    ret

.Lwrapped:
    XCALL fixedpoint_multiply_q32_32
    in r30, SPL
    in r31, SPH
    ldd_bytes r26, Z + T0, 2
    ldd r0, Z + T0 + 2
    ldd r30, Z + T0 + 3
    sbrs r17, 7
    rjmp 1f
    add r22, r26
    adc r23, r27
    adc r24, r0
    adc r25, r30
    rjmp .Lsum
1:  sub r22, r26
    sbc r23, r27
    sbc r24, r0
    sbc r25, r30
    rjmp .Lsum
    ENDFUNC fixedpoint_lerp_q32_32
#endif
