// SPDX-License-Identifier: MIT
// int64_t fixedpoint_dot_64(const int64_t* a, const int64_t* b, uint8_t n, uint8_t fraction)
// int64_t fixedpoint_multiply_64(int64_t a, int64_t b, uint8_t fraction)
// floor(sum a_i b_i / 2^fraction + 1/2) modulo 2^64 over n components, or of one product: one
// rounding. n must be in 1..3 and fraction below 64.
//
// In       a = r25:r24, b = r23:r22, in RAM, n = r20, fraction = r18;
//          a = r25:r18, b = r17:r10, fraction = r8
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    43 bytes
//
// Row by row: each takes one byte of all b_i and leaves one byte of the exact sum on the stack. The
// even products of a byte are adjacent, and so are the odd ones: each set is added to the sum in
// one carry chain. The products are unsigned: if a_i is negative, they are 2^64 b_i too large, and
// likewise for b_i; at the end, this excess is subtracted from bytes 8 and up. The sum of a row is
// below 2^80.
//
// The result is in nine bytes of the sum, shifted right by at most seven bits. The last bit shifted
// out rounds; if none is, the rounding bit is the highest of the byte below, and below byte 0 it is
// 0. A single product uses the saved registers of b and a copy of a as vectors.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define rows r7
#define components r6
#define digit r30
#define left r31

    .macro clear_sum
    clr r8
    clr r9
    movw_each r10, r8, 8
    .endm

    // Adjacent products with every second byte at Y, from byte n on.
    .macro products n
    ldd r18, Y + \n
    mul r18, digit
    movw r18, r0
    ldd r20, Y + \n + 2
    mul r20, digit
    movw r20, r0
    ldd r22, Y + \n + 4
    mul r22, digit
    movw r22, r0
    ldd r24, Y + \n + 6
    mul r24, digit
    movw r24, r0
    clr r1
    .endm

    // Subtracts the number at `pointer` from bytes 8 to 15 of the sum.
    .macro take_off pointer
    ld r0, \pointer
    sub r8, r0
    .irp n, 9, 10, 11, 12, 13, 14, 15
    ldd r0, \pointer + \n - 8
    sbc r\n, r0
    .endr
    .endm

    SECTION fixedpoint_dot_64
    ENTRY fixedpoint_multiply_64
    set
    rjmp 1f
    ENDFUNC fixedpoint_multiply_64

    ENTRY fixedpoint_dot_64
    clt
1:  push r29
    push r28
    push_all r17, r16, r15, r14, r13, r12, r11, r10, r9, r8, r7, r6, r5, r4, r3, r2, r25, r24, r23, r22, r21, r20, r19, r18
    movw r2, r24
    movw r4, r22
    mov components, r20
    brtc 2f
    in r26, 0x3d
    in r27, 0x3e
    adiw r26, 1
    movw r2, r26
    adiw r26, 16
    movw r4, r26
    ldi digit, 1
    mov components, digit
    mov r18, r8
2:  push r18
    clear_sum
    ldi digit, 8
    mov rows, digit
.Lrow:
    movw r28, r2
    movw r26, r4
    mov left, components
.Lcomponent:
    ld digit, X
    adiw r26, 8
    products 0
    add_bytes r8, r18, 8
    adc r16, r1
    adc r17, r1
    products 1
    add_bytes r9, r18, 8
    adc r17, r1
    adiw r28, 8
    dec left
    brne .Lcomponent
    push r8
    mov_bytes r8, r9, 9
    clr r17
    sec
    adc r4, r1
    adc r5, r1
    dec rows
    breq 1f
    rjmp .Lrow
1:  movw r28, r2
    movw r30, r4
    sbiw r30, 8
.Lsigns:
    ldd r18, Y + 7
    sbrs r18, 7
    rjmp 1f
    take_off Z
1:  ldd r18, Z + 7
    sbrs r18, 7
    rjmp 2f
    take_off Y
2:  adiw r28, 8
    adiw r30, 8
    dec components
    brne .Lsigns
    push_all r8, r9, r10, r11, r12, r13, r14, r15
    // The byte below the nine, r0, and those, r27:r25..r18
    in r30, 0x3d
    in r31, 0x3e
    movw r28, r30
    ldd r26, Y + 17
    mov r27, r26
    lsr r27
    lsr r27
    lsr r27
    adiw r30, 18
    sub r30, r27
    sbc r31, r1
    ld r0, -Z
    .irp n, 18, 19, 20, 21, 22, 23, 24, 25, 27
    ld r\n, -Z
    .endr
    lsl r0
    andi r26, 7
    breq 2f
1:  lsr r27
    ror_bytes r18, 8
    dec r26
    brne 1b
2:  adc_each r18, r1, 8
    adiw r28, 25
    in r0, 0x3f
    cli
    out 0x3e, r29
    out 0x3f, r0
    out 0x3d, r28
    pop_all r2, r3, r4, r5, r6, r7, r8, r9, r10, r11, r12, r13, r14, r15, r16, r17, r28, r29
    ret
    ENDFUNC fixedpoint_dot_64

#endif
