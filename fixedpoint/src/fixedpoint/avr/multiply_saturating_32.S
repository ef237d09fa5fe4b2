// SPDX-License-Identifier: MIT
// int32_t fixedpoint_multiply_saturating_q<32 - F>_<F>(int32_t a, int32_t b)
// floor(a b / 2^F + 1/2), saturated: the product rounded to nearest, half up, of every 32-bit
// format except Q16.16, which has a faster kernel of its own.
//
// In       a = r25:r22, b = r21:r18
// Out      r25:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    5 bytes
//
// The columns are those of multiply_32.S, up to byte 7, which is taken modulo 2^8. From byte
// f = floor((F - 1) / 8) on, the sum is shifted to whole bytes by at most four bits in either
// direction, to the left into a byte of its sign; the last bit shifted out to the right rounds. The
// result is in range if that byte and all bytes above it are its sign extension, whether these are
// shifted or not.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define a0 r22
#define a1 r23
#define a2 r16
#define a3 r17
#define zero r27
// Bytes of the sum; none is in a register that a later byte of the result needs.
#define s0 r26
#define s1 r24
#define s2 r30
#define s3 r31
#define s4 r25
#define s5 r28
#define s6 r29
#define s7 r15
#define s8 r27

    .macro product p, q, low, high, carry
    mul_add \p, \q, \low, \high, zero, \carry
    .endm
    .macro signed_product p, q, low, high, carry
    mulsu \p, \q
    sbc \carry, zero
    add \low, r0
    adc \high, r1
    adc \carry, zero
    .endm

    .macro bytes_from first
    movw a2, r24
    clr zero
    mul a0, rB0
    .if \first == 0
    mov s0, r0
    .endif
    mov s1, r1
    mul a1, rB1
    movw s2, r0
    product a0, rB1, s1, s2, s3
    product a1, rB0, s1, s2, s3
    clr s4
    product a0, rB2, s2, s3, s4
    product a2, rB0, s2, s3, s4
    ldi s5, 2
    product a1, rB2, s3, s4, s5
    product a2, rB1, s3, s4, s5
    signed_product rB3, a0, s3, s4, s5
    signed_product a3, rB0, s3, s4, s5
    ldi s6, 2
    product a2, rB2, s4, s5, s6
    signed_product rB3, a1, s4, s5, s6
    signed_product a3, rB1, s4, s5, s6
    clr s7
    signed_product rB3, a2, s5, s6, s7
    signed_product a3, rB2, s5, s6, s7
    muls_add a3, rB3, s6, s7
    subi s5, 2
    sbci s6, 2
    sbc s7, zero
    clr r1
    .endm

    // `instruction` on the bytes first..last of the sum, upward or downward.
    .macro up instruction, first, last
    .irp n, 0, 1, 2, 3, 4, 5, 6, 7, 8
    .if (\n >= \first) && (\n <= \last)
    of_byte \instruction, \n
    .endif
    .endr
    .endm
    .macro down instruction, first, last
    .irp n, 8, 7, 6, 5, 4, 3, 2, 1, 0
    .if (\n >= \first) && (\n <= \last)
    of_byte \instruction, \n
    .endif
    .endr
    .endm
    .macro of_byte instruction, n
    .ifc \n, 0
    \instruction s0
    .endif
    .ifc \n, 1
    \instruction s1
    .endif
    .ifc \n, 2
    \instruction s2
    .endif
    .ifc \n, 3
    \instruction s3
    .endif
    .ifc \n, 4
    \instruction s4
    .endif
    .ifc \n, 5
    \instruction s5
    .endif
    .ifc \n, 6
    \instruction s6
    .endif
    .ifc \n, 7
    \instruction s7
    .endif
    .ifc \n, 8
    \instruction s8
    .endif
    .endm
    .macro add_carry byte
    adc \byte, r1
    .endm
    .macro other_than_sign byte
    cp \byte, r0
    brne 8f
    .endm
    // The register that is next, unless the byte is there.
    .macro take byte
    .if .L\byte - 22 - target
    mov 22 + target, \byte
    .endif
    .set target, target + 1
    .endm
    // r0 = the sign of the result.
    .macro sign_of byte
    mov r0, \byte
    lsl r0
    sbc r0, r0
    .endm

    // The result from byte `from` on, once the carry has rounded.
    .macro result from, top, rounds
    .if \rounds
    up add_carry, (\from), \top
    .endif
    .if \from + 4 <= \top
    up sign_of, (\from + 3), (\from + 3)
    up other_than_sign, (\from + 4), \top
    .endif
    .set target, 0
    up take, (\from), (\from + 3)
    .endm

    // What leaves the result to the left goes into s8. If it is the top of the product, the first bit that
    // leaves is another sign, which s8 has already. A bit that is shifted in never reaches the one that
    // rounds.
    .macro round_saturating first, left
    .set is_wide, (\left > 0) && (\left < 5)
    .if is_wide
    mov s8, s7
    lsl s8
    sbc s8, s8
    .set is_needless, \first == 3
    .rept \left
    up rol, (\first), (\first + 4)
    .if !is_needless
    rol s8
    .endif
    .set is_needless, 0
    .endr
    .endif
    .if \left < 5
    up lsl, (\first), (\first)
    result (\first + 1), (7 + is_wide), 1
    .else
    .rept 8 - \left
    down asr, (\first + 4), (\first + 4)
    down ror, (\first), (\first + 3)
    .endr
    result (\first), 7, (\left < 8)
    .endif
    .endm

    .macro kernels integer, fraction
    FUNCTION fixedpoint_multiply_saturating_q\integer\()_\fraction
    push_all r15, r16, r17, r28, r29
    bytes_from ((\fraction - 1) / 8)
    round_saturating ((\fraction - 1) / 8), (((\fraction - 1) / 8) * 8 + 8 - \fraction)
9:  pop_all r29, r28, r17, r16, r15
    ret
    // Saturates to the limit with the sign of the product.
8:
    .if is_wide
    lsl s8
    .else
    lsl s7
    .endif
    sbc r22, r22
    com r22
    mov r23, r22
    movw r24, r22
    subi r25, 0x80
    rjmp 9b
    ENDFUNC fixedpoint_multiply_saturating_q\integer\()_\fraction
    .endm

#include "splits_32.inc"

#endif
