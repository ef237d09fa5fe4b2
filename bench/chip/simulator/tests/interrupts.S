; SPDX-License-Identifier: GPL-3.0-or-later
; Interrupt entry, order and waking. Marks are writes to GPIOR0 of the value in r16 (before), r17
; (after) or r18 (in the interrupt).
#define __SFR_OFFSET 0
#include <avr/io.h>

.macro program name
    .global \name
    .type \name, @function
\name:
.endm

; Timer1 counts cycles and compares with `after` from the store to TCCR1B on.
.macro start_timer after
    ldi r16, 1
    ldi r17, 2
    ldi r18, 3
    ldi r24, hi8(\after)
    sts OCR1AH, r24
    ldi r24, lo8(\after)
    sts OCR1AL, r24
    ldi r24, (1 << OCIE1A)
    sts TIMSK1, r24
    ldi r24, (1 << SE)
    out SMCR, r24
    ldi r24, (1 << CS10)
    sts TCCR1B, r24
.endm

.text
program main
program done
    rjmp done
    .size done, . - done

; 1 + 4 cycles after the entry and the vector's jmp.
program TIMER1_COMPA_vect
    out GPIOR0, r18
    reti
    .size TIMER1_COMPA_vect, . - TIMER1_COMPA_vect

program TIMER1_COMPB_vect
    out GPIOR0, r19
    reti
    .size TIMER1_COMPB_vect, . - TIMER1_COMPB_vect

program TIMER1_OVF_vect
    out GPIOR0, r20
    reti
    .size TIMER1_OVF_vect, . - TIMER1_OVF_vect

; An interrupt during 100 nops between two marks.
program interrupted_nops
    sei
    start_timer 50
    out GPIOR0, r16
    .rept 100
    nop
    .endr
    out GPIOR0, r17
    rjmp done
    .size interrupted_nops, . - interrupted_nops

program interrupted_sleep
    sei
    start_timer 50
    out GPIOR0, r16
    sleep
    out GPIOR0, r17
    rjmp done
    .size interrupted_sleep, . - interrupted_sleep

; Both compare flags are pending when interrupts are enabled: exactly one instruction of the program
; is executed before the first, and one between the two.
program pending_pair
    ldi r19, 4
    ldi r24, 0
    sts OCR1BH, r24
    ldi r24, 8
    sts OCR1BL, r24
    start_timer 4
    ldi r24, (1 << OCIE1A) | (1 << OCIE1B)
    sts TIMSK1, r24
    .rept 20
    nop
    .endr
    sei
    out GPIOR0, r16
    out GPIOR0, r17
    out GPIOR0, r16
    rjmp done
    .size pending_pair, . - pending_pair

; Sleeps for a second at a time, by overflows of Timer1 at a prescaler of 1024.
program long_sleep
    sei
    start_timer 15624
    ldi r24, (1 << WGM12) | (1 << CS12) | (1 << CS10)
    sts TCCR1B, r24
    sleep
    sleep
    sleep
    sleep
    sleep
    rjmp done
    .size long_sleep, . - long_sleep

; Fast PWM with ICR1 as TOP, 2000 cycles a period. The compare value is 499, and 999 from the
; second period on, after whose match it is written. Interrupts meet instructions of one cycle.
program fast_pwm
    ldi r18, 3
    ldi r20, 5
    ldi r24, hi8(1999)
    sts ICR1H, r24
    ldi r24, lo8(1999)
    sts ICR1L, r24
    ldi r24, hi8(499)
    sts OCR1AH, r24
    ldi r24, lo8(499)
    sts OCR1AL, r24
    ldi r24, (1 << WGM11)
    sts TCCR1A, r24
    ldi r24, (1 << OCIE1A) | (1 << TOIE1)
    sts TIMSK1, r24
    ldi r22, hi8(999)
    ldi r23, lo8(999)
    sei
    ldi r24, (1 << WGM13) | (1 << WGM12) | (1 << CS10)
    sts TCCR1B, r24
    .rept 2800
    nop
    .endr
    sts OCR1AH, r22
    sts OCR1AL, r23
    .rept 5000
    nop
    .endr
    jmp done
    .size fast_pwm, . - fast_pwm
