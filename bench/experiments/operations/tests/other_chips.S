// SPDX-License-Identifier: GPL-3.0-or-later
// Functions whose cycles are counted by hand, for any chip.
    .macro function name
    .section .text.\name, "ax", @progbits
    .global \name
    .type \name, @function
\name:
    .endm

    // uint32_t sum(uint32_t a, uint32_t b), which claims to subtract, too.
    function add_q16_16_default
    .global sum, subtract_q16_16_default
    .type sum, @function
    .type subtract_q16_16_default, @function
sum:
subtract_q16_16_default:
    add r22, r18
    adc r23, r19
    adc r24, r20
    adc r25, r21
    ret

    // uint32_t twice(uint32_t a), by a call.
    function twice
    mov r18, r22
    mov r19, r23
    mov r20, r24
    mov r21, r25
    rcall sum
    ret

    // uint64_t last(uint64_t a, uint64_t b, uint64_t c): c, which lies above the return address.
    function last
    push r28
    push r29
    in r28, 0x3d
    in r29, 0x3e
    .irp n, 0, 1, 2, 3, 4, 5, 6, 7
    ldd r18, Y + 5 + \n
    push r18
    .endr
    .irp n, 25, 24, 23, 22, 21, 20, 19, 18
    pop r\n
    .endr
    pop r29
    pop r28
    ret

    function endless
    rjmp endless

    // Leaves r1 other than zero.
    function careless
    inc r1
    ret

    function main
    rjmp main
