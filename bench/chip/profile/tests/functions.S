; SPDX-License-Identifier: GPL-3.0-or-later
; Functions whose cycles and stack follow from the instruction set's table by arithmetic; the sums are
; in profiler_test.cpp.
#define __SFR_OFFSET 0
#include <avr/io.h>

.macro function name
    .global \name
    .type \name, @function
\name:
.endm
.macro end name
    .size \name, . - \name
.endm
.macro nops count
    .rept \count
    nop
    .endr
.endm

.text
; Starts when the start-up code calls it; the tests call the rest from here.
function main
    out GPIOR0, r1
done:
    rjmp done
end main

function ten_nops
    nops 10
    ret
end ten_nops

function three_nops
    nops 3
    ret
end three_nops

function twice
    rcall three_nops
    rcall three_nops
    ret
end twice

; Calls itself r24 - 1 times.
function recursive
    dec r24
    breq 1f
    rcall recursive
1:  ret
end recursive

function jumps_on
    nop
    rjmp five_nops
end jumps_on

function five_nops
    nops 5
    ret
end five_nops

function falls_on
    nops 2
end falls_on
function fallen_into
    nops 3
    ret
end fallen_into

; Like __prologue_saves__: entered by a jump, left by a jump back.
function with_prologue
    ldi r30, pm_lo8(1f)
    ldi r31, pm_hi8(1f)
    rjmp prologue
1:  pop r29
    pop r28
    ret
end with_prologue
function prologue
    push r28
    push r29
    ijmp
end prologue

function pushes
    push r16
    push r17
    push r28
    rcall pushes_two
    pop r28
    pop r17
    pop r16
    ret
end pushes
function pushes_two
    push r16
    push r17
    pop r17
    pop r16
    ret
end pushes_two

; Four bytes, reserved by calls of the next instruction as avr-gcc does.
function reserves
    rcall .
    rcall .
    pop r0
    pop r0
    pop r0
    pop r0
    ret
end reserves

; Jumps by a return to an address that it pushed.
function returns_elsewhere
    ldi r24, pm_lo8(1f)
    push r24
    ldi r24, pm_hi8(1f)
    push r24
    ret
1:  nop
    ret
end returns_elsewhere

; A subroutine within the function.
function own_subroutine
    rcall 1f
    rcall 1f
    ret
1:  nop
    ret
end own_subroutine

function indirect
    ldi r30, pm_lo8(three_nops)
    ldi r31, pm_hi8(three_nops)
    icall
    ret
end indirect

function pushes_in_a_loop
1:  push r1
    dec r24
    brne 1b
    ret
end pushes_in_a_loop

; Timer1 counts cycles and compares with r24 from the store to TCCR1B on.
function start_timer
    sts OCR1AH, r1
    sts OCR1AL, r24
    ldi r24, (1 << OCIE1A)
    sts TIMSK1, r24
    ldi r24, (1 << CS10)
    sts TCCR1B, r24
    ret
end start_timer

function interrupted_nops
    rcall start_timer
    sei
    nops 200
    cli
    ret
end interrupted_nops

; Two cycles each.
function interrupted_jumps
    rcall start_timer
    sei
    .rept 100
    rjmp .+0
    .endr
    cli
    ret
end interrupted_jumps

function interrupted_sleep
    rcall start_timer
    ldi r24, (1 << SE)
    out SMCR, r24
    sei
    sleep
    cli
    ret
end interrupted_sleep

function TIMER1_COMPA_vect
    push r16
    rcall three_nops
    pop r16
    reti
end TIMER1_COMPA_vect
