// SPDX-License-Identifier: MIT
// int64_t fixedpoint_length2_q32_32(const int64_t* v)
// int64_t fixedpoint_length3_q32_32(const int64_t* v)
// The integer nearest to the root of the sum of the squares of 2 or 3 components, at most 2^63 - 1.
//
// int64_t fixedpoint_sqrt_64(int64_t a, uint8_t fraction)
// The integer nearest to the root of 2^fraction a (there are no ties); 0 if a < 0. fraction must be
// below 64.
//
// In       v = r25:r24, in RAM; a = r25:r18, fraction = r16
// Out      r25:r18
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    23 bytes
// Table    768 bytes, fixedpoint_sqrt_table; 256 bytes, fixedpoint_long_division_table
//
// Squares. Row k of |v_i| = a7:...:a0 is a_k 2^(8 k) (a_k 2^(8 k) + twice the bytes above k), from
// row 7 downward, while the bytes above k are doubled one by one. The even products of a row are
// adjacent, and so are the odd ones: each set is added to the sum in one carry chain.
//
// Root. As in sqrt_q32_32.S, for a number A of 16 bytes that is shifted left by pairs of bytes, by
// one byte and by an even number of bits until its highest byte is 64 or more. Each pair of bytes
// saves one of the eight bytes of the root. Its first two bytes come from the table, each further
// one from a step of long division. The root is shifted right again by half as many bits, and the
// last bit shifted out rounds; if there would be none, one more byte is computed. From 2^126 on the
// result saturates, so there is a byte for that, and the lowest bit of A is 0, which the halving of
// the remainder drops.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

// The component, then the root, the highest byte first.
#define x0 r25
#define x1 r24
#define x2 r23
#define x3 r22
#define x5 r20
#define x7 r18
#define inverse r28
#define digits r29
#define half r30
#define zero r31
#define power r27

#include "long_root.inc"

    // An instruction on byte `byte` of the sum, r2 + byte, unless it is outside.
    .macro into operation, byte, value
    .if (\byte >= 0) && (\byte < 16)
    \operation 2 + \byte, \value
    .endif
    .endm

    // Adjacent products of `digit` and up to four bytes to bytes `byte`.. of the sum.
    .macro chain byte, digit, p0, p1, p2, p3
    .ifnb \p3
    mul \p3, \digit
    movw r30, r0
    .endif
    .ifnb \p2
    mul \p2, \digit
    movw r28, r0
    .endif
    .ifnb \p1
    mul \p1, \digit
    movw r26, r0
    .endif
    mul \p0, \digit
    into add, (\byte), r0
    into adc, (\byte + 1), r1
    .ifnb \p1
    into adc, (\byte + 2), r26
    into adc, (\byte + 3), r27
    .endif
    .ifnb \p2
    into adc, (\byte + 4), r28
    into adc, (\byte + 5), r29
    .endif
    .ifnb \p3
    into adc, (\byte + 6), r30
    into adc, (\byte + 7), r31
    carry (\byte + 8)
    .else
    .ifnb \p2
    carry (\byte + 6)
    .else
    .ifnb \p1
    carry (\byte + 4)
    .else
    carry (\byte + 2)
    .endif
    .endif
    .endif
    .endm
    // The carry into bytes `byte`..15.
    .macro carry byte
    clr r1
    .irp i, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15
    .if \i >= \byte
    into adc, \i, r1
    .endif
    .endr
    .endm
    // Doubles a byte into the doubled one above it.
    .macro double byte, above
    lsl \byte
    clr r1
    adc \above, r1
    .endm

    // The borrow into bytes `from` to `to`.
    .macro borrow from, to
    .irp i, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13
    .if (\i >= \from) && (\i <= \to)
    into sbc, \i, zero
    .endif
    .endr
    .endm

    // The root's byte x_m, r25 - m, from the remainder's highest bytes u2:u1:u0; u2 is byte 15 - m.
    // Subtracts the products of the digit with the bytes x_2.. of the root, and half its square. If
    // that is too much, the digit is decremented, and 2^8 x + digit - 1/2 is added back. The last
    // digit needs one more byte below the lowest, r0. Branches to .Ldone after the last digit.
    .macro step m, u2, u1, u0
    estimate \u2, \u1, \u0
    .irp n, 18, 19, 20, 21, 22, 23
    .if 25 - \n < \m
    mul digit, r\n
    into sub, (\n - 11 - \m), r0
    into sbc, (\n - 10 - \m), r1
    borrow (\n - 9 - \m), (15 - \m)
    .endif
    .endr
    half_square
    .if \m < 7
    into sub, (13 - 2 * \m), half
    .else
    cp zero, half
    .endif
    into sbc, (14 - 2 * \m), r0
    into sbc, (15 - 2 * \m), r1
    borrow (16 - 2 * \m), (15 - \m)
    brpl 7f
    .if \m == 7
    mov r0, half
    .endif
