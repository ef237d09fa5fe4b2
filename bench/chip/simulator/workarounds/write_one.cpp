// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/simulator/workarounds/write_one.hpp"

#include "bench/chip/simulator/registers.hpp"

namespace simulator {
namespace {

std::uint8_t ones_written(const avr_t* avr, std::uint8_t value) {
    const std::uint16_t opcode = current_opcode(avr);
    const bool is_sbi = (opcode & 0xff00) == 0x9a00;
    return is_sbi ? 1 << (opcode & 7) : value;
}

void clear_flags(avr_t* avr, std::uint16_t address, std::uint8_t ones) {
    for (int i = 0; i < avr->interrupts.vector_count; ++i) {
        avr_int_vector_t* const vector = avr->interrupts.vector[i];
        if (vector->raised.reg == address && ones >> vector->raised.bit & 1)
            avr_clear_interrupt(avr, vector);
    }
}

}  // namespace

WriteOneRegisters::WriteOneRegisters(avr_t* avr) {
    for (const std::uint16_t address : {registers::tifr0, registers::tifr1, registers::tifr2})
        hooks_.emplace_back(avr, address, [=](const WriteHook&, std::uint8_t value) {
            clear_flags(avr, address, ones_written(avr, value));
        });
    for (const std::uint16_t address : {registers::pinb, registers::pinc, registers::pind})
        hooks_.emplace_back(avr, address, [=](const WriteHook& hook, std::uint8_t value) {
            hook.forward(ones_written(avr, value));
        });
}

}  // namespace simulator
