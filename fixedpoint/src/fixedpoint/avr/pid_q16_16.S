// SPDX-License-Identifier: MIT
// int32_t fixedpoint_pid_q16_16(int32_t setpoint, int32_t measurement, void* controller)
// The next output of a controller (blocks/pid.hpp). Each product is rounded and saturated, and each
// sum is saturated.
//
// In       setpoint = r25:r22, measurement = r21:r18, controller = r17:r16: the proportional, integral and
//          derivative gains, the smallest and the largest output, the integral, the last measurement,
//          the carried error with half an ulp added, in two bytes, and 1 once there was a measurement, else 0
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    10 bytes and a call

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

// The error, later the rounding error and the carry of the integral.
#define error0 r8
#define error2 r10
#define missing r8
#define carried r10
// The output without the integral, before that the derivative's share.
#define output0 r12
#define output2 r14

#define low_at 12
#define high_at 16
#define integral_at 20
#define measurement_at 24
#define carried_at 28
#define started_at 30

    // r25:r22 after a sum that sets V if it wrapped.
    .macro saturate
    brvc 1f
    rcall .Llimit
1:
    .endm

    SECTION fixedpoint_pid_q16_16
    // The limit opposite to the wrapped sign.
.Llimit:
    lsl rA3
    sbc rA3, rA3
    mov rA0, rA3
    mov rA1, rA3
    mov rA2, rA3
    subi rA3, 0x80
    ret

    // For the first measurement the derivative is 0.
.Lfirst:
    std_bytes Y + measurement_at, rB0, 4
    ldi r26, 1
    std Y + started_at, r26
    ret

    ENTRY fixedpoint_pid_q16_16
    push_all r28, r29, r8, r9, r10, r11, r12, r13, r14, r15
    movw r28, r16
    ldd r26, Y + started_at
    sbrs r26, 0
    rcall .Lfirst
    sub_bytes rA0, rB0, 4
    saturate
    movw error0, rA0
    movw error2, rA2
    movw rA0, rB0
    movw rA2, rB2
    ldd_bytes output0, Y + measurement_at, 4
    std_bytes Y + measurement_at, rB0, 4
    sub_bytes rA0, output0, 4
    saturate
    ldd_bytes rB0, Y + 8, 4
    XCALL fixedpoint_multiply_q16_16_saturating
    movw output0, rA0
    movw output2, rA2
    movw rA0, error0
    movw rA2, error2
    ldd_bytes rB0, Y + 0, 4
    XCALL fixedpoint_multiply_q16_16_saturating
    sub_bytes rA0, output0, 4
    saturate
    movw output0, rA0
    movw output2, rA2

    movw rA0, error0
    movw rA2, error2
    ldd_bytes rB0, Y + 4, 4
    mul rA0, rB0        // the bytes of the product below an ulp
    movw r26, r0
    mul rA0, rB1
    add r27, r0
    mul rA1, rB0
    add r27, r0
    clr r1
    ldd carried, Y + carried_at
    ldd r11, Y + carried_at + 1
    add carried, r26
    adc r11, r27
    sbc missing, missing
    sbrc r27, 7         // the product alone is rounded up
    inc missing
    XCALL fixedpoint_multiply_q16_16_saturating
    ldd_bytes rB0, Y + integral_at, 4
    add_bytes rA0, rB0, 4
    saturate
    mov r26, missing
    lsl r26
    sbc r26, r26
    sub rA0, missing
    sbc_each rA1, r26, 3
    saturate
    movw rB0, rA0
    movw rB2, rA2
    add_bytes rA0, output0, 4
    saturate

    ldd_bytes output0, Y + high_at, 4
    cp_bytes output0, rA0, 4
    brlt 2f
    ldd_bytes output0, Y + low_at, 4
    cp_bytes rA0, output0, 4
    brlt 3f
4:  std_bytes Y + integral_at, rB0, 4
    std_bytes Y + carried_at, carried, 2
5:  pop_all r15, r14, r13, r12, r11, r10, r9, r8, r29, r28
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
    ENDFUNC fixedpoint_pid_q16_16

#endif
