// SPDX-License-Identifier: GPL-3.0-or-later
// avr-gcc's calling convention: where a function finds its operands, where it leaves its result and
// what it must preserve. This is the only description of it: every caller of a function, simulated
// or translated, places operands by it. Source: GCC wiki, "avr-gcc", "Calling Convention".
#pragma once

#include <cstdint>
#include <vector>

namespace simulator {

// Sizes in bytes: 1, 2 (also pointers), 3, 4 or 8. A result of 0 bytes means that there is none.
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
constexpr int call_cycles = 4;    // of `call`, included in a function's cycles
constexpr int zero_register = 1;  // r1 is zero at entry and at return

// r2..r17 and Y, which a function must preserve.
constexpr bool is_call_saved(int number) {
    return (number >= 2 && number <= 17) || number == 28 || number == 29;
}

// Operands go from r25 downwards, each to an even register. From the first one that would start
// below r8, all go onto the stack, the first at the lowest address, without padding. A result ends
// at r25 and starts at an even register.
struct Frame {
    std::vector<Place> operands;
    Place result;
    std::uint16_t entry_stack_pointer;  // below the return address

    std::uint16_t caller_stack_pointer() const {
        return static_cast<std::uint16_t>(entry_stack_pointer + return_address_size);
    }
};

// For a caller whose stack is empty.
Frame frame_of(const Signature& signature);

}  // namespace simulator
