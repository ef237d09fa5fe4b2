// SPDX-License-Identifier: MIT
// uint64_t fixedpoint_byte_fraction(uint64_t a, uint8_t j)
// a j / 256, truncated.
//
// In       a = r25:r18, j = r16
// Out      r25:r18
// Changes  r0, r18..r26; r1 is 0 again at return

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

    FUNCTION fixedpoint_byte_fraction
    clr r26
    mul r18, r16
    mov r18, r1
    .set place, 19
    .rept 7
    mul place, r16
    add place - 1, r0
    mov place, r1
    adc place, r26
    .set place, place + 1
    .endr
    clr r1
    ret
    ENDFUNC fixedpoint_byte_fraction
#endif
