// SPDX-License-Identifier: MIT
// int32_t fixedpoint_log2_q16_16(int32_t a)
// log2 a in Q16.16, within 0.54 ulp for every a > 0; the smallest number if a <= 0.
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
//
// The leading byte of the raw number looks up the integer part of the logarithm, and with that the
// power of two that moves the leading one to bit 7. The normalised byte, 128..255, is the interval
// of the table, and the next 16 bits are its fraction. The height of a parabola above its chord is
// the bend times t (1 - t), for which 8 bits of t are enough. Slopes are stored less 2^15, which is
// added back when the sum is doubled. The largest error over all inputs is 0.53005 ulp, at
// 1132526079.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "normalise_positive_q16_16.inc"

#define bend r27
#define slope1 r19
#define slope0 r18
#define rest r18 // bits of the interval, below the fraction
#define rise0 r30
#define rise1 r31
// The fraction of the result: first in units of 2^-23, then of 2^-24. Its upper bytes and the
// integer part replace the argument.
#define sum0 r26
#define sum1 r22
#define sum2 r23
#define whole r24

#include "rise_q16_16.inc"

    SECTION fixedpoint_log2_q16_16

// The factor that normalises the leading byte; the integer part of the logarithm in r30.
    .macro find_exponent leading, bytes_below
    mov r30, \leading
    lsr r30
    ldi r31, hi8(fixedpoint_log2_table + 0x300)
    lpm r30, Z
    lpm factor, Z
    subi r30, 128 + 16 - 8 * \bytes_below
    .endm

    ENTRY fixedpoint_log2_q16_16
    normalise_positive find_exponent
    mov whole, r30
    mov r30, interval
    // Values are in the upper halves of the pages, slopes and bends in the lower ones.
    ldi r31, hi8(fixedpoint_log2_table)
    lpm_pages sum0, sum1, sum2
    subi r30, 128
    lpm bend, Z
    dec r31
    lpm slope1, Z
    dec r31
    lpm slope0, Z
    find_rise
    mov rest, fraction1
    com rest
    fmul rest, fraction1
    mul_add_upper r1, bend, rise0, zero, rise1
    add sum0, rise0
    adc sum1, rise1
    adc sum2, zero
    lsl sum0
    rol sum1
    rol sum2
    add sum0, fraction0 // the slope's 2^15, doubled
    adc sum1, fraction1
    adc sum2, zero
    adc whole, zero
    clr r1
    sbrc whole, 7
    com r25
    ret
    ENDFUNC fixedpoint_log2_q16_16
#endif
