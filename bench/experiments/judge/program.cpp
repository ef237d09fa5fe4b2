// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/judge/program.hpp"

#include <cxxabi.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cstdlib>
#include <map>
#include <stdexcept>

#include "bench/chip/simulator/convention.hpp"
#include "bench/lab/parallel.hpp"
#include "bench/lab/program/names.hpp"

namespace judge {
namespace {

using operations::DeviceCall;
using operations::DeviceResult;
using operations::Measurement;
using Operands = std::array<std::int64_t, reference::max_operands>;

constexpr std::uint64_t seed = 1;

// "my_sqrt" for "my_sqrt(long)" and "ns::my_sqrt<int>(long)"; for C the symbol itself.
std::string plain_name(const std::string& symbol) {
    int status = 0;
    char* const demangled = abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status);
    const std::string name = status == 0 ? demangled : symbol;
    std::free(demangled);
    return name.substr(0, name.find('('));
}

std::string symbol_of(const simulator::Elf& elf, const std::string& function) {
    if (elf.has_function(function)) return function;
    std::vector<std::string> found, known;
    for (const auto& [symbol, unused] : elf.functions()) {
        known.push_back(plain_name(symbol));
        if (known.back() == function) found.push_back(symbol);
    }
    if (found.size() == 1) return found.front();
    if (found.size() > 1)
        throw std::invalid_argument(fmt::format("{} has several functions {}: name one of {}",
                                                elf.path().filename().string(), function,
                                                fmt::join(found, ", ")));
    const std::string nearest = fixbench::nearest_name(function, known);
    throw std::invalid_argument(fmt::format(
        "{} has no function {}{}: where the source has it, the compiler inlined it or the linker "
        "dropped it; __attribute__((noinline)) and the linker's -Wl,-u,{} keep it",
        elf.path().filename().string(), function,
        nearest.empty() ? "" : fmt::format(", did you mean {}?", nearest), function));
}

// A function that takes other operands than it is given reads registers that do not contain any,
// whose value differs in each call. A function that returns fewer bytes leaves registers of the
// result unchanged. Empty if neither is observed.
std::string signature_fault(DeviceCall& call, const Claim& claim) {
    constexpr int trials = 64;
    const std::size_t arity = claim.operands().size();
    const simulator::Frame frame = simulator::frame_of(claim.calling().signature);
    const auto sampler = claim.sampler(operands::OperandClass::uniform, seed);
    std::array<bool, 8> kept;
    kept.fill(true);
    Operands operands{};
    const std::span used(operands.data(), arity);
    for (int trial = 0; trial < trials; ++trial) {
        sampler->next(used);
        const DeviceResult first = call.call(used), second = call.call(used);
        for (std::size_t i = 0; i < claim.results(); ++i)
            if (first.raws[i] != second.raws[i])
                return fmt::format(
                    "the operands {} gave {} and then {}: the function reads registers that hold "
                    "no operand of the claim, returns less than the claim says, or keeps a state",
                    text_of(claim, used), claim.result().number(first.raws[i]),
                    claim.result().number(second.raws[i]));
        for (int byte = 0; byte < frame.result.size; ++byte) {
            bool same = false;
            for (std::size_t i = 0; i < frame.operands.size() && frame.operands.size() == arity;
                 ++i) {
                const int offset = frame.result.address + byte - frame.operands[i].address;
                if (offset >= 0 && offset < frame.operands[i].size)
                    same = std::uint8_t(used[i] >> 8 * offset) ==
                           std::uint8_t(first.raws[0] >> 8 * byte);
            }
            kept[std::size_t(byte)] &= same;
        }
    }
    for (int byte = 0; byte < frame.result.size; ++byte)
        if (kept[std::size_t(byte)])
            return fmt::format(
                "r{} holds a byte of the claim's result, and the function never changes it: it "
                "returns less than the claim says",
                frame.result.address + byte);
    return "";
}

void measure(DeviceCall& call, const Claim& claim, const std::string& operand_class,
             std::uint64_t samples, Measurement& measurement) {
    const auto add = [&](std::span<const std::int64_t> operands) {
        const DeviceResult result = call.call(operands);
        const std::span results(result.raws.data(), claim.results());
        measurement.add(operands, result, claim.judge(operands, results));
    };
    Operands operands{};
    const std::span used(operands.data(), claim.operands().size());
    if (operand_class == "all") {
        for (std::uint64_t i = 0; i < std::uint64_t(1) << claim.input_bits(); ++i) {
            claim.input(i, used);
            add(used);
        }
    } else if (operand_class == "boundary") {
        const auto cases = claim.boundary_cases();
        const std::uint64_t taken = std::min<std::uint64_t>(samples, cases.size());
        for (std::uint64_t i = 0; i < taken; ++i) add(cases[i * cases.size() / taken].operands);
    } else {
        const operands::OperandClass each = operands::parse_class(operand_class);
        const auto sampler = claim.sampler(each, seed);
        for (std::uint64_t i = operands::distinct_samples(each, samples);
             i > 0 && measurement.cycles_sum < operations::measurement_cycles; --i) {
            sampler->next(used);
            add(used);
        }
    }
}

std::vector<std::string> classes_of(const Claim& claim) {
    std::vector<std::string> classes;
    for (const operands::OperandClass each : operands::operand_classes)
        if (each != operands::OperandClass::published)
            classes.emplace_back(operands::class_name(each));
    classes.emplace_back("boundary");
    if (claim.input_bits() <= operations::all_inputs_bits) classes.emplace_back("all");
    return classes;
}

}  // namespace

