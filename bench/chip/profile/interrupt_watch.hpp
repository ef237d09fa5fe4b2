// SPDX-License-Identifier: GPL-3.0-or-later
// Observes when a chip's interrupts are requested and served, by the signals that simavr raises per
// vector.
//
// An interrupt is requested in the cycle in which its flag rises while it is enabled, or in which
// it is enabled while its flag is set. The global interrupt flag (SREG's I) does not matter.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "bench/chip/profile/function_map.hpp"
#include "bench/chip/simulator/chip.hpp"

struct avr_irq_t;

namespace profile {

class InterruptWatch {
  public:
    explicit InterruptWatch(avr_t* core);
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;

    struct Entry {
        int vector;
        simulator::Cycle begin;                     // of the entry's own four cycles
        std::optional<simulator::Cycle> requested;  // none if that was before the watch started
    };

    // Must be called before each step of the chip. simavr serves a peripheral's event after the
    // instruction during which it falls due; this records when that is.
    void before_step();

    // The interrupt that was entered in the last step; there is at most one.
    const std::optional<Entry>& entry() const { return entry_; }

  private:
    struct Vector {
        InterruptWatch* watch;
        int index;  // in simavr's table
        std::optional<simulator::Cycle> requested;
    };
    template <class Action>
    void for_each_signal(Action action);
    static void at_request(avr_irq_t*, std::uint32_t raised, void* vector);
    static void at_running(avr_irq_t*, std::uint32_t entered, void* vector);

    avr_t* core_;
    simulator::Cycle next_event_ = 0;
    std::optional<Entry> entry_;
    std::array<Vector, vector_count> vectors_{};
};

}  // namespace profile
