; SPDX-License-Identifier: GPL-3.0-or-later
; Straight sequences whose cycles are counted by hand from the instruction set manual. The sum,
; including call and ret, is in device_function_test.cpp.
#define __SFR_OFFSET 0
#include <avr/io.h>

.macro program name
    .global \name
    .type \name, @function
\name:
.endm

.comm variable, 2

.text
program main
    rjmp main
    .size main, . - main

program count_nothing
    ret
    .size count_nothing, . - count_nothing

program count_single            ; 16 instructions of 1 cycle
    nop
    ldi r24, 1
    mov r25, r24
    movw r22, r24
    add r24, r25
    adc r25, r24
    subi r24, 3
    cp r24, r25
    com r24
    neg r24
    lsr r24
    ror r25
    swap r24
    bst r24, 3
    bld r25, 2
    in r0, SREG
    ret
    .size count_single, . - count_single

program count_double            ; 11 instructions of 2 cycles, clr r1 1, movw 1
    movw r26, r24
    adiw r24, 5
    sbiw r24, 3
    mul r24, r25
    muls r22, r23
    mulsu r22, r23
    fmul r22, r23
    lds r24, variable
    sts variable, r24
    push r24
    pop r24
    sbi GPIOR0, 1
    clr r1
    ret
    .size count_double, . - count_double

program count_clear_bit         ; 2
    cbi GPIOR0, 1
    ret
    .size count_clear_bit, . - count_clear_bit

program count_memory            ; 2 ldi, 4 loads and stores of 2, 2 lpm of 3
    ldi r30, lo8(variable)
    ldi r31, hi8(variable)
    st Z, r24
    ld r24, Z+
    ldd r25, Z+1
    st -Z, r24
    lpm r24, Z
    lpm r25, Z+
    ret
    .size count_memory, . - count_memory

program count_branches          ; 1 + (brne not taken 1) + (breq taken 2) + rjmp 2 + jmp 3
    sub r24, r24
    brne 1f
    breq 1f
    nop
1:  rjmp 2f
2:  jmp 3f
3:  ret
    .size count_branches, . - count_branches

program count_skips             ; 1 + (no skip 1 + 1) + (skip one word 2) + (skip two words 3)
    ldi r24, 1
    sbrc r24, 0
    nop
    sbrs r24, 0
    nop
    cpse r24, r24
    jmp count_skips
    ret
    .size count_skips, . - count_skips

program count_calls             ; rcall 3 + ret 4, call 4 + ret 4, ldi 1 + 1 + icall 3 + ret 4
    rcall count_nothing
    call count_nothing
    ldi r30, pm_lo8(count_nothing)
    ldi r31, pm_hi8(count_nothing)
    icall
    ret
    .size count_calls, . - count_calls

program count_loop              ; ldi 1 + 10 * (dec 1 + brne 2) - 1
    ldi r24, 10
1:  dec r24
    brne 1b
    ret
    .size count_loop, . - count_loop
