// SPDX-License-Identifier: MIT
// int8_t fixedpoint_length2_q4_4(const int8_t* v)
// int8_t fixedpoint_length3_q4_4(const int8_t* v)
// The square root of the sum of 2 or 3 squares, rounded to nearest (there are no ties), saturated:
// the fraction bits cancel, so it is the length in every 8-bit format.
//
// In:       v r25:r24, in RAM
// Out:      r24
// Clobbers: r0, r18..r21, r25..r27, r30, r31
// Stack:    0 bytes.
//
// The sum S has 16 bits. With S 4^k at least 2^14, s = floor(sqrt(S 4^k)) has 8 bits, and the result
// is (s + 2^(k-1)) / 2^k, rounded down; if k is 0, it is out of range.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define s0 r18
#define s1 r19
#define x r20
#define root r24
#define k r21

    // s1:s0 = the first square; X points to the next component.
    .macro first_square
    movw r26, r24
    ld x, X+
    muls x, x
    movw s0, r0
    .endm
    .macro add_square
    ld x, X+
    muls_add x, x, s0, s1
    .endm

    SECTION fixedpoint_length_q4_4
    ENTRY fixedpoint_length3_q4_4
    first_square
    add_square
    rjmp .Llast
    ENDFUNC fixedpoint_length3_q4_4

    ENTRY fixedpoint_length2_q4_4
    first_square
.Llast:
    add_square
    cpi s1, 0x40
    brsh .Ltoo_large
    clr k
    tst s1
    brne .Lpairs
    ldi k, 4
    mov s1, s0
    clr s0
    tst s1
    breq .Lzero
    rjmp .Lpairs
.Lpair:
    lsl s0
    rol s1
    lsl s0
    rol s1
    inc k
.Lpairs:
    cpi s1, 0x40
    brlo .Lpair

    // The table may be 1 less, and the remainder more than 2 root.
    mov r30, s1
    subi r30, 0x40
    ldi r31, hi8(fixedpoint_root_table)
    lpm root, Z
    mul root, root
    sub s0, r0
    sbc s1, r1
    sub s0, root
    sbci s1, 0
    cp root, s0
    clr r1
    cpc r1, s1
    brge 1f
    inc root
1:  lsr root
    dec k
    brne 1b
    clr r1
    adc root, r1
    sbrc root, 7
    dec root
    ret
.Ltoo_large:
    ldi r24, 0x7f
    clr r1
    ret
.Lzero:
    clr r24
    clr r1
    ret
    ENDFUNC fixedpoint_length2_q4_4

#endif
