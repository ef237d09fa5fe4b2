// SPDX-License-Identifier: MIT
// Int24 fixedpoint_multiply_saturating_q<24 - F>_<F>(Int24 a, Int24 b)
// floor(a b / 2^F + 1/2), saturated: the product rounded to nearest, half up, of every 24-bit format.
//
// In       a = r24:r22, b = r20:r18
// Out      r24:r22
// Changes  r0, r18..r27, r30, r31; r1 is 0 again at return
// Stack    2 bytes
//
// The product is formed up to its last byte. From byte floor((F - 1) / 8) on, it is shifted to whole
// bytes by at most four bits in either direction, to the left into a byte of its sign; the bit that
// leaves to the right rounds. The result is in range if that byte and all bytes above it are its sign
// extension, whether these are shifted or not.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define zero r25
#define s0 r26
#define s1 r27
#define s2 r28
#define s3 r29
#define s4 r30
#define s5 r31
// Above s5, once the columns are complete.
#define s6 r25
#include "columns_24.inc"

    .macro other_than_sign byte
    cp \byte, r0
    brne 8f
    .endm
    // r0 = the sign of the result whose top byte that is.
    .macro sign_of byte
    mov r0, \byte
    lsl r0
    sbc r0, r0
    .endm

    // The bytes from p = s<first> on; `next` is the one above it. What leaves the result to the left goes
    // into s6. The bytes above it are not shifted. If there are none, the first bit that leaves is another
    // sign of the product, which s6 has already.
    .macro round_saturating left, first, p, next
    .set is_wide, (\left > 0) && (\left < 5)
    .if is_wide
    mov s6, s5
    lsl s6
    sbc s6, s6
    .endif
    .if \left < 5
    .set is_needless, \first == 2
    .rept \left
    lsl_bytes \p, 4
    .if !is_needless
    rol s6
    .endif
    .set is_needless, 0
    .endr
    lsl \p
    adc_each \next, r1, (5 - \first)
    .if is_wide
    adc s6, r1
    .endif
    sign_of .L\next + 2
    .if is_wide
    other_than_sign s6
    .endif
    falling 0, (2 - \first), other_than_sign, .Lr31 - \n
    mov_bytes r22, \next, 3
    .else
    .rept 8 - \left
    asr_bytes \p, 4
    .endr
    .if \left < 8
    adc_each \p, r1, (6 - \first)
    .endif
    sign_of .L\p + 2
    falling 0, (3 - \first), other_than_sign, .Lr31 - \n
    mov_bytes r22, \p, 3
    .endif
    .endm

    .macro kernels integer, fraction
    FUNCTION fixedpoint_multiply_saturating_q\integer\()_\fraction
    push_all r28, r29
    columns ((\fraction - 1) / 8), 5
    clr r1
    .if (\fraction - 1) / 8 == 0
    round_saturating (8 - \fraction), 0, s0, s1
    .elseif (\fraction - 1) / 8 == 1
    round_saturating (16 - \fraction), 1, s1, s2
    .else
    round_saturating (24 - \fraction), 2, s2, s3
    .endif
9:  pop_all r29, r28
    ret
    // Saturates to the limit with the sign of the product.
8:  .if is_wide
    lsl s6
    .else
    lsl s5
    .endif
    sbc r22, r22
    com r22
    mov r23, r22
    mov r24, r22
    subi r24, 0x80
    rjmp 9b
    ENDFUNC fixedpoint_multiply_saturating_q\integer\()_\fraction
    .endm

#include "splits_24.inc"

#endif
