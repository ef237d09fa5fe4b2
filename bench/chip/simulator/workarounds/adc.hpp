// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>

#include "bench/chip/simulator/hooks.hpp"

namespace simulator {

// The result of an analogue-to-digital conversion.
//
// simavr: the result is computed when it is read, from the channel selected then, in whole
// millivolts, as voltage * 1023 / reference. Hardware (data sheet, "ADC Conversion Result"): it is
// the voltage sampled at the start of the conversion, times 1024 / reference, at most 1023. ADCL
// and ADCH hold it from the end of the conversion on, and a read of ADCL freezes ADCH until it is
// read as well.
class Adc {
  public:
    // The voltage at a channel (0..7), asked for at the start of each conversion.
    using Voltage = std::function<double(std::uint64_t cycle, int channel)>;

    explicit Adc(avr_t* avr);
    void reset();
    void on_conversion(Voltage voltage) { voltage_ = std::move(voltage); }

    static constexpr double supply = 5.0;              // volts, AVCC and AREF
    static constexpr double internal_reference = 1.1;  // volts

  private:
    void sample(std::uint32_t mux);
    std::uint16_t adjusted() const;

    avr_t* avr_;
    Voltage voltage_;
    std::uint16_t sampled_ = 0, result_ = 0;
    bool locked_ = false;  // between the reads of ADCL and ADCH
    SignalHook start_, end_;
    ReadHook low_, high_;
};

}  // namespace simulator
