// SPDX-License-Identifier: MIT
// int32_t fixedpoint_log_q16_16(int32_t a)
// ln a in Q16.16, within 0.57 ulp for every a > 0; the smallest number if a <= 0.
//
// In       a = r25:r22
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
//
// The leading byte of the raw number looks up its base-2 logarithm. With the number of bytes below
// it, that selects a record of five bytes: the power of two that moves the leading one to bit 7,
// and ln 2 (e - 16) in units of 2^-24. The 8 bits after the leading one are the interval of the
// table, and the next 16 bits are its fraction.
//
// Error in ulp: chord 0.0625; table entries and truncated low bytes 0.004. Rounding 0.5. The
// largest error over all inputs is 0.56635, at 67372032.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "normalise_positive_q16_16.inc"

#define slope1 r19
#define slope0 r27
#define rise0 r30
#define rise1 r31
// The result in units of 2^-24; bytes 1..3 replace the argument.
#define sum0 r26
#define sum1 r22
#define sum2 r23
#define sum3 r24

#include "rise_q16_16.inc"

    SECTION fixedpoint_log_q16_16

// The factor that normalises the leading byte; Z then points to the logarithm of the exponent.
    .macro find_record leading, bytes_below
    mov r30, \leading
    lsr r30
    ldi r31, hi8(fixedpoint_log_table + 0x500)
    lpm r30, Z
    subi r30, lo8(-(128 + 40 * \bytes_below))
    sbci r31, hi8(-(128 + 40 * \bytes_below))
    lpm factor, Z+
    .endm

    ENTRY fixedpoint_log_q16_16
    normalise_positive find_record
    lpm sum0, Z+
    lpm sum1, Z+
    lpm sum2, Z+
    lpm sum3, Z
    lsl fraction0
    rol fraction1
    rol interval
    mov r30, interval
    ldi r31, hi8(fixedpoint_log_table)
    lpm r0, Z
    add sum0, r0
    inc r31
    lpm r0, Z
    adc sum1, r0
    inc r31
    lpm r0, Z
    adc sum2, r0
    adc sum3, zero
    inc r31
    lpm_pages slope1, slope0
    find_rise
    add sum0, rise0
    adc sum1, rise1
    adc sum2, zero
    adc sum3, zero
    clr r1
    sbrc sum3, 7
    com r25
    ret
    ENDFUNC fixedpoint_log_q16_16
#endif
