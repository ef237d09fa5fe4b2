// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/operations/verify_kernels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <string>

#include "bench/lab/operands/boundary.hpp"
#include "bench/lab/operands/closest_ties.hpp"
#include "bench/lab/operands/operand_class.hpp"
#include "bench/lab/parallel.hpp"
#include "bench/lab/records/progress.hpp"
#include "bench/lab/records/record.hpp"
#include "bench/lab/subjects/device_subject.hpp"
#include "bench/lab/subjects/host_subject.hpp"
#include "bench/lab/subjects/witness.hpp"

namespace operations {

namespace {

using records::column;
using Operands = std::array<std::int64_t, reference::max_operands>;

// The cycles that the boundary cases of a subject may take, and as many for all its inputs or its
// random operands: functions without a kernel cost up to half a million cycles a call.
constexpr std::uint64_t cycle_budget = 100'000'000;

// Log-uniform operands reach every binade, uniform ones every pattern of bits.
constexpr operands::OperandClass random_classes[] = {
    operands::OperandClass::physics, operands::OperandClass::full, operands::OperandClass::uniform};

struct Comparison {
    const simulator::Elf* program;
    const HostSubject* host;
    std::uint64_t compared = 0;
    std::uint64_t cycles = 0;
    std::uint64_t mismatches = 0;
    bool all = false;  // all inputs were compared
    reference::Witness first_mismatch{};
    simulator::Coverage coverage{};
    std::string failure{};  // why it could not be compared completely
};

// A row of kernels.csv.
struct Kernel {
    std::string operation, format, implementation;
    std::string inputs;
    std::uint64_t compared, mismatches;
    std::string first_mismatch;
    std::size_t instructions_unreached;

    static constexpr auto columns = std::tuple(
        column("operation", &Kernel::operation), column("format", &Kernel::format),
        column("implementation", &Kernel::implementation), column("inputs", &Kernel::inputs),
        column("compared", &Kernel::compared), column("mismatches", &Kernel::mismatches),
        column("first_mismatch", &Kernel::first_mismatch),
        column("instructions_unreached", &Kernel::instructions_unreached));
};

void compare(DeviceSubject& device, Comparison& comparison, Raws operands) {
    const std::size_t results = reference::shape(comparison.host->subject.operation).results;
    std::array<std::int64_t, reference::max_results> expected{};
    comparison.host->evaluate(operands, std::span(expected).first(results));
    const DeviceResult result = device.call(operands);
    ++comparison.compared;
    comparison.cycles += result.cycles;
    if (std::equal(result.raws.begin(), result.raws.begin() + results, expected.begin())) return;
    if (comparison.mismatches++ == 0) comparison.first_mismatch = reference::Witness(operands);
}

void run(Comparison& comparison, std::uint64_t samples) {
    simulator::Chip chip(*comparison.program);
    chip.run_until_function("main");
    DeviceSubject device(chip, comparison.host->name());
    device.record(&comparison.coverage);
    device.forbid_stray_writes();
    const reference::Subject& subject = comparison.host->subject;
    const std::vector<operands::BoundaryCase> boundary =
        operands::boundary_cases(subject.operation, subject.operand_format);
    const auto call_evenly = [&](std::uint64_t count) {
        for (std::uint64_t i = 0; i < count; ++i)
            compare(device, comparison, boundary[i * boundary.size() / count].operands);
    };
    // As many as the budget allows, by the cost of a few: slow functions have over 100000 pairs.
    const std::uint64_t wanted = std::min<std::uint64_t>(boundary.size(), samples),
                        few = std::min<std::uint64_t>(wanted, 64);
    call_evenly(few);
    if (comparison.cycles > 0)
        call_evenly(std::min(wanted, cycle_budget * few / comparison.cycles));
    for (const operands::BoundaryCase& each : operands::closest_ties(subject))
        compare(device, comparison, each.operands);
    Operands operands{};
    const std::span used(operands.data(), device.arity());
    const int bits = comparison.host->input_bits();
    const std::uint64_t mean = comparison.cycles / std::max<std::uint64_t>(comparison.compared, 1);
    comparison.all = bits <= 16 && mean << bits <= cycle_budget;
    if (comparison.all) {
        for (std::uint64_t i = 0; i < std::uint64_t(1) << bits; ++i) {
            for (std::size_t k = 0; k < used.size(); ++k) {
                used[k] = subject.operand_format.extend(i >> (k * subject.operand_format.width));
            }
            compare(device, comparison, used);
        }
        return;
    }
    for (const operands::OperandClass each : random_classes) {
        operands::Sampler sampler(subject.operation, subject.operand_format, each, 2);
        const std::uint64_t limit = comparison.cycles + cycle_budget / std::size(random_classes);
        for (std::uint64_t i = 0;
             i < samples / std::size(random_classes) && comparison.cycles < limit; ++i) {
            sampler.next(used);
            compare(device, comparison, used);
        }
    }
}

}  // namespace

std::uint64_t verify_kernels(const VerifyOptions& options) {
    const std::vector<simulator::Elf> programs(options.programs.begin(), options.programs.end());
    std::vector<Comparison> comparisons;
    for (const HostSubject& host : host_subjects()) {
        if (!options.selection.selects(host.subject, host.implementation)) continue;
        for (const simulator::Elf& program : programs) {
            if (program.has_function(host.name())) {
                comparisons.push_back({.program = &program, .host = &host});
            }
        }
    }
    if (comparisons.empty())
        throw std::invalid_argument("no subject that the host has is selected");

    records::Progress progress("machine code against the host", comparisons.size());
    in_parallel(options.threads, comparisons.size(), [&](std::size_t i) {
        try {
            run(comparisons[i], options.samples);
        } catch (const simulator::SimulationError& error) {
            comparisons[i].failure = error.what();
        }
        progress.advance();
    });

    // Functions share code, as the cosine uses the sine's: code reached by one counts for all.
    std::map<const simulator::Elf*, simulator::Coverage> coverage;
    for (const Comparison& each : comparisons) coverage[each.program].merge(each.coverage);

    std::uint64_t failures = 0;
    for (const Comparison& each : comparisons) {
        if (each.failure.empty()) continue;
        ++failures;
        fmt::print(stderr, "{}\n", each.failure);
    }
    std::erase_if(comparisons, [](const Comparison& each) { return !each.failure.empty(); });
    std::vector<Kernel> kernels;
    for (const Comparison& each : comparisons) {
        const simulator::Elf& program = *each.program;
        const std::size_t unreached =
            coverage[&program].missed(program, program.function(each.host->name())).size();
        kernels.push_back(
            {operation_name(each.host->subject), reference::format_name(each.host->subject.format),
             each.host->implementation, each.all ? "all" : "boundary, random", each.compared,
             each.mismatches, text_of(each.first_mismatch), unreached});
        if (each.mismatches != 0) {
            ++failures;
            fmt::print(stderr, "{}: {} of {} results differ from the host, the first: {}\n",
                       each.host->name(), each.mismatches, each.compared,
                       text_of(each.first_mismatch));
        }
    }
    records::table_of(kernels).save(options.output / "kernels.csv");
    return failures;
}

}  // namespace operations
