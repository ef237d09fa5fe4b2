// SPDX-License-Identifier: GPL-3.0-or-later
// How a subject of the device program is called: scalars by value; vectors by a pointer each;
// several results through a pointer that comes last; counts of shifts as bytes.
#pragma once

#include "bench/chip/instructions/translate.hpp"
#include "bench/chip/simulator/convention.hpp"
#include "reference/operation.hpp"

namespace operations {

struct Calling {
    simulator::Signature signature;  // in which a pointer is an operand
    instructions::Pointers pointers;
};

Calling calling_of(const reference::Subject& subject);

}  // namespace operations
