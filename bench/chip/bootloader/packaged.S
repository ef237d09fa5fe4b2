; SPDX-License-Identifier: GPL-3.0-or-later
; The bytes of a bootloader as a program, linked to the address where they belong.
    .section .text
    .global bootloader
    .type bootloader, @function
bootloader:
    .incbin BOOTLOADER
    .size bootloader, . - bootloader
