// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <list>

#include "bench/chip/simulator/hooks.hpp"

namespace simulator {

// The compare registers of Timer1 in fast PWM with ICR1 as TOP (mode 14).
//
// simavr: the compare times are computed when the mode is set; later writes to OCR1A or OCR1B are
// ignored. Hardware: OCR1x is double-buffered and takes effect at the next BOTTOM (data sheet,
// "Fast PWM Mode"). simavr schedules a period's compare matches at its BOTTOM, so it suffices to
// store the new time.
class Timer1Compare {
  public:
    explicit Timer1Compare(avr_t* avr);

  private:
    std::list<WriteHook> hooks_;
};

}  // namespace simulator
