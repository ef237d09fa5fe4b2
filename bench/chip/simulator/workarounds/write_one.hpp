// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <list>

#include "bench/chip/simulator/hooks.hpp"

namespace simulator {

// Registers in which writing a one has an effect and writing a zero has none: the timers' interrupt
// flags TIFRn (a one clears the flag) and PINx (a one toggles the output).
//
// simavr: any write to TIFRn clears all of its flags that are set, and `sbi` writes back all the
// ones that it read. Hardware: only the bits written as one have an effect (data sheet, "TIFR1"),
// and `sbi` affects its one bit only ("Register Summary", note 3; "Toggling the Pin").
class WriteOneRegisters {
  public:
    explicit WriteOneRegisters(avr_t* avr);

  private:
    std::list<WriteHook> hooks_;
};

}  // namespace simulator