6:  dec digit
    ldi half, 0x80
    .if \m < 7
    into add, (13 - 2 * \m), half
    .else
    add r0, half
    .endif
    into adc, (14 - 2 * \m), digit
    .irp n, 18, 19, 20, 21, 22, 23, 24, 25
    .if 25 - \n < \m
    into adc, (\n - 11 - \m), r\n
    .endif
    .endr
    into adc, (15 - \m), zero
    brmi 6b
7:
    .irp n, 18, 19, 20, 21, 22, 23
    .if 25 - \n == \m
    mov r\n, digit
    .endif
    .endr
    .if \m < 7
    dec digits
    brne 8f
    rjmp .Ldone
8:
    .endif
    .endm

    .macro pair_up
    movw_from_top r4, r2, 14
    clr r2
    clr r3
    .endm

    SECTION fixedpoint_length_q32_32
    ENTRY fixedpoint_length2_q32_32
    ldi r26, 2
    rjmp 1f
    ENDFUNC fixedpoint_length2_q32_32

    ENTRY fixedpoint_length3_q32_32
    ldi r26, 3
1:
    push_all r2, r3, r4, r5, r6, r7, r8, r9, r10, r11, r12, r13, r14, r15, r16, r17, r28, r29
    clr r2
    clr r3
    movw_each r4, r2, 14
    movw r30, r24
.Lcomponent:
    ld_each r18, Z+, 8
    push_all r26, r30, r31
    tst r25
    brpl 1f
    com_bytes r19, 7
    neg r18
    sbci_each r19, 0xff, 7
    brpl 1f
    pop_all r31, r30, r26
    XJMP .Lsaturate
1:  chain 14, r25, r25
    lsl r25
    chain 12, r24, r24
    chain 13, r24, r25
    double r24, r25
    chain 10, r23, r23, r25
    chain 11, r23, r24
    double r23, r24
    chain 8, r22, r22, r24
    chain 9, r22, r23, r25
    double r22, r23
    chain 6, r21, r21, r23, r25
    chain 7, r21, r22, r24
    double r21, r22
    chain 4, r20, r20, r22, r24
    chain 5, r20, r21, r23, r25
    double r20, r21
    chain 2, r19, r19, r21, r23, r25
    chain 3, r19, r20, r22, r24
    double r19, r20
    chain 0, r18, r18, r20, r22, r24
    chain 1, r18, r19, r21, r23, r25
    pop_all r31, r30, r26
    dec r26
    breq 1f
    rjmp .Lcomponent
1:  XJMP fixedpoint_root_128
    ENDFUNC fixedpoint_length3_q32_32

    // 2^fraction a, shifted by bits, by a byte and by pairs of bytes
    FUNCTION fixedpoint_sqrt_64
    push_all r2, r3, r4, r5, r6, r7, r8, r9, r10, r11, r12, r13, r14, r15, r16, r17, r28, r29
    mov r26, r16
    clr r10
    clr r11
    movw_each r12, r10, 6
    tst r25
    brpl 1f
    movw_each r18, r10, 8
1:  movw_bytes r2, r18, 8
    mov r27, r26
    andi r27, 7
    breq 2f
1:  lsl_bytes r2, 9
    dec r27
    brne 1b
2:  sbrs r26, 3
    rjmp 1f
    mov_from_top r3, r2, 9
    clr r2
1:  swap r26
    andi r26, 3
    breq 2f
1:  pair_up
    dec r26
    brne 1b
