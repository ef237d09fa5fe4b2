// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

struct avr_t;

namespace simulator {

// Must be called after each instruction or sleep, in place of avr_service_interrupts().
//
// Entry. simavr: entering an interrupt takes no time. Hardware: four cycles, in which the program
// counter is pushed, and four more if the interrupt ends a sleep (data sheet, "Interrupt Response
// Time"). The jump in the vector table then takes its own cycles.
//
// Order. simavr: after `sei` or `reti` two instructions pass before a pending interrupt is served.
// Hardware: one ("Reset and Interrupt Handling").
void service_interrupts(avr_t* avr, bool woken);

}  // namespace simulator
