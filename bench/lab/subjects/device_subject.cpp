// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/subjects/device_subject.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

namespace operations {

DeviceCall::DeviceCall(simulator::Chip& chip, const std::string& symbol, Calling calling,
                       const reference::NumberFormat& result_format)
    : chip_(chip),
      calling_(std::move(calling)),
      result_format_(result_format),
      operands_address_(chip.allocate(
          static_cast<std::uint16_t>(calling_.pointers.vectors * calling_.pointers.elements *
                                     calling_.pointers.element_size))),
      result_size_(
          static_cast<std::uint16_t>(calling_.pointers.results * calling_.pointers.result_size)),
      result_address_(chip.allocate(result_size_)),
      function_(chip, symbol, calling_.signature) {}

void DeviceCall::forbid_stray_writes() {
    std::vector<simulator::DeviceFunction::Area> writable;
    if (result_size_) writable.push_back({result_address_, result_size_});
    function_.forbid_writes_except(std::move(writable));
}

DeviceResult DeviceCall::call(std::span<const std::int64_t> operands) {
    const instructions::Pointers& pointers = calling_.pointers;
    std::array<std::uint64_t, reference::max_operands + 1> arguments;
    std::size_t count = 0;
    if (pointers.vectors) {
        const auto bytes = static_cast<std::size_t>(pointers.element_size);
        for (std::size_t i = 0; i < operands.size(); ++i) {
            const auto low_bytes = reinterpret_cast<const std::uint8_t*>(&operands[i]);
            chip_.write(static_cast<std::uint16_t>(operands_address_ + i * bytes),
                        {low_bytes, bytes});
        }
        for (std::size_t i = 0; i < pointers.vectors; ++i)
            arguments[count++] = operands_address_ + i * pointers.elements * bytes;
    } else {
        for (const std::int64_t operand : operands)
            arguments[count++] = static_cast<std::uint64_t>(operand);
    }
    if (result_size_) arguments[count++] = result_address_;

    const simulator::Outcome outcome = [&] {
        try {
            return function_.call({arguments.data(), count});
        } catch (const simulator::SimulationError& error) {
            throw simulator::SimulationError(
                fmt::format("{}, with the operands {}", error.what(), fmt::join(operands, " ")));
        }
    }();
    DeviceResult result{{}, outcome.cycles, outcome.stack_bytes};
    if (!result_size_) {
        result.raws[0] = result_format_.extend(outcome.result);
        return result;
    }
    const auto bytes = static_cast<std::size_t>(pointers.result_size);
    for (std::size_t i = 0; i < pointers.results; ++i) {
        std::uint64_t pattern = 0;
        chip_.read(static_cast<std::uint16_t>(result_address_ + i * bytes),
                   {reinterpret_cast<std::uint8_t*>(&pattern), bytes});
        result.raws[i] = result_format_.extend(pattern);
    }
    return result;
}

std::vector<std::string> subjects_of(const simulator::Elf& elf) {
    std::vector<std::string> subjects;
    for (const auto& [name, symbol] : elf.functions()) {
        try {
            reference::parse_symbol(name);
            subjects.push_back(name);
        } catch (const std::invalid_argument&) {
            // Not a subject: start-up code, a library routine, or a kernel under its own name.
        }
    }
    return subjects;
}

}  // namespace operations
