// SPDX-License-Identifier: MIT
// The last step of 32-bit functions whose results have an exponent. Not C functions: a kernel jumps
// here to return.
//
// fixedpoint_scale_40      r25:r22 = r27:r23 2^(r19 - 48) rounded to nearest, saturated; r19 from 7 to
//                          41, r27:r23 at most about 2^39
// fixedpoint_largest_32    r25:r22 = 2^31 - 1
// fixedpoint_smallest_32   r25:r22 = -2^31
// fixedpoint_zero_32       r25:r22 = 0
//
// Changes  r0, r19..r27; r1 is 0 again at return

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "scale_40.inc"

    SECTION fixedpoint_scale_40
    ENTRY fixedpoint_scale_40
    scale
    lsl r21
    adc_each r22, r1, 4
    brmi fixedpoint_largest_32
    ret
    ENDFUNC fixedpoint_scale_40

    ENTRY fixedpoint_largest_32
    ldi r22, 0xff
    ldi r23, 0xff
    movw r24, r22
    lsr r25
    ret
    ENDFUNC fixedpoint_largest_32

    ENTRY fixedpoint_smallest_32
    ldi_bytes r22, 0x80000000, 4
    ret
    ENDFUNC fixedpoint_smallest_32

    ENTRY fixedpoint_zero_32
    ldi r22, 0
    ldi r23, 0
    movw r24, r22
    ret
    ENDFUNC fixedpoint_zero_32
#endif
