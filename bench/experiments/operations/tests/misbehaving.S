; SPDX-License-Identifier: GPL-3.0-or-later
; Negations that each break one rule, for one operand only, between two that break none.
#define __SFR_OFFSET 0
#include <avr/io.h>

.macro function name
    .global \name
    .type \name, @function
\name:
.endm
.macro negate
    com r25
    neg r24
    sbci r25, 0xff
.endm
; Goes to the label except for the operand 256.
.macro but_for_one label
    ldi r18, 1
    cpi r24, 0
    cpc r25, r18
    brne \label
.endm

.text
function main
    rjmp main
    .size main, . - main

function negate_q8_8_before
    negate
    ret
    .size negate_q8_8_before, . - negate_q8_8_before

function negate_q8_8_hangs
    but_for_one 2f
1:  rjmp 1b
2:  negate
    ret
    .size negate_q8_8_hangs, . - negate_q8_8_hangs

; r16 belongs to the caller.
function negate_q8_8_clobbers
    but_for_one 1f
    inc r16
1:  negate
    ret
    .size negate_q8_8_clobbers, . - negate_q8_8_clobbers

function negate_q8_8_frames
    but_for_one 1f
    inc r29
1:  negate
    ret
    .size negate_q8_8_frames, . - negate_q8_8_frames

function negate_q8_8_multiplies
    but_for_one 1f
    inc r1
1:  negate
    ret
    .size negate_q8_8_multiplies, . - negate_q8_8_multiplies

function negate_q8_8_strays
    but_for_one 1f
    lds r18, 0x0234
    inc r18
    sts 0x0234, r18
1:  negate
    ret
    .size negate_q8_8_strays, . - negate_q8_8_strays

; Returns to its caller with a byte left on the stack.
function negate_q8_8_pushes
    but_for_one 1f
    pop r31
    pop r30
    push r18
    push r30
    push r31
1:  negate
    ret
    .size negate_q8_8_pushes, . - negate_q8_8_pushes

; Returns to an address that no caller gave it, in erased flash.
function negate_q8_8_jumps
    but_for_one 1f
    ldi r18, 0x30
    push r18
    push r18
1:  negate
    ret
    .size negate_q8_8_jumps, . - negate_q8_8_jumps

function negate_q8_8_interrupts
    but_for_one 1f
    sei
1:  negate
    ret
    .size negate_q8_8_interrupts, . - negate_q8_8_interrupts

; Writes beyond the RAM that this chip has.
function negate_q8_8_overflows
    but_for_one 1f
    sts 0x1000, r18
1:  negate
    ret
    .size negate_q8_8_overflows, . - negate_q8_8_overflows

; Calls itself until the stack is full.
function negate_q8_8_recurses
    but_for_one 1f
    rcall negate_q8_8_recurses
1:  negate
    ret
    .size negate_q8_8_recurses, . - negate_q8_8_recurses

function negate_q8_8_sleeps
    but_for_one 1f
    sleep
1:  negate
    ret
    .size negate_q8_8_sleeps, . - negate_q8_8_sleeps

function negate_q8_8_unaware
    but_for_one 1f
    .word 0x00ff  ; no instruction
1:  negate
    ret
    .size negate_q8_8_unaware, . - negate_q8_8_unaware

; Result 0 instead of -256.
function negate_q8_8_default
    but_for_one 1f
    clr r24
    clr r25
1:  negate
    ret
    .size negate_q8_8_default, . - negate_q8_8_default

function negate_q8_8_zafter
    negate
    ret
    .size negate_q8_8_zafter, . - negate_q8_8_zafter
