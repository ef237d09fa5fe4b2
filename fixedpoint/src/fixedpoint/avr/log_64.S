// SPDX-License-Identifier: MIT
// int64_t fixedpoint_log_64(int64_t a, uint8_t fraction)
// 2^fraction ln(a / 2^fraction) for every a > 0, within 0.7 ulp; the smallest number if a <= 0.
// fraction must be in 31..56.
//
// In       a = r25:r18, fraction = r16
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    22 bytes
// Table    2944 bytes, fixedpoint_septic_log_table
//
// The bits after the leading one are the position in the table of ln(1 + x); |e| ln 2 has nine
// bytes, one of them before the point.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"
#include "septic_64.inc"
#include "leading_one.inc"

    SECTION fixedpoint_log_64
.Lnot_positive:
    clr r18
    clr r19
    movw r20, r18
    movw r22, r18
    ldi r24, 0
    ldi r25, 0x80
    ret

    ENTRY fixedpoint_log_64
    mov r0, r18
    .irp n, 19, 20, 21, 22, 23, 24, 25
    or r0, r\n
    .endr
    breq .Lnot_positive
    tst r25
    brmi .Lnot_positive
    save_registers
    mov r29, r16
    ldi r28, 63
    sub r28, r29
    drop_leading_one r28
    evaluate fixedpoint_septic_log_table
    lsl r18
    .irp n, 19, 20, 21, 22, 23, 24, 25
    rol r\n
    .endr
    mov r16, r28
    sbrc r28, 7
    neg r16
    clr r2
    .set j, 0
    .rept 8
    .if j < 4
    ldi r26, (0xd1cf79ac >> (8 * j)) & 0xff
    .else
    ldi r26, (0xb17217f7 >> (8 * (j - 4))) & 0xff
    .endif
    mul r16, r26
    add 2 + j, r0
    clr 3 + j
    adc 3 + j, r1
    .set j, j + 1
    .endr
    clr r17
    sbrc r28, 7
    rjmp 1f
    add r18, r2
    .irp n, 19, 20, 21, 22, 23, 24, 25
    adc \n, \n - 16
    .endr
    adc r17, r10
    rjmp 2f
1:  sub r18, r2
    .irp n, 19, 20, 21, 22, 23, 24, 25
    sbc \n, \n - 16
    .endr
    sbc r17, r10
2:  round_from 64
    restore_registers
    ret
    ENDFUNC fixedpoint_log_64
#endif
