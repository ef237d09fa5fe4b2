// SPDX-License-Identifier: MIT
// int32_t fixedpoint_pid_q<32 - F>_<F>(int32_t setpoint, int32_t measurement, void* controller)
// The next output of a controller (blocks/pid.hpp): each product is rounded and saturated, each sum
// saturated. For every 32-bit format.
//
// In       setpoint = r25:r22, measurement = r21:r18, controller = r17:r16: the proportional, integral
//          and derivative gains, the smallest and the largest output, the integral, the last
//          measurement, the carried error plus half an ulp, in the highest F bits of one, two or four
//          bytes, and 1 if there was a measurement, otherwise 0
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    10 to 15 bytes and a call
//
// Formats with 20 to 24 fraction bits have a product of their own: the error times the low three bytes
// of a gain, plus the error times the highest byte, which mostly needs no multiplication. If this, a
// shift or the rounding overflows the 56 bits of the sum, the result is the limit. The bytes of the product
// below an ulp are those of the sum, or computed separately modulo a power of 256.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#define s1 r8
#include "columns_32.inc"

// The error, later what the rounding of the integral loses and carries.
#define error0 r8
#define error2 r10
#define missing_short r8
#define missing_long r16
// The output without the integral; before that, the derivative term.
#define output0 r12
#define output2 r14
// The bytes of the product below an ulp.
#define low0 r26
#define low1 r27
#define low2 r30
#define low3 r31

// The byte above the product, while it has other gains.
#define top r28

#define low_at 12
#define high_at 16
#define integral_at 20
#define measurement_at 24
#define carried_at 28

    .macro low_byte p, q, to
    mul \p, \q
    add \to, r0
    .endm

    // low3:...:low0 = a b modulo 256^bytes. Four bytes need r17.
    .macro low_product bytes
    mul rA0, rB0
    movw low0, r0
    .if \bytes == 2
    low_byte rA0, rB1, low1
    low_byte rA1, rB0, low1
    .elseif \bytes == 3
    mul rA1, rB1
    mov low2, r0
    mul_add rA0, rB1, low1, low2
    mul_add rA1, rB0, low1, low2
    low_byte rA0, rB2, low2
    low_byte rA2, rB0, low2
    .elseif \bytes == 4
    clr r17
    mul rA1, rB1
    movw low2, r0
    mul_add rA0, rB1, low1, low2, r17, low3
    mul_add rA1, rB0, low1, low2, r17, low3
    mul_add rA0, rB2, low2, low3
    mul_add rA2, rB0, low2, low3
    low_byte rA0, rB3, low3
    low_byte rA1, rB2, low3
    low_byte rA2, rB1, low3
    low_byte rA3, rB0, low3
    .endif
    clr r1
    .endm

    // Loads or stores the bytes of the carried error. The lowest of four bytes with 17 to 24 bits is 0.
    .macro each_carried instruction, bytes, c0, c1, c2, c3
    .set place, carried_at
    .if \bytes == 3
    .set place, carried_at + 1
    .endif
    .irp byte, \c0, \c1, \c2, \c3
    .ifnb \byte
    .ifc \instruction, ldd
    ldd \byte, Y + place
    .else
    std Y + place, \byte
    .endif
    .set place, place + 1
    .endif
    .endr
    .endm

    // Adds the part of a product below an ulp to the carried error. `missing` is -1 if that carries,
    // plus 1 if the product alone is rounded up.
    .macro add_low fraction, bytes, missing, c0, c1, c2, c3
    low_product \bytes
    .if \fraction == 0
    clr low0
    .else
    .rept 8 * \bytes - \fraction
    lsl low0
    .if \bytes > 1
    rol low1
    .endif
    .if \bytes > 2
    rol low2
    .endif
    .if \bytes > 3
    rol low3
    .endif
    .endr
    .endif
    each_carried ldd, \bytes, \c0, \c1, \c2, \c3
    add \c0, low0
    .if \bytes > 1
    adc \c1, low1
    .endif
    .if \bytes > 2
    adc \c2, low2
    .endif
    .if \bytes > 3
    adc \c3, low3
    .endif
    sbc \missing, \missing
    .if \bytes == 1
    sbrc low0, 7
    .elseif \bytes == 2
    sbrc low1, 7
    .elseif \bytes == 3
    sbrc low2, 7
    .else
    sbrc low3, 7
    .endif
    inc \missing
    .endm

    // Saturates r25:r22 after a sum that sets V if it wrapped.
    .macro saturate fraction
    brvc 1f
    rcall .Llimit_\fraction
