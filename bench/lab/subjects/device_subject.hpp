// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of a device program as callables on raw numbers.
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
    std::array<std::int64_t, reference::max_results> raws;  // as many as the operation has results
    std::uint32_t cycles;
    std::uint16_t stack_bytes;
};

// A function of a program, called according to its signature.
class DeviceCall {
  public:
    // Throws simulator::SimulationError if the program has no such function.
    DeviceCall(simulator::Chip& chip, const std::string& symbol, Calling calling,
               const reference::NumberFormat& result_format);

    // Throws simulator::SimulationError if the call does not return or breaks the calling
    // convention.
    DeviceResult call(std::span<const std::int64_t> operands);

    // From now on, a call that writes outside its stack frame and its result fails, too.
    void forbid_stray_writes();

    void record(simulator::Coverage* coverage) { function_.record(coverage); }

  private:
    simulator::Chip& chip_;
    Calling calling_;
    reference::NumberFormat result_format_;
    std::uint16_t operands_address_;              // of vectors
    std::uint16_t result_size_, result_address_;  // of results returned through a pointer
    simulator::DeviceFunction function_;
};

// A function whose name says what it computes.
class DeviceSubject : public DeviceCall {
  public:
    // Throws std::invalid_argument unless the name is <operation>_<format>_<implementation>.
    DeviceSubject(simulator::Chip& chip, const std::string& symbol)
        : DeviceSubject(chip, symbol, reference::parse_symbol(symbol)) {}

    const std::string& symbol() const { return symbol_; }
    const reference::NamedSubject& named() const { return named_; }
    std::size_t arity() const { return reference::shape(named_.subject.operation).operands; }

  private:
    DeviceSubject(simulator::Chip& chip, const std::string& symbol, reference::NamedSubject named)
        : DeviceCall(chip, symbol, calling_of(named.subject), named.subject.format),
          symbol_(symbol),
          named_(std::move(named)) {}

    std::string symbol_;
    reference::NamedSubject named_;
};

// The symbols of a program that name subjects, sorted.
std::vector<std::string> subjects_of(const simulator::Elf& elf);

}  // namespace operations
