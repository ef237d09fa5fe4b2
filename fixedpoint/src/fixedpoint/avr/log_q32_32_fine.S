// SPDX-License-Identifier: MIT
// int64_t fixedpoint_log_q32_32_fine(int64_t a)
// ln a in units of 2^-39, plus 64, within 11 units. a must be greater than 0.
//
// In       a = r25:r18
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31, T; r1 is 0 again at return
// Stack    6 bytes
// Tables   those of log_q32_32.S

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    FUNCTION fixedpoint_log_q32_32_fine
    set
    XCALL fixedpoint_unrounded_log_q32_32
    mov_from_top r19, r18, 5
    mov r18, r26
    mov r24, r23
    lsl r24
    sbc r24, r24
    mov r25, r24
    ret
    ENDFUNC fixedpoint_log_q32_32_fine
#endif
