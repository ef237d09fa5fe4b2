// SPDX-License-Identifier: GPL-3.0-or-later
// A program of tests/device/ in the simulated chip, and its variables by name.
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "bench/chip/simulator/chip.hpp"
#include "this_build.hpp"

class DeviceProgram {
  public:
    explicit DeviceProgram(const std::string& name)
        : chip(simulator::Elf(build_folder() / "firmware" / ("firmware_" + name + ".elf"))) {}

    // The address of a variable by its name; of a static member, by a part of its mangled name.
    std::uint16_t address_of(const std::string& name) const {
        for (const auto& [symbol, object] : chip.elf().objects())
            if (symbol == name || symbol.ends_with(name + "E"))
                return static_cast<std::uint16_t>(object.address);
        throw std::runtime_error("the program has no variable " + name);
    }
    template <class T>
    T get(const std::string& name, int index = 0) const {
        T value;
        chip.read(address_of(name) + index * sizeof(T),
                  std::span(reinterpret_cast<std::uint8_t*>(&value), sizeof value));
        return value;
    }
    template <class T>
    void set(const std::string& name, T value, int index = 0) {
        chip.write(address_of(name) + index * sizeof(T),
                   std::span(reinterpret_cast<const std::uint8_t*>(&value), sizeof value));
    }
    void run_for(double seconds) {
        chip.run_until_cycle(chip.cycle() +
                             static_cast<simulator::Cycle>(seconds * simulator::Chip::frequency));
    }

    // Runs to the end of the function that has just been entered. Returns its cycles without those
    // of interrupts that occurred meanwhile.
    simulator::Cycle cycles_of_function() {
        if (handlers_.empty())
            for (const auto& [name, function] : chip.elf().functions())
                if (name.starts_with("__vector_")) handlers_.insert(function.address);
        const auto begin = chip.cycle();
        const auto stack = chip.stack_pointer();
        simulator::Cycle interrupts = 0;
        chip.step();
        chip.run_until([&] {
            if (handlers_.count(chip.program_counter())) {
                const auto entered = chip.cycle();
                const auto inner = chip.stack_pointer();
                chip.run_until([&] { return chip.stack_pointer() == inner + 2; });
                interrupts += interrupt_entry + chip.cycle() - entered;
            }
            return chip.stack_pointer() == stack + 2;
        });
        return chip.cycle() - begin - interrupts;
    }
    // Before a handler's first instruction: the entry, and the jump in the vector table.
    static constexpr unsigned interrupt_entry = 4 + 3;

    simulator::Chip chip;

  private:
    std::set<std::uint32_t> handlers_;
};
