// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/operations/measure_other_chips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "bench/chip/simulator/chip.hpp"
#include "bench/chip/simulator/other_chip.hpp"
#include "bench/lab/operands/boundary.hpp"
#include "bench/lab/operands/operand_class.hpp"
#include "bench/lab/parallel.hpp"
#include "bench/lab/records/progress.hpp"
#include "bench/lab/records/record.hpp"
#include "bench/lab/subjects/calling.hpp"
#include "bench/lab/subjects/host_subject.hpp"
#include "reference/judge.hpp"

namespace operations {
namespace {

using records::column;

// A row of other_chips.csv.
struct Row {
    std::string chip, operation, format, implementation, operands;
    std::uint64_t samples = 0;
    std::uint32_t cycles_min = std::numeric_limits<std::uint32_t>::max();
    double cycles_mean = 0;  // over the regular operands, or over all if none is regular
    std::uint32_t cycles_max = 0;
    int flash_bytes = 0;  // the growth of a program that uses only this function
    std::uint64_t violations = 0;

    static constexpr auto columns =
        std::tuple(column("chip", &Row::chip), column("operation", &Row::operation),
                   column("format", &Row::format), column("implementation", &Row::implementation),
                   column("operands", &Row::operands), column("samples", &Row::samples),
                   column("cycles_min", &Row::cycles_min), column("cycles_mean", &Row::cycles_mean),
                   column("cycles_max", &Row::cycles_max), column("flash_bytes", &Row::flash_bytes),
                   column("violations", &Row::violations));
};

// A row of programs.csv: a program that uses only one subject.
struct Program {
    std::string subject;
    std::optional<int> flash_bytes;  // if it fits the chip

    static constexpr auto columns = std::tuple(column("subject", &Program::subject),
                                               column("flash_bytes", &Program::flash_bytes));
};

struct Task {
    std::filesystem::path program;
    reference::NamedSubject named;
    Row row;
    std::string failure{};
};

// A subject as a callable on raw numbers.
class Subject {
  public:
    Subject(const Task& task)
        : chip_(task.row.chip, task.program),
          symbol_(task.program.stem()),
          subject_(task.named.subject),
          calling_(calling_of(subject_)),
          operands_(chip_.allocate(vector_bytes())),
          results_(chip_.allocate(calling_.pointers.results * result_size())) {}

    std::uint32_t call(std::span<const std::int64_t> operands, std::span<std::int64_t> results) {
        const instructions::Pointers& pointers = calling_.pointers;
        const auto bytes = static_cast<std::size_t>(pointers.element_size);
        std::vector<std::uint64_t> arguments(operands.begin(), operands.end());
        if (pointers.vectors) {
            for (std::size_t i = 0; i < operands.size(); ++i)
                std::memcpy(chip_.data() + operands_ + i * bytes, &operands[i], bytes);
            arguments.clear();
            for (std::size_t i = 0; i < pointers.vectors; ++i)
                arguments.push_back(operands_ + i * pointers.elements * bytes);
        }
        if (pointers.results) arguments.push_back(results_);
        const auto outcome = chip_.call(symbol_, calling_.signature, arguments);
        for (std::size_t i = 0; i < results.size(); ++i) {
            std::uint64_t pattern = outcome.result;
            if (pointers.results)
                std::memcpy(&pattern, chip_.data() + results_ + i * result_size(), result_size());
            results[i] = subject_.format.extend(pattern);
        }
        return outcome.cycles;
    }

  private:
    std::size_t result_size() const { return calling_.pointers.result_size; }
    std::size_t vector_bytes() const {
        const instructions::Pointers& pointers = calling_.pointers;
        return pointers.vectors * pointers.elements * pointers.element_size;
    }

