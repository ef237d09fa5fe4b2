// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sim_avr.h>

#include <cstring>
#include <stdexcept>

namespace simulator {

// simavr's state of a peripheral, by its kind ("timer", "uart") and number.
template <class Peripheral>
Peripheral* find_peripheral(avr_t* avr, const char* kind, char name) {
    for (avr_io_t* io = avr->io_port; io; io = io->next)
        if (!std::strcmp(io->kind, kind) && reinterpret_cast<Peripheral*>(io)->name == name)
            return reinterpret_cast<Peripheral*>(io);
    throw std::logic_error("libsimavr's ATmega328P lacks a peripheral");
}

}  // namespace simulator
