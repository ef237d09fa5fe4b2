// SPDX-License-Identifier: MIT
// The hook of the checked arithmetic under test, which remembers what was reported to it.
#pragma once

#include <fixedpoint/arithmetic/checked.hpp>

#include "numbers.hpp"

using fixedpoint::Event;
using fixedpoint::Operation;

struct Hook {
    static uint8_t calls;
    static Event event;
    static Operation operation;
    static void notify(Event event_, Operation operation_) {
        if (event_ == Event::underflow) return;  // not in the tables of the tests
        ++calls;
        event = event_;
        operation = operation_;
    }
};

// Whether the hook was called as expected since the last call of this function.
inline bool hooked(bool expected, Event event, Operation operation) {
    const uint8_t calls = Hook::calls;
    Hook::calls = 0;
    return expected ? calls == 1 && Hook::event == event && Hook::operation == operation
                    : calls == 0;
}

using Checked = fixedpoint::Checked<Hook>;

inline fixedpoint::Fixed<INTEGER_BITS, FRACTION_BITS, Checked> checked(Raw raw) {
    return fixedpoint::Fixed<INTEGER_BITS, FRACTION_BITS, Checked>::from_raw(operand(raw).raw());
}
