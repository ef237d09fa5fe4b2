// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/simulator/workarounds/interrupts.hpp"

#include <sim_avr.h>

namespace simulator {
namespace {

constexpr int entry_cycles = 4;
constexpr int waking_cycles = 4;

}  // namespace

void service_interrupts(avr_t* avr, bool woken) {
    // simavr sets -2 when the I flag is set, and counts up after each instruction.
    if (avr->interrupt_state == -1) avr->interrupt_state = avr_has_pending_interrupts(avr) ? 1 : 0;
    const bool enabled = avr->sreg[S_I];
    avr_service_interrupts(avr);
    if (enabled && !avr->sreg[S_I]) avr->cycle += entry_cycles + (woken ? waking_cycles : 0);
}

}  // namespace simulator
