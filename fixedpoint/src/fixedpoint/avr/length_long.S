// SPDX-License-Identifier: MIT
// The length of vectors with a component of 2^23 (128 in Q16.16) or more. Not a C function: the
// lengths jump here from the first such component.
//
// r25:r24:r23:r22 = the integer nearest to the root of n = r23:...:r18, the sum of the squares so
// far, plus the square of r27:r26:r25:r24, a magnitude of 2^23 to 2^31, plus the squares of the
// r28 - 1 components that follow at r31:r30; at most 2^31 - 1. The caller's r28 has been pushed.
// Preserves the call-saved registers; r1 is zero at return. Stack: 8 bytes with the r28 and the
// return address.
//
// fixedpoint_root_long: the root of n itself, 2^46 at least, after r28, r29, r17, r16, r15 and r14
// have been pushed and r29 cleared, for sqrt_32.S.
//
// Technique. k is chosen in 1..8 such that M = n 4^k / 2^16 has its leading one in bit 47 or 46:
// whole bytes are shifted by moves, up to 6 bits by a product. The 32-bit root of M 2^16, shifted
// back by k, is the length.
//
// Root. c, the root of the upper two bytes, and S, in 24 bits, are those of sqrt_q16_16.S. S is
// decremented by 6, which leaves it 0 to 12 below sqrt(M). Its remainder R = M - S^2, of which
// bytes 1 to 3 are enough, gives eight more bits: 2^8 R / (2 S), about q = R slope / 2^24. The
// slope is up to 1 % off, which would make q wrong by 28. Its product with S measures that error:
//     x = floor((slope (S >> 8) - 2^23) / 2^10),
// and q - floor(q / 32) x / 256 is less than 0.44 off, which tables/sqrt.py asserts for every value
// of the upper two bytes of M. The root is at most 2^32, which becomes 2^32 - 1.
//
// Rounding. The bytes of n below m1 are worth less than 0.02, 0.07 and 0.26 units of the 32-bit
// root if k is 1, 2 and 3 or more, so the shifted root is less than 1/4 off. If its fraction f is
// below 1/4 or at least 3/4, the nearest integer is known. In between, the integer part r is
// rounded up if n exceeds (r + 1/2)^2, which for integers is n > r^2 + r. Since sqrt(n) is less
// than 1/2 from r + 1/2, and r is below 2^31, the two sides differ by less than 2^31: four bytes
// decide.

#ifdef __AVR_HAVE_MUL__
#include "prelude.inc"

#define zero r29
#define count r28
// A component's magnitude and the sum of squares
#define a0 r24
#define a1 r25
#define a2 r26
#define a3 r27
#define n0 r18
#define n1 r19
#define n2 r20
#define n3 r21
#define n4 r22
#define n5 r23
#define n6 r16
#define n7 r17
#define t0 r14
#define t1 r15
// M and, in its lower bytes, R
#define m1 r24
#define m2 r25
#define m3 r26
#define m4 r27
#define m5 r30
#define power r16
#define back r17
#define slope r14
#define s1 r22
#define s2 r15
#define s3 r28
#define q1 r31
#define q0 r30
#define qf r27
#define x r16
#define q8 r23
// The root
#define l0 r22
#define l1 r23
#define l2 r24
#define l3 r25
#define f r30

    SECTION fixedpoint_length_long
.Lsaturate:
    ldi_bytes l0, 0x7fffffff, 4
.Lrestore:
    pop_all r14, r15, r16, r17, r29, r28
    clr r1
    ret

    ENTRY fixedpoint_length_long
    push_all r29, r17, r16, r15, r14
    clr zero
    clr n6
    clr n7
    tst a3
    brmi .Lsaturate
    // n += a^2: the squares of the bytes, 2 a3 a2, then 2 (a3:a2) (a1:a0), as 2 (a3:a2) fits in two
    // bytes, and a1 a0 twice.
.Lsquare:
    mul a0, a0
    movw t0, r0
    mul a1, a1
    add n0, t0
    adc n1, t1
    adc n2, r0
    adc n3, r1
    adc n4, zero
    adc n5, zero
    adc n6, zero
    adc n7, zero
    mul a2, a2
    movw t0, r0
    mul a3, a3
    add n4, t0
    adc n5, t1
    adc n6, r0
    adc n7, r1
    lsl a3
    mul_add a2, a3, n5, n6, zero, n7
    lsl a2
    adc a3, zero
    mul a0, a1
    movw t0, r0
    mul a0, a3
    add n1, t0
    adc n2, t1
    adc n3, r0
    adc n4, r1
    adc n5, zero
    adc n6, zero
    adc n7, zero
    mul a1, a2
    add n1, t0
    adc n2, t1
    adc n3, r0
    adc n4, r1
    adc n5, zero
    adc n6, zero
    adc n7, zero
    mul a0, a2
    movw t0, r0
    mul a1, a3
    add n2, t0
    adc n3, t1
    adc n4, r0
    adc n5, r1
    adc n6, zero
    adc n7, zero
    dec count
    breq .Lsum
    ld_each a0, Z+, 4
    tst a3
    brpl .Lsquare
    com_bytes a1, 3
    neg a0
    sbci_each a1, 0xff, 3
    brmi 1f
    rjmp .Lsquare
