// SPDX-License-Identifier: GPL-3.0-or-later
// avr-gcc's calling convention: where a function finds its operands and leaves its results.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/operation.hpp"

namespace machine_code {

// Bytes in data space, where the registers r0..r31 are the addresses 0..31.
struct Place {
    std::uint16_t address;
    int size;

    bool in_registers() const { return address < 32; }
    std::uint16_t end() const { return std::uint16_t(address + size); }
};

struct Convention {
    std::vector<Place> operands, results;  // of each raw
    struct Pointer {
        Place place;
        std::uint16_t value;
    };
    std::vector<Pointer> pointers;  // operands that say where the raws lie
    Place operand_area, result_area;
    std::uint16_t entry_stack_pointer;  // below the return address
};

// Of a function of plain numbers, by their sizes in bytes; result 0 is none.
Convention convention_of(const std::vector<int>& operand_sizes, int result_size);

// Of a subject: scalars by value; vectors by a pointer each, several results through a pointer that
// comes last.
Convention convention_of(const reference::Subject& subject);

}  // namespace machine_code
