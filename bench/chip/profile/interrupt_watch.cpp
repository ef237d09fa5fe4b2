// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/profile/interrupt_watch.hpp"

#include <sim_avr.h>

#include <algorithm>
#include <limits>

namespace profile {

// Every vector has two signals: one for its request, and one for whether its handler is running.
InterruptWatch::InterruptWatch(avr_t* core) : core_(core) {
    for_each_signal([](Vector& vector, avr_irq_t* signal, auto notify) {
        avr_irq_register_notify(signal, notify, &vector);
    });
}

InterruptWatch::~InterruptWatch() {
    for_each_signal([](Vector& vector, avr_irq_t* signal, auto notify) {
        avr_irq_unregister_notify(signal, notify, &vector);
    });
}

template <class Action>
void InterruptWatch::for_each_signal(Action action) {
    for (int i = 0; i < core_->interrupts.vector_count; ++i) {
        Vector& vector = vectors_.at(static_cast<std::size_t>(i));
        vector.watch = this;
        vector.index = i;
        avr_irq_t* const signals = core_->interrupts.vector[i]->irq;
        action(vector, signals + AVR_INT_IRQ_PENDING, &InterruptWatch::at_request);
        action(vector, signals + AVR_INT_IRQ_RUNNING, &InterruptWatch::at_running);
    }
}

void InterruptWatch::before_step() {
    entry_.reset();
    const auto* const timer = core_->cycle_timers.timer;
    next_event_ = timer ? timer->when : std::numeric_limits<simulator::Cycle>::max();
}

// simavr raises the flag's signal whether or not the interrupt is enabled, but not while it is
// already pending.
void InterruptWatch::at_request(avr_irq_t*, std::uint32_t raised, void* of) {
    Vector& vector = *static_cast<Vector*>(of);
    avr_t* const core = vector.watch->core_;
    vector.requested.reset();
    if (raised && avr_regbit_get(core, core->interrupts.vector[vector.index]->enable))
        vector.requested = std::min<simulator::Cycle>(core->cycle, vector.watch->next_event_);
}

void InterruptWatch::at_running(avr_irq_t*, std::uint32_t entered, void* of) {
    const Vector& vector = *static_cast<Vector*>(of);
    avr_t* const core = vector.watch->core_;
    if (entered)
        vector.watch->entry_ =
            Entry{core->interrupts.vector[vector.index]->vector, core->cycle, vector.requested};
}

}  // namespace profile
