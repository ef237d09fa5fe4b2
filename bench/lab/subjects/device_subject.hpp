// SPDX-License-Identifier: GPL-3.0-or-later
// A subject of the device program as a callable on raw numbers: knows from the symbol's name what
// the function takes and returns.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "bench/chip/simulator/chip.hpp"
#include "bench/chip/simulator/device_function.hpp"
#include "bench/lab/subjects/calling.hpp"
#include "reference/operation.hpp"

namespace operations {

struct DeviceResult {
    std::array<std::int64_t, reference::most_results> raws;  // as many as the operation has results
    std::uint32_t cycles;
    std::uint16_t stack_bytes;
};

class DeviceSubject {
  public:
    // Throws std::invalid_argument where the name is not <operation>_<format>_<implementation>,
    // simulator::SimulationError where the program has no such function.
    DeviceSubject(simulator::Chip& chip, const std::string& symbol);

    const std::string& symbol() const { return symbol_; }
    const reference::NamedSubject& named() const { return named_; }
    std::size_t arity() const { return reference::shape(named_.subject.operation).operands; }

    // Throws simulator::SimulationError where the call does not return or breaks the convention.
    DeviceResult call(std::span<const std::int64_t> operands);

    // From now on a call also fails that writes outside of its stack frame and its result.
    void forbid_stray_writes();

    void record(simulator::Coverage* coverage) { function_.record(coverage); }

  private:
    simulator::Chip& chip_;
    std::string symbol_;
    reference::NamedSubject named_;
    Calling calling_;
    std::uint16_t operands_address_;              // of vectors
    std::uint16_t result_size_, result_address_;  // of results that go through a pointer
    simulator::DeviceFunction function_;
};

// The symbols of a program that name subjects, sorted.
std::vector<std::string> subjects_of(const simulator::Elf& elf);

}  // namespace operations
