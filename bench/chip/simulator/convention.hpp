// SPDX-License-Identifier: GPL-3.0-or-later
// avr-gcc's calling convention: where a function finds its operands, where it leaves its result and
// what it must leave as it was. The only description of it; whoever calls a function, in the
// simulator or translated, places operands by it. Source: GCC wiki, "avr-gcc", "Calling
// Convention".
#pragma once

#include <cstdint>
#include <vector>

namespace simulator {

// Sizes in bytes: 1, 2 (also pointers), 4 or 8; 0 is a function that returns nothing.
struct Signature {
    int result;
    std::vector<int> operands;
};

// Bytes in data space, where the registers r0..r31 are the addresses 0..31.
struct Place {
    std::uint16_t address;
    int size;

    bool in_registers() const { return address < 32; }
    std::uint16_t end() const { return static_cast<std::uint16_t>(address + size); }
};

constexpr int pointer_size = 2, return_address_size = 2;
constexpr int call_cycles = 4;    // of `call`, which a function's cycles include
constexpr int zero_register = 1;  // r1 is zero at entry and at return

// r2..r17 and Y, which a function has to leave as they were.
constexpr bool is_call_saved(int number) {
    return (number >= 2 && number <= 17) || number == 28 || number == 29;
}

// Operands go from r25 downwards, each to an even register; from the first one that would begin
// below r8 on, all go onto the stack, the first at the lowest address, without padding. A result
// ends at r25, and begins at an even register.
struct Frame {
    std::vector<Place> operands;
    Place result;
    std::uint16_t entry_stack_pointer;  // below the return address

    std::uint16_t caller_stack_pointer() const {
        return static_cast<std::uint16_t>(entry_stack_pointer + return_address_size);
    }
};

// Of a caller whose stack is empty.
Frame frame_of(const Signature& signature);

}  // namespace simulator
