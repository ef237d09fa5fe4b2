// SPDX-License-Identifier: MIT
// int64_t fixedpoint_copysign_q32_32(int64_t a, int64_t b)
// |a| with the sign of b, where 0 counts as positive.
//
// int64_t fixedpoint_abs_diff_q32_32(int64_t a, int64_t b)
// |a - b|.
//
// Both modulo 2^64. The same for every 64-bit format.
//
// In       a = r25:r18, b = r17:r10
// Out      r25:r18
// Changes  r0

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    SECTION fixedpoint_copysign_q32_32
    ENTRY fixedpoint_copysign_q32_32
    mov r0, r17
    eor r0, r25
    brmi .Lnegate
    ret
    ENDFUNC fixedpoint_copysign_q32_32

    ENTRY fixedpoint_abs_diff_q32_32
    sub_bytes r18, r10, 8
    brlt .Lnegate       // by the exact difference, whose sign is not one of its bits
    ret
.Lnegate:
    negate_bytes r18, 8
    ret
    ENDFUNC fixedpoint_abs_diff_q32_32
#endif
