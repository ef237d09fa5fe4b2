// SPDX-License-Identifier: MIT
// Int24 fixedpoint_dot2_q<24 - F>_<F>(const Int24* a, const Int24* b)
// Int24 fixedpoint_dot3_q<24 - F>_<F>(const Int24* a, const Int24* b)
// floor(sum a_i b_i / 2^F + 1/2) modulo 2^24 of 2 or 3 components, one rounding: of every 24-bit
// format.
//
// In       a = r25:r24, b = r23:r22, in RAM
// Out      r24:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    6 bytes
//
// Bytes 0..top = floor((F - 1) / 8) + 3 of the exact sum; the bytes above are not part of the
// result. A sum takes the bytes of b one after the other. The products of a byte of b with the first
// and the last byte of a are adjacent and are added in one carry chain. `mulsu` sets the carry to the
// sign of its product, which is subtracted from the bytes above it.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define s0 r12
#define s1 r13
#define s2 r14
#define s3 r15
#define s4 r16
#define s5 r17
#define a0 r18
#define a1 r19
#define a2 r20
#define digit r21
#define zero r22
#define count r23
#define q0 r24
#define q1 r25

    // Applies to byte `byte` of the sum unless it is above `top`.
    .macro into operation, byte, top, value
    .if \byte <= \top
    \operation 12 + \byte, \value
    .endif
    .endm
    .macro signs byte, top
    into sbc, (\byte), \top, zero
    into sbc, (\byte + 1), \top, zero
    .endm
    // Adds r1:r0, and then zero, to the bytes from `byte` on.
    .macro add_product byte, top
    into add, (\byte), \top, r0
    into adc, (\byte + 1), \top, r1
    into adc, (\byte + 2), \top, zero
    into adc, (\byte + 3), \top, zero
    .endm
    .macro add_signed_product p, q, byte, top
    mulsu \p, \q
    signs (\byte + 2), \top
    add_product \byte, \top
    .endm

    // s += a times byte `index` = 0 or 1 of b.
    .macro row index, top
    ld digit, Z+
    mulsu a2, digit
    signs (\index + 4), \top
    movw q0, r0
    mul a0, digit
    into add, (\index), \top, r0
    into adc, (\index + 1), \top, r1
    into adc, (\index + 2), \top, q0
    into adc, (\index + 3), \top, q1
    into adc, (\index + 4), \top, zero
    into adc, (\index + 5), \top, zero
    mul a1, digit
    into add, (\index + 1), \top, r0
    into adc, (\index + 2), \top, r1
    into adc, (\index + 3), \top, zero
    into adc, (\index + 4), \top, zero
    into adc, (\index + 5), \top, zero
    .endm
    .macro last_row top
    ld digit, Z+
    add_signed_product digit, a0, 2, \top
    add_signed_product digit, a1, 3, \top
    .if \top > 3
    muls a2, digit
    add_product 4, \top
    .endif
    .endm

    // The bytes from p on, shifted right by 8 - left bits.
    .macro result left, p, next
    .if \left < 5
    .rept \left
    lsl_bytes \p, 4
    .endr
    mov_bytes r22, \next, 3
    .else
    .rept 8 - \left
    lsr_bytes \p, 4
    .endr
    mov_bytes r22, \p, 3
    .endif
    .endm

    // The sum begins with half of the last place of the result, which rounds.
    .macro dot fraction, first, top
    .irp n, 12, 13, 14, 15, 16, 17
    .if \n <= 12 + \top
    push r\n
    .endif
    .endr
    movw r30, r22
    mov count, r26
    movw r26, r24
    clr zero
    clr_bytes s0, (\top + 1)
    .if \fraction
    ldi digit, 1 << ((\fraction - 1) % 8)
    mov 12 + \first, digit
    .endif
1:  ld_each a0, X+, 3
    row 0, \top
    row 1, \top
    last_row \top
    dec count
    brne 1b
    clr r1
    .if \first == 0
    result (8 - \fraction), s0, s1
    .elseif \first == 1
    result (16 - \fraction), s1, s2
    .else
    result (24 - \fraction), s2, s3
    .endif
    .irp n, 17, 16, 15, 14, 13, 12
    .if \n <= 12 + \top
    pop r\n
    .endif
    .endr
    ret
    .endm

    .macro kernels integer, fraction
    SECTION fixedpoint_dot_q\integer\()_\fraction
    ENTRY fixedpoint_dot2_q\integer\()_\fraction
    ldi r26, 2
    rjmp 2f
    ENDFUNC fixedpoint_dot2_q\integer\()_\fraction

    ENTRY fixedpoint_dot3_q\integer\()_\fraction
    ldi r26, 3
2:  dot \fraction, ((\fraction - 1) / 8), ((\fraction - 1) / 8 + 3)
    ENDFUNC fixedpoint_dot3_q\integer\()_\fraction
    .endm

#include "splits_24.inc"

#endif