1:
    .endm

    .macro multiply integer, fraction
    .if \fraction == 16
    XCALL fixedpoint_multiply_q16_16_saturating
    .else
    XCALL fixedpoint_multiply_saturating_q\integer\()_\fraction
    .endif
    .endm

    // Sets the registers of the product to the limit opposite to its wrapped sign.
    .macro limit sign, r0, r1, r2
    lsl \sign
    sbc \sign, \sign
    mov \r0, \sign
    mov \r1, \sign
    mov \r2, \sign
    subi \sign, 0x80
    ret
    .endm
    .macro saturate_product fraction
    brvc 1f
    rcall .Lproduct_limit_\fraction
1:
    .endm

    .macro move_product b0, b1, b2, b3
    mov \b0, s3
    mov \b1, s4
    mov \b2, s5
    .ifnc \b3, s6
    mov \b3, s6
    .endif
    .endm

    // s6:...:s3 = a b; a, b, s2 and s1 stay.
    .macro product integer, fraction
.Lproduct_\fraction:
    clr zero
    short_product rB0, rB1, rB2
    tst rB3
    breq 2f
    cpi rB3, 0xff
    breq 1f
    cpi rB3, 1
    brne .Lother_gain_\fraction
    each_of_a add, adc
    brvs .Lproduct_limit_\fraction
    rjmp 2f
1:  each_of_a sub, sbc
    brvs .Lproduct_limit_\fraction
2:  mov r0, s2
    .rept 24 - \fraction
    lsl r0
    rol s3
    rol s4
    rol s5
    rol s6
    brvs .Lproduct_limit_\fraction
    .endr
    lsl r0              // rounds
    adc s3, zero
    adc s4, zero
    adc s5, zero
    adc s6, zero
    brvs .Lproduct_limit_\fraction
    ret
.Lproduct_limit_\fraction:
    limit s6, s3, s4, s5
.Lother_gain_\fraction:
    push r28
    mov top, s6
    lsl top
    sbc top, top
    mulsu rB3, a0
    sbc s5, zero
    sbc s6, zero
    sbc top, zero
    add s3, r0
    adc s4, r1
    adc s5, zero
    adc s6, zero
    adc top, zero
    mulsu rB3, a1
    sbc s6, zero
    sbc top, zero
    add s4, r0
    adc s5, r1
    adc s6, zero
    adc top, zero
    mulsu rB3, a2
    sbc top, zero
    add s5, r0
    adc s6, r1
    adc top, zero
    muls_add rB3, a3, s6, top
    mov r0, s6
    lsl r0
    sbc r0, r0
    cp r0, top          // out of range if they differ
    mov r0, top
    pop r28
    brne 1f
    rjmp 2b
1:  mov s6, r0
    com s6
    rjmp .Lproduct_limit_\fraction
    .endm

    // Limits the output r25:r22 of the integral r21:r18, and stores the state.
    .macro end_pid own, bytes, c0, c1, c2, c3
    ldd_bytes output0, Y + high_at, 4
    cp_bytes output0, rA0, 4
    brlt 2f
    ldd_bytes output0, Y + low_at, 4
    cp_bytes rA0, output0, 4
    brlt 3f
4:  std_bytes Y + integral_at, rB0, 4
    each_carried std, \bytes, \c0, \c1, \c2, \c3
5:
    .if \own
    pop_all r17, r16, r15, r14, r13, r12, r8, r29, r28
    .else
    .if \bytes == 4
    pop r16
    pop r17
    .endif
    pop_all r15, r14, r13, r12, r11, r10, r9, r8, r29, r28
    .endif
    ret
    // At a limit the integral does not move further towards it.
2:  movw rA0, output0
    movw rA2, output2
    ldd_bytes output0, Y + integral_at, 4
    cp_bytes output0, rB0, 4
    brlt 5b
    rjmp 4b