Figures figures_of(const Claim& claim, const reference::ErrorStatistics& errors) {
    const auto judged = [&](double error) {
        return errors.count() > 0 ? std::optional(error) : std::nullopt;
    };
    Figures figures{};
    figures.max_ulp = judged(errors.max_ulp());
    figures.max_ulp_witness = text_of(claim, errors.max_witness().operands());
    figures.rms_ulp = judged(errors.rms_ulp());
    figures.mean_ulp = judged(errors.mean_ulp());
    figures.bound = "lower bound";
    figures.excluded = errors.excluded();
    figures.violations = errors.wrong();
    figures.first_violation = text_of(claim, errors.wrong_witness().operands());
    return figures;
}

std::uint64_t judge_program(const ProgramOptions& options) {
    const auto claim = parse_claim(options.claim, options.bound_ulp);
    const simulator::Elf elf(options.program);
    const std::string symbol = symbol_of(elf, options.function);
    const std::vector<std::string> classes = classes_of(*claim);

    const auto with_call = [&](auto&& use) {
        simulator::Chip chip(elf);
        chip.run_until_function("main");
        DeviceCall call(chip, symbol, claim->calling(), claim->result().format);
        call.forbid_stray_writes();
        use(call);
    };
    std::string fault;
    try {
        with_call([&](DeviceCall& call) { fault = signature_fault(call, *claim); });
        if (!fault.empty()) fault = fmt::format("{}: {}", options.function, fault);
    } catch (const simulator::SimulationError& error) {
        fault = fmt::format("{} misbehaves: {}", options.function, error.what());
    }
    std::vector<Measurement> measurements(fault.empty() ? classes.size() : 0);
    std::vector<std::string> failures(measurements.size());
    operations::in_parallel(options.threads, measurements.size(), [&](std::size_t i) {
        try {
            with_call([&](DeviceCall& call) {
                measure(call, *claim, classes[i], options.samples, measurements[i]);
            });
        } catch (const simulator::SimulationError& error) {
            failures[i] = fmt::format("{} misbehaves: {}", options.function, error.what());
        }
    });

    std::uint64_t wrong = 0;
    std::vector<Figures> rows;
    for (std::size_t i = 0; i < measurements.size(); ++i) {
        if (!failures[i].empty()) {
            if (fault.empty()) fault = failures[i];
            continue;
        }
        const Measurement& measured = measurements[i];
        Figures row = figures_of(*claim, measured.errors);
        row.function = options.function;
        row.claim = options.claim;
        row.operands = classes[i];
        if (classes[i] == "all") row.bound = "exact";
        row.samples = measured.samples;
        row.regular = measured.regular;
        row.cycles_min = measured.cycles_min;
        row.cycles_mean = measured.cycles_mean();
        row.cycles_max = measured.cycles_max;
        row.cycles_max_witness = text_of(*claim, measured.cycles_max_witness.operands());
        row.stack_bytes = measured.stack_bytes;
        wrong += row.violations;
        rows.push_back(std::move(row));
    }
    if (!fault.empty()) {
        ++wrong;
        fmt::print(stderr, "fixbench: {}\n", fault);
    }
    if (!rows.empty()) records::table_of(rows).save(options.output / "judge.csv");
    return wrong;
}

}  // namespace judge