1:  rjmp .Lsaturate

.Lshort:
    mov m5, n5
    mov_from_top m1, n1, 4
    ldi back, 1
    rjmp .Lnormalised

    // M = n 4^k / 2^16 without the bytes below m1; back = 2^(8 - k).
    ENTRY fixedpoint_root_long
.Lsum:
    cpi n7, 0x40
    brsh 1b
    tst n7
    breq 1f
    mov m5, n7
    mov m4, n6
    mov_from_top m1, n3, 3
    ldi back, 0x80
    rjmp 2f
1:  tst n6
    breq .Lshort
    mov m5, n6
    movw m3, n4
    movw m1, n2
    ldi back, 16
    ldi power, 1
    cpi m5, 0x40
    brsh 3f
    ldi back, 8
2:  ldi power, 4
    cpi m5, 0x10
    brsh 3f
    lsr back
    ldi power, 16
    cpi m5, 4
    brsh 3f
    lsr back
    ldi power, 64
3:  mul m5, power
    mov m5, r0
    mul_or m4, power, m4, m5
    mul_or_bytes m1, power, m1, 3
.Lnormalised:
    ldi r31, hi8(fixedpoint_sqrt_table)
    lpm_pages s2, s3, slope
    mul_add_upper slope, m4, s2, zero, s3
    // c in s3:s2; its remainder over 256, modulo 2^16, in r31:r30
    movw r30, m3
    mul s2, s2
    sub r30, r1
    sbc r31, zero
    mul s3, s3
    sub r31, r0
    mul s2, s3
    lsl r0
    rol r1
    sub r30, r0
    sbc r31, r1
    // S = s3:s2:s1
    mul r30, slope
    mov s1, r1
    mul_add r31, slope, s1, s2, zero, s3
    subi s1, 6
    sbc s2, zero
    sbc s3, zero
    // R over 256 in m3:m2:m1
    mul s1, s1
    sub m1, r1
    sbc m2, zero
    sbc m3, zero
    mul s1, s2
    lsl r0
    rol r1
    sbc m3, zero
    sub m1, r0
    sbc m2, r1
    sbc m3, zero
    mul s1, s3
    lsl r0
    rol r1
    sub m2, r0
    sbc m3, r1
    mul s2, s2
    sub m2, r0
    sbc m3, r1
    mul s2, s3
    lsl r0
    sub m3, r0
    // q = q1:q0:qf
    mul m3, slope
    movw q0, r0
    mul m2, slope
    mov qf, r0
    add q0, r1
    adc q1, zero
    mul_add_upper m1, slope, qf, zero, q0, q1
    // x
    mul s2, slope
    mov x, r1
    mul s3, slope
    add x, r0
    adc r1, zero
    lsr r1
    ror x
    lsr r1
    ror x
    // q - floor(q / 32) x / 256, and S with it
    mov q8, q0
    andi q8, 0xf0
    or q8, q1
    swap q8
    lsr q8
    mulsu x, q8
    sbrc r1, 7
    inc q1
    sub qf, r0
    sbc q0, r1
    sbc q1, zero
    add s1, q1
    adc s2, zero
    adc s3, zero
    brcs .Loverflow
    // r = l3:l2:l1:l0, its fraction f
4:  mul s3, back
    movw l2, r0
    mul_or s2, back, l1, l2
    mul_or s1, back, l0, l1
    mul_or q0, back, f, l0
    mul qf, back
    or f, r1
    subi f, 0x40
    brmi 5f
    // Near 1/2: rounded up if n - r (r + 1) - 1, modulo 2^32, is not negative.
    sec
    sbc_bytes n0, l0, 4
    mul l0, l0
    sub n0, r0
    sbc n1, r1
    sbc n2, zero
    sbc n3, zero
    mul l0, l1
    sub n1, r0
    sbc n2, r1
    sbc n3, zero
    sub n1, r0
    sbc n2, r1
    sbc n3, zero
    mul l0, l2
    sub n2, r0
    sbc n3, r1
    sub n2, r0
    sbc n3, r1
    mul l1, l1
    sub n2, r0
    sbc n3, r1
    mul l0, l3
    sub n3, r0
    sub n3, r0
    mul l1, l2
    sub n3, r0
    sub n3, r0
    lsl n3
5:  brcs 6f
    increment_bytes l0, 4
    brpl 6f
    rjmp .Lsaturate
6:  rjmp .Lrestore

    // 2^32, to be 2^32 - 1.
.Loverflow:
    com s1
    com s2
    com s3
    com q0
    rjmp 4b
    ENDFUNC fixedpoint_length_long
#endif
