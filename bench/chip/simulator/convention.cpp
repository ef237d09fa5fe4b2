// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/simulator/convention.hpp"

#include "bench/chip/simulator/elf.hpp"

namespace simulator {
namespace {

constexpr int behind_last_register = 26, first_register = 8;

int even(int size) { return size + size % 2; }

}  // namespace

Frame frame_of(const Signature& signature) {
    Frame frame{};
    int next_register = behind_last_register, stack_bytes = 0;
    for (const int size : signature.operands) {
        next_register -= even(size);
        if (next_register < first_register) {
            next_register = 0;
            stack_bytes += size;
        }
        frame.operands.push_back({static_cast<std::uint16_t>(next_register), size});
    }
    int address = static_cast<int>(Elf::ram_end) - stack_bytes;
    frame.entry_stack_pointer = static_cast<std::uint16_t>(address - return_address_size - 1);
    for (Place& place : frame.operands) {
        if (place.address) continue;
        place.address = static_cast<std::uint16_t>(address);
        address += place.size;
    }
    frame.result = {static_cast<std::uint16_t>(behind_last_register - even(signature.result)),
                    signature.result};
    return frame;
}

}  // namespace simulator