2:  XJMP fixedpoint_root_128
    ENDFUNC fixedpoint_sqrt_64

    // The root of the sum; returns for its caller.
    FUNCTION fixedpoint_root_128
    ldi r26, 8
    cpi r17, 0x40
    brsh .Lsaturate
    // Shifted left by a pair of bytes
1:  mov r0, r17
    or r0, r16
    brne 2f
    pair_up
    dec r26
    brne 1b
    clr r18
    clr r19
    movw_each r20, r18, 6
    rjmp .Lrestore
.Lsaturate:
    ldi r18, 0xff
    ldi r19, 0xff
    movw_each r20, r18, 6
    andi r25, 0x7f
.Lrestore:
    pop_all r29, r28, r17, r16, r15, r14, r13, r12, r11, r10, r9, r8, r7, r6, r5, r4, r3, r2
    clr r1
    ret
2:  clr r31
    tst r17
    brne 3f
    mov_from_top r3, r2, 15
    clr r2
    ldi r31, 1
    // `power` moves the leading one to bit 7 or 6; r30 undoes that, and a shift by half a byte.
3:  ldi r30, 1
    cpi r17, 64
    brsh .Lscaled
    ldi power, 4
    ldi r30, 0x80
    cpi r17, 16
    brsh 4f
    ldi power, 16
    ldi r30, 0x40
    cpi r17, 4
    brsh 4f
    ldi power, 64
    ldi r30, 0x20
4:  mul r17, power
    mov r17, r0
    mul_or_bytes r2, power, r2, 15
.Lscaled:
    sbrc r31, 0
    swap r30
    push r30
    push r26
    // No bit is shifted out: one more byte rounds.
    cpi r30, 1
    brne 1f
    inc r26
1:
    // x0:x1 = the root of r17:r16, at most 3 too small for r17..r14
    clr digits
    mov r30, r17
    ldi r31, hi8(fixedpoint_sqrt_table)
    lpm_pages x1, x0, r0
    mul_add_upper r0, r16, x1, digits, x0
    mul x1, x1
    sub r14, r0
    sbc r15, r1
    sbc r16, digits
    mul x0, x0
    sub r16, r0
    mul x0, x1
    sub r15, r0
    sbc r16, r1
    sub r15, r0
    sbc r16, r1
    // Halved, with what follows.
    lsr_bytes r2, 15
    ldi half, 0x80
    rjmp 2f
1:  adiw x1, 1
2:  sub r13, half
    sbc r14, x1
    sbc r15, x0
    sbc r16, digits
    brcc 1b
    add r13, half
    adc r14, x1
    adc r15, x0
    invert inverse, x0, x1
    clr x2
    clr x3
    movw x5, x3
    movw x7, x3
    clr zero
    mov digits, r26
    subi digits, 3
    brsh 1f
    rjmp .Ldone
1:  inc digits
    step 2, r15, r14, r13
    step 3, r14, r13, r12
    step 4, r13, r12, r11
    step 5, r12, r11, r10
    step 6, r11, r10, r9
    step 7, r10, r9, r8

    // Shifted right by whole bytes, and by bits; r27 = the last bits shifted out.
.Ldone:
    pop r26
    pop r30
    clr r27
1:  cpi r26, 8
    breq 2f
    mov r27, r18
    mov_bytes r18, r19, 7
    clr r25
    inc r26
    rjmp 1b
2:  cpi r30, 1
    breq 3f
    mul r18, r30
    mov r27, r0
    mov r18, r1
    mul r19, r30
    or r18, r0
    mov r19, r1
    mul r20, r30
    or r19, r0
    mov r20, r1
    mul r21, r30
    or r20, r0
    mov r21, r1
    mul r22, r30
    or r21, r0
    mov r22, r1
    mul r23, r30
    or r22, r0
    mov r23, r1
    mul r24, r30
    or r23, r0
    mov r24, r1
    mul r25, r30
    or r24, r0
    mov r25, r1
3:  lsl r27
    adc_each r18, zero, 8
    brpl 4f
    rjmp .Lsaturate
4:  rjmp .Lrestore
    ENDFUNC fixedpoint_root_128

#endif
