// SPDX-License-Identifier: GPL-3.0-or-later
// How a subject of the device program is called: scalars by value; each vector by a pointer;
// several results through a pointer, the last argument; counts of shifts as bytes.
#pragma once

#include "bench/chip/instructions/translate.hpp"
#include "bench/chip/simulator/convention.hpp"
#include "reference/operation.hpp"

namespace operations {

struct Calling {
    simulator::Signature signature;  // in which a pointer counts as an operand
    instructions::Pointers pointers;
};

Calling calling_of(const reference::Subject& subject);

}  // namespace operations