3:  movw rA0, output0
    movw rA2, output2
    ldd_bytes output0, Y + integral_at, 4
    cp_bytes rB0, output0, 4
    brlt 5b
    rjmp 4b
    .endm

    .macro own_pid integer, fraction
    product \integer, \fraction

    ENTRY fixedpoint_pid_q\integer\()_\fraction
    push_all r28, r29, r8, r12, r13, r14, r15, r16, r17
    movw r28, r16
    ldd r26, Y + 32
    sbrs r26, 0
    rcall .Lfirst_\fraction
    sub_bytes rA0, rB0, 4
    saturate \fraction
    movw output0, rA0   // the error
    movw output2, rA2
    movw rA0, rB0
    movw rA2, rB2
    ldd_bytes r26, Y + measurement_at, 2
    ldd_bytes r30, Y + measurement_at + 2, 2
    std_bytes Y + measurement_at, rB0, 4
    sub_bytes rA0, r26, 2
    sbc rA2, r30
    sbc rA3, r31
    saturate \fraction
    movw a2, rA2
    ldd_bytes rB0, Y + 8, 4
    rcall .Lproduct_\fraction
    movw a0, output0
    movw a2, output2
    move_product r12, r13, r14, r15
    ldd_bytes rB0, Y + 0, 4
    rcall .Lproduct_\fraction
    sub s3, r12
    sbc s4, r13
    sbc s5, r14
    sbc s6, r15
    saturate_product \fraction
    move_product r12, r13, r14, r15
    ldd_bytes rB0, Y + 4, 4
    rcall .Lproduct_\fraction

    mul a0, rB0
    .rept 24 - \fraction
    lsl r0
    rol s1
    rol s2
    .endr
    ldd r16, Y + carried_at + 1
    ldd r17, Y + carried_at + 2
    ldd r27, Y + carried_at + 3
    add r16, r0
    adc r17, s1
    adc r27, s2
    sbc rA0, rA0
    sbrc s2, 7          // the product alone is rounded up
    inc rA0
    ldd_bytes rB0, Y + integral_at, 4
    add s3, rB0
    adc s4, rB1
    adc s5, rB2
    adc s6, rB3
    saturate_product \fraction
    tst rA0
    breq 3f
    mov r0, rA0
    lsl r0
    sbc r0, r0
    sub s3, rA0
    sbc s4, r0
    sbc s5, r0
    sbc s6, r0
    saturate_product \fraction
3:  move_product rB0, rB1, rB2, rB3
    add s3, r12
    adc s4, r13
    adc s5, r14
    adc s6, r15
    saturate_product \fraction
    move_product rA0, rA1, rA2, s6
    clr r1
    end_pid 1, 3, r16, r17, r27
    .endm

    .macro pid integer, fraction, bytes, started_at, missing, c0, c1, c2, c3
    SECTION fixedpoint_pid_q\integer\()_\fraction
    // The limit opposite to the wrapped sign.
.Llimit_\fraction:
    limit rA3, rA0, rA1, rA2

    // The first measurement has no derivative.
.Lfirst_\fraction:
    std_bytes Y + measurement_at, rB0, 4
    ldi r26, 1
    std Y + \started_at, r26
    ret

    .if \fraction >= 20 && \fraction <= 24
    own_pid \integer, \fraction
    .else
    ENTRY fixedpoint_pid_q\integer\()_\fraction
    push_all r28, r29, r8, r9, r10, r11, r12, r13, r14, r15
    movw r28, r16
    .if \bytes == 4
    push r17
    push r16
    .endif
    ldd r26, Y + \started_at
    sbrs r26, 0
    rcall .Lfirst_\fraction
    sub_bytes rA0, rB0, 4
    saturate \fraction
    movw error0, rA0
    movw error2, rA2
    movw rA0, rB0
    movw rA2, rB2
    ldd_bytes output0, Y + measurement_at, 4
    std_bytes Y + measurement_at, rB0, 4
    sub_bytes rA0, output0, 4
    saturate \fraction
    ldd_bytes rB0, Y + 8, 4
    multiply \integer, \fraction
    movw output0, rA0
    movw output2, rA2
    movw rA0, error0
    movw rA2, error2
    ldd_bytes rB0, Y + 0, 4
    multiply \integer, \fraction
    sub_bytes rA0, output0, 4
    saturate \fraction
    movw output0, rA0
    movw output2, rA2

    movw rA0, error0
    movw rA2, error2
    ldd_bytes rB0, Y + 4, 4
    add_low \fraction, \bytes, \missing, \c0, \c1, \c2, \c3
    multiply \integer, \fraction
    ldd_bytes rB0, Y + integral_at, 4
    add_bytes rA0, rB0, 4
    saturate \fraction
    mov r26, \missing
    lsl r26
    sbc r26, r26
    sub rA0, \missing
    sbc_each rA1, r26, 3
    saturate \fraction
    movw rB0, rA0
    movw rB2, rA2
    add_bytes rA0, output0, 4
    saturate \fraction
    end_pid 0, \bytes, \c0, \c1, \c2, \c3
    .endif
    ENDFUNC fixedpoint_pid_q\integer\()_\fraction
    .endm

    .macro kernels integer, fraction
    .if \fraction <= 8
    pid \integer, \fraction, 1, 29, missing_short, r10
    .elseif \fraction <= 16
    pid \integer, \fraction, 2, 30, missing_short, r10, r11
    .elseif \fraction <= 24
    pid \integer, \fraction, 3, 32, missing_short, r9, r10, r11
    .else
    pid \integer, \fraction, 4, 32, missing_long, r8, r9, r10, r11
    .endif
    .endm

#include "splits_32.inc"
    kernels 16, 16

#endif
