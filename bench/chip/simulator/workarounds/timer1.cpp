// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/simulator/workarounds/timer1.hpp"

#include <avr_timer.h>

#include "bench/chip/simulator/registers.hpp"
#include "bench/chip/simulator/workarounds/peripheral.hpp"

namespace simulator {

Timer1Compare::Timer1Compare(avr_t* avr) {
    auto* const timer = find_peripheral<avr_timer_t>(avr, "timer", '1');
    const std::uint16_t low_bytes[] = {registers::ocr1al, registers::ocr1bl};
    for (int channel = 0; channel < 2; ++channel) {
        const std::uint16_t address = low_bytes[channel];
        hooks_.emplace_back(avr, address, [=](const WriteHook& hook, std::uint8_t value) {
            hook.forward(value);
            const bool mode_14 = timer->wgm_op_mode_kind == avr_timer_wgm_pwm &&
                                 timer->mode.top == avr_timer_wgm_reg_icr;
            if (!mode_14) return;
            const std::uint32_t compare = avr->data[address] | avr->data[address + 1] << 8;
            timer->comp[channel].comp_cycles =
                compare <= timer->tov_top ? std::uint64_t{timer->cs_div_value} * (compare + 1) : 0;
        });
    }
}

}  // namespace simulator