    simulator::OtherChip chip_;
    std::string symbol_;
    const reference::Subject& subject_;
    Calling calling_;
    std::uint16_t operands_, results_;
};

void run(Task& task, std::uint64_t samples) {
    Subject subject(task);
    const reference::Subject& judged = task.named.subject;
    const reference::OperationShape& shape = reference::shape(judged.operation);
    std::uint64_t cycles_sum = 0, regular = 0, regular_cycles_sum = 0;
    const auto measure = [&](std::span<const std::int64_t> operands) {
        std::array<std::int64_t, reference::max_results> results{};
        const std::span used(results.data(), shape.results);
        const std::uint32_t cycles = subject.call(operands, used);
        Row& row = task.row;
        ++row.samples;
        row.cycles_min = std::min(row.cycles_min, cycles);
        row.cycles_max = std::max(row.cycles_max, cycles);
        cycles_sum += cycles;
        const reference::Judgement judgement = reference::judge(judged, operands, used);
        row.violations += judgement.excluded == nullptr && !judgement.as_defined;
        if (!judgement.regular()) return;
        ++regular;
        regular_cycles_sum += cycles;
    };
    if (task.row.operands == "boundary") {
        const std::vector<operands::BoundaryCase> cases =
            operands::boundary_cases(judged.operation, judged.operand_format);
        const std::uint64_t taken = std::min<std::uint64_t>(samples, cases.size());
        for (std::uint64_t i = 0; i < taken; ++i) measure(cases[i * cases.size() / taken].operands);
    } else {
        const operands::OperandClass drawn = operands::parse_class(task.row.operands);
        operands::Sampler sampler(judged.operation, judged.operand_format, drawn, 1);
        std::array<std::int64_t, reference::max_operands> operands{};
        const std::span used(operands.data(), shape.operands);
        for (std::uint64_t i = operands::distinct_samples(drawn, samples); i > 0; --i) {
            sampler.next(used);
            measure(used);
        }
    }
    task.row.cycles_mean =
        regular > 0 ? static_cast<double>(regular_cycles_sum) / static_cast<double>(regular)
                    : static_cast<double>(cycles_sum) / static_cast<double>(task.row.samples);
}

void add_tasks(std::vector<Task>& tasks, const std::string& chip,
               const std::filesystem::path& folder, const Selection& selection) {
    for (const Program& program :
         records::rows_of<Program>(records::Table::load(folder / "programs.csv"))) {
        const reference::NamedSubject named = reference::parse_symbol(program.subject);
        if (!selection.selects(named.subject, named.implementation)) continue;
        if (!program.flash_bytes) {
            fmt::print(stderr, "{}: does not fit the {}\n", program.subject, chip);
            continue;
        }
        for (const std::string& operands : other_chip_operands) {
            if (!selection.selects_operands(operands)) continue;
            Task task{folder / (program.subject + ".elf"), named, {}};
            task.row.chip = chip;
            task.row.operation = operation_name(named.subject);
            task.row.format = reference::format_name(named.subject.format);
            task.row.implementation = named.implementation;
            task.row.operands = operands;
            task.row.flash_bytes = *program.flash_bytes;
            tasks.push_back(std::move(task));
        }
    }
}

}  // namespace

std::uint64_t measure_other_chips(const OtherChipOptions& options) {
    std::vector<Task> tasks;
    for (const std::string& chip : options.chips)
        for (const std::string& format : options.selection.formats)
            add_tasks(tasks, chip, options.programs / chip / format, options.selection);
    if (tasks.empty()) throw std::invalid_argument("no subject of the other chips is selected");

    records::Progress progress("cycles", tasks.size());
    in_parallel(options.threads, tasks.size(), [&](std::size_t i) {
        try {
            run(tasks[i], options.samples);
        } catch (const simulator::SimulationError& error) {
            tasks[i].failure = error.what();
        }
        progress.advance();
    });

    std::uint64_t violations = 0;
    std::vector<Row> rows;
    for (Task& task : tasks) {
        if (!task.failure.empty()) {
            ++violations;
            fmt::print(stderr, "{}: {}, {} operands: {}\n", task.program.stem().string(),
                       task.row.chip, task.row.operands, task.failure);
            continue;
        }
        if (task.row.violations > 0)
            fmt::print(stderr,
                       "{}: {}: the results of {} of {} {} operands contradict the definition\n",
                       task.program.stem().string(), task.row.chip, task.row.violations,
                       task.row.samples, task.row.operands);
        violations += task.row.violations;
        rows.push_back(std::move(task.row));
    }
    records::table_of(rows).save(options.output / "other_chips.csv");
    return violations;
}

}  // namespace operations
