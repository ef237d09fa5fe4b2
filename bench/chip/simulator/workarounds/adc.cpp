// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/simulator/workarounds/adc.hpp"

#include <avr_adc.h>

#include <algorithm>
#include <cstring>

#include "bench/chip/simulator/registers.hpp"

namespace simulator {
namespace {

constexpr int conversion_complete_vector = 21;

}  // namespace

Adc::Adc(avr_t* avr)
    : avr_(avr),
      start_(avr_io_getirq(avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_OUT_TRIGGER),
             [this](std::uint32_t mux) { sample(mux); }),
      end_(avr_get_interrupt_irq(avr, conversion_complete_vector),
           [this](std::uint32_t raised) {
               if (raised && !locked_) result_ = sampled_;
           }),
      low_(avr, registers::adcl,
           [this] {
               locked_ = true;
               return static_cast<std::uint8_t>(adjusted());
           }),
      high_(avr, registers::adch, [this] {
          locked_ = false;
          return static_cast<std::uint8_t>(adjusted() >> 8);
      }) {}

void Adc::reset() {
    sampled_ = result_ = 0;
    locked_ = false;
}

void Adc::sample(std::uint32_t mux) {
    avr_adc_mux_t source{};
    std::memcpy(&source, &mux, sizeof mux);
    double volts = 0;
    if (source.kind == ADC_MUX_SINGLE && voltage_) volts = voltage_(avr_->cycle, source.src);
    if (source.kind == ADC_MUX_REF) volts = internal_reference;
    const bool internal = avr_->data[registers::admux] >> 6 == 3;
    const double count = volts * 1024 / (internal ? internal_reference : supply);
    sampled_ = static_cast<std::uint16_t>(std::clamp(count, 0.0, 1023.0));
}

std::uint16_t Adc::adjusted() const {
    const bool left = avr_->data[registers::admux] & 0x20;
    return left ? result_ << 6 : result_;
}

}  // namespace simulator
