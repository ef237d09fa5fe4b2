// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <list>

#include "bench/chip/simulator/hooks.hpp"

namespace simulator {

// Registers in which writing a one acts and writing a zero does nothing: the timers' interrupt
// flags TIFRn (a one clears the flag) and PINx (a one toggles the output).
//
// simavr: any write to TIFRn clears all of its flags that are set, and `sbi` writes back all the
// ones that it read. Hardware: only the bits that are written one act (data sheet, "TIFR1"), and
// `sbi` operates on its one bit alone ("Register Summary", note 3; "Toggling the Pin").
class WriteOneRegisters {
  public:
    explicit WriteOneRegisters(avr_t* avr);

  private:
    std::list<WriteHook> hooks_;
};

}  // namespace simulator
