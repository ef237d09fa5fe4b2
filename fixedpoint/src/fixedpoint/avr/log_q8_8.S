// SPDX-License-Identifier: MIT
// int16_t fixedpoint_log_q8_8(int16_t a)
// The natural logarithm within 0.522 ulp (exact); the smallest number where a <= 0.
//
// In:       a r25:r24
// Out:      r25:r24
// Clobbers: r0, r18..r23, r30, r31
// Stack:    0 bytes.
//
// a is moved up until its leading one is in bit 15, by four bits at a time, then by single ones. The logarithm of the power of two that is left falls by ln 2 a bit; to it a chord of log_q8_8.py
// is added, which is in whole ulps and in units of 2^-5 ulp. portable/log_q8_8.hpp is the same, bit
// for bit.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

// The logarithm of 2^7, and ln 2, in units of 2^-8 ulp.
#define LOG_128 317983
#define LOG_2 45426

#define a0 r24
#define a1 r25
#define fraction r21
#define log0 r22
#define log1 r23
#define whole r18
#define units r19
#define slope r20

    .macro subtract number
    subi fraction, lo8(\number)
    sbci log0, hi8(\number)
    sbci log1, hlo8(\number)
    .endm

    FUNCTION fixedpoint_log_q8_8
    ldi fraction, lo8(LOG_128)
    ldi log0, hi8(LOG_128)
    ldi log1, hlo8(LOG_128)
    cpi a1, 16
    brlo .Lmove
    tst a1
    brmi .Lno_logarithm
.Lbit:
    subtract LOG_2
    lsl a0
    rol a1
    brpl .Lbit
.Lmoved:
    lsr a1
    ror a0
    mov r30, a1
    andi r30, 0x3f
    ldi r31, hi8(fixedpoint_log_q8_8_table)
    lpm whole, Z
    subi r30, -64
    lpm units, Z
    subi r30, -64
    lpm slope, Z
    mul slope, a0
    add units, r1
    ldi r30, 8
    mul units, r30
    add fraction, r0
    adc whole, r1
    clr r1
    add log0, whole
    adc log1, r1
    movw r24, log0
    ret

.Lmove:
    sbiw r24, 0
    breq .Lno_logarithm
.Lfour_bits:
    subtract (4 * LOG_2)
    swap a1
    swap a0
    eor a1, a0
    andi a0, 0xf0
    eor a1, a0
    cpi a1, 16
    brlo .Lfour_bits
    tst a1
    brmi .Lmoved
    rjmp .Lbit

.Lno_logarithm:
    ldi r24, 0
    ldi r25, 0x80
    ret
    ENDFUNC fixedpoint_log_q8_8

#endif
