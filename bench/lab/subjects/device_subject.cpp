// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/subjects/device_subject.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

namespace operations {

namespace {

using reference::Operation;

constexpr int pointer = 2;

std::uint16_t size_of_operands(const reference::Subject& subject) {
    return static_cast<std::uint16_t>(reference::shape(subject.operation).operands *
                                      subject.format.width / 8);
}

std::uint16_t size_of_results(const reference::Subject& subject) {
    return static_cast<std::uint16_t>(reference::shape(subject.operation).results *
                                      subject.format.width / 8);
}

simulator::Signature signature_of(const reference::Subject& subject) {
    const reference::OperationShape& shape = reference::shape(subject.operation);
    const int bytes = subject.format.width / 8;
    const int operand_bytes = subject.operand_format.width / 8;
    simulator::Signature signature{shape.results > 1 ? 0 : bytes, {}};
    if (const std::size_t vectors = reference::vector_operands(subject.operation)) {
        signature.operands.assign(vectors, pointer);
    } else {
        signature.operands.assign(shape.operands, operand_bytes);
        const bool shifts = subject.operation == Operation::shift_left ||
                            subject.operation == Operation::shift_right;
        if (shifts) signature.operands[1] = 1;
    }
    if (shape.results > 1) signature.operands.push_back(pointer);
    return signature;
}

}  // namespace

DeviceSubject::DeviceSubject(simulator::Chip& chip, const std::string& symbol)
    : chip_(chip),
      symbol_(symbol),
      named_(reference::parse_symbol(symbol)),
      by_pointer_(reference::vector_operands(named_.subject.operation) > 0),
      result_in_memory_(reference::shape(named_.subject.operation).results > 1),
      operands_address_(by_pointer_ ? chip.allocate(size_of_operands(named_.subject)) : 0),
      result_address_(result_in_memory_ ? chip.allocate(size_of_results(named_.subject)) : 0),
      function_(chip, symbol, signature_of(named_.subject)) {}

void DeviceSubject::forbid_stray_writes() {
    std::vector<simulator::DeviceFunction::Area> writable;
    if (result_in_memory_) writable.push_back({result_address_, size_of_results(named_.subject)});
    function_.forbid_writes_except(std::move(writable));
}

DeviceResult DeviceSubject::call(std::span<const std::int64_t> operands) {
    const reference::Subject& subject = named_.subject;
    const int bytes = subject.format.width / 8;
    std::array<std::uint64_t, reference::most_operands + 1> arguments;
    std::size_t count = 0;
    if (by_pointer_) {
        for (std::size_t i = 0; i < operands.size(); ++i) {
            const auto low_bytes = reinterpret_cast<const std::uint8_t*>(&operands[i]);
            chip_.write(static_cast<std::uint16_t>(operands_address_ + i * bytes),
                        {low_bytes, static_cast<std::size_t>(bytes)});
        }
        const std::size_t vectors = reference::vector_operands(subject.operation);
        for (std::size_t i = 0; i < vectors; ++i) {
            arguments[count++] = operands_address_ + operands.size() / vectors * i * bytes;
        }
    } else {
        for (const std::int64_t operand : operands) {
            arguments[count++] = static_cast<std::uint64_t>(operand);
        }
    }
    if (result_in_memory_) arguments[count++] = result_address_;

    const simulator::Outcome outcome = [&] {
        try {
            return function_.call({arguments.data(), count});
        } catch (const simulator::SimulationError& error) {
            throw simulator::SimulationError(
                fmt::format("{}, of the operands {}", error.what(), fmt::join(operands, " ")));
        }
    }();
    DeviceResult result{{}, outcome.cycles, outcome.stack_bytes};
    if (result_in_memory_) {
        const std::size_t results = reference::shape(subject.operation).results;
        for (std::size_t i = 0; i < results; ++i) {
            std::uint64_t pattern = 0;
            chip_.read(
                static_cast<std::uint16_t>(result_address_ + i * bytes),
                {reinterpret_cast<std::uint8_t*>(&pattern), static_cast<std::size_t>(bytes)});
            result.raws[i] = subject.format.sign_extend(pattern);
        }
    } else {
        result.raws[0] = subject.format.sign_extend(outcome.result);
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
            // Not a subject: start-up code, a library routine, a kernel under its own name.
        }
    }
    return subjects;
}

}  // namespace operations
