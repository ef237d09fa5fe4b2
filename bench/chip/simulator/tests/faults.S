; SPDX-License-Identifier: GPL-3.0-or-later
; Programs that go wrong, and functions that break the calling convention.
#define __SFR_OFFSET 0
#include <avr/io.h>

.macro program name
    .global \name
    .type \name, @function
\name:
.endm

.comm variables, 64

.text
program main
    rjmp main
    .size main, . - main

program hang
    rjmp hang
    .size hang, . - hang

program illegal_opcode
    nop
    .word 0x00ff
    ret
    .size illegal_opcode, . - illegal_opcode

program jump_out
    ldi r30, 0x00
    ldi r31, 0x30
    ijmp
    .size jump_out, . - jump_out

program recurse
    rcall recurse
    ret
    .size recurse, . - recurse

; Moves the stack pointer down by 2000 bytes as avr-gcc does.
program big_frame
    in r28, SPL
    in r29, SPH
    subi r28, lo8(2000)
    sbci r29, hi8(2000)
    in r0, SREG
    cli
    out SPH, r29
    out SREG, r0
    out SPL, r28
    ret
    .size big_frame, . - big_frame

program sleep_forever
    cli
    sleep
    ret
    .size sleep_forever, . - sleep_forever

; From the end of the RAM to the end of the address space.
program write_beyond_ram
    ldi r26, lo8(RAMEND + 1)
    ldi r27, hi8(RAMEND + 1)
1:  st X+, r24
    adiw r26, 0
    brne 1b
    ret
    .size write_beyond_ram, . - write_beyond_ram

program write_last_address
    ldi r30, 0xff
    ldi r31, 0xff
    st Z, r24
    ret
    .size write_last_address, . - write_last_address

program read_beyond_ram
    ldi r28, lo8(RAMEND)
    ldi r29, hi8(RAMEND)
    ldd r24, Y+63
    ldi r28, 0
    ldi r29, 0
    ret
    .size read_beyond_ram, . - read_beyond_ram

; The words above the flash read as erased.
program read_beyond_flash
    ldi r30, 0xff
    ldi r31, 0xff
    lpm r24, Z
    ret
    .size read_beyond_flash, . - read_beyond_flash

; A push at 0xffff.
program stack_beyond_ram
    ldi r24, 0xff
    out SPL, r24
    out SPH, r24
    push r24
    ret
    .size stack_beyond_ram, . - stack_beyond_ram

; Writes r24 to the last byte of the EEPROM by an address with all bits set, and reads it back.
program eeprom_end
    ldi r30, 0xff
    out EEARL, r30
    out EEARH, r30
    in r25, EEARH
    out EEDR, r24
    sbi EECR, EEMPE
    sbi EECR, EEPE
1:  sbic EECR, EEPE
    rjmp 1b
    sbi EECR, EERE
    in r24, EEDR
    ret
    .size eeprom_end, . - eeprom_end

program leave_r1
    ldi r24, 1
    mov r1, r24
    ret
    .size leave_r1, . - leave_r1

program change_r5
    inc r5
    ret
    .size change_r5, . - change_r5

program change_r17
    inc r17
    ret
    .size change_r17, . - change_r17

program change_r28
    inc r28
    ret
    .size change_r28, . - change_r28

program enable_interrupts
    sei
    ret
    .size enable_interrupts, . - enable_interrupts

program unbalanced
    pop r25
    pop r24
    push r24
    push r24
    push r25
    ret
    .size unbalanced, . - unbalanced

program write_variable
    sts variables, r24
    ret
    .size write_variable, . - write_variable

program write_below_stack
    in r30, SPL
    in r31, SPH
    sbiw r30, 10
    com r24
    st Z, r24
    ret
    .size write_below_stack, . - write_below_stack

; 2 bytes of return address, 3 pushed, 2 of the inner call.
program push_three
    push r2
    push r3
    push r4
    rcall 1f
    pop r4
    pop r3
    pop r2
1:  ret
    .size push_three, . - push_three

; 2 bytes of return address, 2 pushed, 20 reserved as avr-gcc does.
program reserve_twenty
    push r28
    push r29
    in r28, SPL
    in r29, SPH
    sbiw r28, 20
    in r0, SREG
    cli
    out SPH, r29
    out SREG, r0
    out SPL, r28
    adiw r28, 20
    cli
    out SPH, r29
    out SREG, r0
    out SPL, r28
    pop r29
    pop r28
    ret
    .size reserve_twenty, . - reserve_twenty

program either_branch
    tst r24
    breq 1f
    ldi r24, 7
    sts variables, r24
    ret
1:  ldi r24, 9
    ret
    .size either_branch, . - either_branch
