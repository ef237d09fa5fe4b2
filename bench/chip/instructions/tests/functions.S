; SPDX-License-Identifier: GPL-3.0-or-later
; Functions whose results, cycles and faults are known by hand. PADDING moves everything, ANOTHER
; changes one constant.
#define __SFR_OFFSET 0
#include <avr/io.h>

.macro function name
    .global \name
    .type \name, @function
\name:
.endm

.section .progmem.data.other_table, "a", @progbits
    .balign 256
    .global other_table
    .type other_table, @object
other_table:
    .fill 256, 1, 1
    .size other_table, . - other_table

.section .progmem.data.root_table, "a", @progbits
#ifdef PADDING
    .fill 300, 1, 0
#endif
    .balign 256
    .global root_table
    .type root_table, @object
root_table:    ; sqrt of Q4.4, rounded
    .byte 0, 4, 6, 7, 8, 9, 10, 11, 11, 12, 13, 13, 14, 14, 15, 15
    .size root_table, . - root_table

.text
function main
    rjmp main
    .size main, . - main
#ifdef PADDING
    .fill 70, 2, 0
#endif

; (a b + 8) >> 4, in fewer cycles if b = 0; the last two instructions are never reached.
function multiply_q4_4_default
    tst r22
    breq 1f
    muls r24, r22
    movw r24, r0
    clr r1
    adiw r24, 8
    tst r22
    breq 2f
    asr r25
    ror r24
    asr r25
    ror r24
    asr r25
    ror r24
    asr r25
    ror r24
    ret
1:  clr r24
    ret
2:  ldi r24, 1
    ret
    .size multiply_q4_4_default, . - multiply_q4_4_default

; The product without its rounding.
function multiply_q4_4_unrounded
    muls r24, r22
    movw r24, r0
    clr r1
    ldi r18, 4
1:  asr r25
    ror r24
    dec r18
    brne 1b
    ret
    .size multiply_q4_4_unrounded, . - multiply_q4_4_unrounded

; The sum, in more cycles if it is large.
function add_q32_32_default
    add r18, r10
    adc r19, r11
    adc r20, r12
    adc r21, r13
    adc r22, r14
    adc r23, r15
    adc r24, r16
    adc r25, r17
    cpi r25, 127
    brne 1f
    nop
    nop
    nop
1:  ret
    .size add_q32_32_default, . - add_q32_32_default

; Reads a table: the root of the low four bits.
function lookup
    andi r24, 15
    mov r30, r24
    ldi r31, hi8(root_table)
    lpm r24, Z
#ifdef ANOTHER
    subi r24, 1
#else
    subi r24, 0
#endif
    ret
    .size lookup, . - lookup

; uint16_t branches(uint8_t flags): which of the sixteen branches are taken under the flags.
.macro taken branch, low, high
    \branch 1f
    rjmp 2f
1:  in r20, SREG
    ori r24, \low
    ori r25, \high
    out SREG, r20
2:
.endm
function branches
    mov r18, r24
    ldi r24, 0
    ldi r25, 0
    out SREG, r18
    taken brcs, 1, 0
    taken breq, 2, 0
    taken brmi, 4, 0
    taken brvs, 8, 0
    taken brlt, 16, 0
    taken brhs, 32, 0
    taken brts, 64, 0
    taken brie, 128, 0
    taken brcc, 0, 1
    taken brne, 0, 2
    taken brpl, 0, 4
    taken brvc, 0, 8
    taken brge, 0, 16
    taken brhc, 0, 32
    taken brtc, 0, 64
    taken brid, 0, 128
    cli
    ret
    .size branches, . - branches

; uint8_t skips(uint8_t a, uint8_t b): over instructions of one word and of two.
function skips
    mov r18, r24
    ldi r24, 0
    cpse r18, r22
    ori r24, 1
    cpse r18, r22
    jmp 1f
    ori r24, 2
1:  sbrc r18, 3
    ori r24, 4
    sbrs r18, 3
    call 3f
    sbrc r22, 7
    call 3f
    sbrs r22, 7
    ori r24, 8
    ret
3:  subi r24, -16
    ret
    .size skips, . - skips

