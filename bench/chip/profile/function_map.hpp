// SPDX-License-Identifier: GPL-3.0-or-later
// Which function of a program an instruction belongs to, by the symbols of its ELF file. Inlined
// code belongs to the function that it was inlined into.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/chip/simulator/elf.hpp"

namespace profile {

// An interrupt vector of the ATmega328P as avr-libc names it, e.g. 11 is "TIMER1_COMPA_vect".
std::string_view vector_name(int vector);
constexpr int vector_count = 26;  // reset, which is vector 0, included

struct Function {
    std::string symbol;     // as in the ELF file
    std::string name;       // for a reader: demangled; __vector_11 is TIMER1_COMPA_vect
    std::uint32_t address;  // of the first instruction
};

class FunctionMap {
  public:
    using Index = std::uint16_t;
    // Code that no symbol covers; the time asleep; the vector table and what runs before main().
    static constexpr Index unnamed = 0, asleep = 1, start_up = 2;

    explicit FunctionMap(const simulator::Elf& elf);

    Index at(std::uint32_t flash_address) const { return by_word_[flash_address / 2]; }
    std::size_t size() const { return functions_.size(); }
    const Function& operator[](Index index) const { return functions_[index]; }

    // Where an interrupt's handler begins: behind the jump in the vector table.
    std::uint32_t handler(int vector) const { return handlers_[static_cast<std::size_t>(vector)]; }

    // "name", or "name+6" for an address within the function.
    std::string describe(std::uint32_t flash_address) const;

  private:
    std::vector<Function> functions_;
    std::vector<Index> by_word_;
    std::vector<std::uint32_t> handlers_;
};

}  // namespace profile