; uint32_t calls(uint32_t a, uint8_t b): calls in calls, saves, loops, a frame as avr-gcc makes it.
function calls
    push r16
    push r28
    push r29
    rcall .+0
    push r1
    in r28, SPL
    in r29, SPH
    sbiw r28, 4
    in r0, SREG
    cli
    out SPH, r29
    out SREG, r0
    out SPL, r28
    mov r16, r20
    andi r16, 15
    std Y+1, r22
    std Y+2, r23
    std Y+3, r24
    std Y+4, r25
1:  rcall twice
    dec r16
    brpl 1b
    ldd r18, Y+1
    add r22, r18
    ldd r18, Y+2
    adc r23, r18
    ldd r18, Y+3
    adc r24, r18
    ldd r18, Y+4
    adc r25, r18
    adiw r28, 7
    in r0, SREG
    cli
    out SPH, r29
    out SREG, r0
    out SPL, r28
    pop r29
    pop r28
    pop r16
    ret
twice:
    call once
    sbrs r23, 0
    ret
    rcall once
    rjmp once
once:
    push r22
    lsl r22
    rol r23
    rol r24
    rol r25
    pop r0
    eor r25, r0
    ret
    .size calls, . - calls

; 32-bit sums through each kind of pointer: (a0 + a1, a2 + a0, -a1).
function normalise3_q16_16_pointers
    movw r26, r24
    movw r30, r22
    push r28
    push r29
    movw r28, r24
    ld r18, X+
    ld r19, X+
    ld r20, X+
    ld r21, X+
    ld r0, X+
    add r18, r0
    ld r0, X+
    adc r19, r0
    ld r0, X+
    adc r20, r0
    ld r0, X
    adc r21, r0
    st Z, r18
    std Z+1, r19
    std Z+2, r20
    std Z+3, r21
    adiw r28, 12
    adiw r30, 8
    ld r21, -Y
    ld r20, -Y
    ld r19, -Y
    ld r18, -Y
    sbiw r28, 8
    ld r0, Y+
    add r18, r0
    ld r0, Y+
    adc r19, r0
    ld r0, Y+
    adc r20, r0
    ld r0, Y+
    adc r21, r0
    st -Z, r21
    st -Z, r20
    st -Z, r19
    st -Z, r18
    ld r18, Y
    ldd r19, Y+1
    ldd r20, Y+2
    ldd r21, Y+3
    com r21
    com r20
    com r19
    neg r18
    sbci r19, 0xff
    sbci r20, 0xff
    sbci r21, 0xff
    adiw r30, 4
    st Z+, r18
    st Z+, r19
    movw r26, r30
    st X+, r20
    st X, r21
    pop r29
    pop r28
    ret
    .size normalise3_q16_16_pointers, . - normalise3_q16_16_pointers

; void counts(): counts its calls in two bytes, in more cycles where the lower one wraps.
.section .bss
    .global counter
    .type counter, @object
counter:
    .zero 2
    .size counter, . - counter
.text
function counts
    lds r24, counter
    subi r24, -1
    sts counter, r24
    brne 1f
    lds r24, counter + 1
    inc r24
    sts counter + 1, r24
1:  ret
    .size counts, . - counts

; What may not be.
function leaves_r1
    ser r24
    mov r1, r24
    ret
    .size leaves_r1, . - leaves_r1
function changes_r17
    inc r17
    ret
    .size changes_r17, . - changes_r17
function pushes_only
    push r24
    ret
    .size pushes_only, . - pushes_only
function returns_early
    call 1f
    ret
1:  pop r0
    pop r0
    ret
    .size returns_early, . - returns_early
function writes_away
    sts 0x0123, r24
    ret
    .size writes_away, . - writes_away
function hangs
    rjmp hangs
    .size hangs, . - hangs
function recurses
    rcall recurses
    ret
    .size recurses, . - recurses
function jumps_indirectly
    ijmp
    .size jumps_indirectly, . - jumps_indirectly
function reads_a_port
    in r24, PINB
    ret
    .size reads_a_port, . - reads_a_port
function is_no_code
    .word 0x00ff
    .size is_no_code, . - is_no_code
