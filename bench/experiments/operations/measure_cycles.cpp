// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/operations/measure_cycles.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>

#include "bench/chip/instructions/fingerprint.hpp"
#include "bench/lab/catalogue/catalogue.hpp"
#include "bench/lab/operands/boundary.hpp"
#include "bench/lab/operands/closest_ties.hpp"
#include "bench/lab/operands/operand_class.hpp"
#include "bench/lab/parallel.hpp"
#include "bench/lab/records/benchmark_json.hpp"
#include "bench/lab/records/progress.hpp"
#include "bench/lab/records/record.hpp"
#include "bench/lab/records/whole_file.hpp"
#include "bench/lab/subjects/device_subject.hpp"
#include "bench/lab/subjects/footprint.hpp"
#include "bench/lab/subjects/host_subject.hpp"
#include "bench/lab/subjects/measurement.hpp"
#include "bench/lab/subjects/witness.hpp"
#include "reference/error_statistics.hpp"
#include "reference/judge.hpp"

namespace operations {

namespace {

using Operands = std::array<std::int64_t, reference::max_operands>;

using records::column;

// A row of operations.csv.
struct Figures {
    std::string operation, format, implementation, operands;
    std::uint64_t samples, regular;  // regular: Judgement::regular()
    std::uint32_t cycles_min;
    double cycles_mean;  // over the regular operands, or over all if none is regular
    std::uint32_t cycles_max;
    std::string cycles_max_witness;
    // Errors are missing if no result was judged.
    std::optional<double> max_ulp;
    std::string max_ulp_witness;
    std::optional<double> rms_ulp;
    std::optional<int> flash_bytes;  // if the program's footprints are known
    std::uint16_t stack_bytes;
    std::optional<double> mean_ulp;
    std::optional<int> ram_bytes;
    std::uint64_t violations;
    std::optional<double> max_error, rms_error;
    std::string kernel_sha256;  // empty if the linker did not keep relocations

    static constexpr auto columns = std::tuple(
        column("operation", &Figures::operation), column("format", &Figures::format),
        column("implementation", &Figures::implementation), column("operands", &Figures::operands),
        column("samples", &Figures::samples), column("regular", &Figures::regular),
        column("cycles_min", &Figures::cycles_min), column("cycles_mean", &Figures::cycles_mean),
        column("cycles_max", &Figures::cycles_max),
        column("cycles_max_witness", &Figures::cycles_max_witness),
        column("max_ulp", &Figures::max_ulp), column("max_ulp_witness", &Figures::max_ulp_witness),
        column("rms_ulp", &Figures::rms_ulp), column("flash_bytes", &Figures::flash_bytes),
        column("stack_bytes", &Figures::stack_bytes), column("mean_ulp", &Figures::mean_ulp),
        column("ram_bytes", &Figures::ram_bytes), column("violations", &Figures::violations),
        column("max_error", &Figures::max_error), column("rms_error", &Figures::rms_error),
        column("kernel_sha256", &Figures::kernel_sha256));
};

// One measurement: a subject on a class of operands.
struct Row : Measurement {
    const simulator::Elf* program;
    std::string subject;
    reference::NamedSubject named;
    std::string operands;
    std::string failure{};  // why it could not be measured completely

    Row(const simulator::Elf* program, const std::string& subject,
        const reference::NamedSubject& named, const std::string& operands)
        : program(program), subject(subject), named(named), operands(operands) {}

    void add(std::span<const std::int64_t> operands, const DeviceResult& result) {
        const std::span results(result.raws.data(),
                                reference::shape(named.subject.operation).results);
        const reference::Judgement judgement = reference::judge(named.subject, operands, results);
        Measurement::add(operands, result, judgement);
    }
};

// The same operands for every implementation of an operation.
std::uint64_t seed_of(reference::Operation operation, std::string_view operand_class) {
    std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
    for (const std::string_view text : {reference::shape(operation).name, operand_class}) {
        for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    }
    return hash;
}

void run_all_inputs(DeviceSubject& subject, Row& row) {
    const int width = row.named.subject.operand_format.width;
    const std::uint64_t count = std::uint64_t(1) << (width * subject.arity());
    Operands operands{};
    const std::span used(operands.data(), subject.arity());
    for (std::uint64_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < used.size(); ++k) {
            used[k] = row.named.subject.operand_format.extend(i >> (k * width));
        }
        row.add(used, subject.call(used));
    }
}

// At most `samples` cases, thinned evenly: a 64-bit format has over 100000 pairs. Those next to a
// tie are never left out.
void run_boundary(DeviceSubject& subject, Row& row, std::uint64_t samples) {
    const std::vector<operands::BoundaryCase> cases =
        operands::boundary_cases(row.named.subject.operation, row.named.subject.operand_format);
    const std::uint64_t taken = std::min<std::uint64_t>(samples, cases.size());
    for (std::uint64_t i = 0; i < taken; ++i) {
        const operands::BoundaryCase& each = cases[i * cases.size() / taken];
        row.add(each.operands, subject.call(each.operands));
    }
    for (const operands::BoundaryCase& each : operands::closest_ties(row.named.subject))
        row.add(each.operands, subject.call(each.operands));
}

void run_class(DeviceSubject& subject, Row& row, operands::OperandClass operand_class,
               std::uint64_t samples) {
    const reference::Subject& judged = row.named.subject;
    operands::Sampler sampler(judged.operation, judged.operand_format, operand_class,
                              seed_of(judged.operation, row.operands));
    Operands operands{};
    const std::span used(operands.data(), subject.arity());
    for (std::uint64_t i = operands::distinct_samples(operand_class, samples);
         i > 0 && row.cycles_sum < measurement_cycles; --i) {
        sampler.next(used);
        row.add(used, subject.call(used));
    }
}

void run(simulator::Chip& chip, Row& row, std::uint64_t samples) {
    DeviceSubject subject(chip, row.subject);
    subject.forbid_stray_writes();
    if (row.operands == "all") {
        run_all_inputs(subject, row);
    } else if (row.operands == "boundary") {
        run_boundary(subject, row, samples);
    } else {
        run_class(subject, row, operands::parse_class(row.operands), samples);
    }
}

void add_rows(std::vector<Row>& rows, const simulator::Elf& program, const Selection& selection) {
    for (const std::string& name : subjects_of(program)) {
        const reference::NamedSubject named = reference::parse_symbol(name);
        if (!selection.selects(named.subject, named.implementation)) continue;
        std::vector<std::string> classes;
        for (const operands::OperandClass each : operands::operand_classes) {
            classes.emplace_back(operands::class_name(each));
        }
        classes.emplace_back("boundary");
        const int bits = named.subject.operand_format.width *
                         static_cast<int>(reference::shape(named.subject.operation).operands);
        if (bits <= all_inputs_bits) classes.emplace_back("all");
        for (const std::string& operand_class : classes) {
            if (!selection.selects_operands(operand_class)) continue;
            rows.emplace_back(&program, name, named, operand_class);
        }
    }
}

using Footprints = std::map<std::string, Footprint>;

void load_footprints(Footprints& footprints, std::filesystem::path program) {
    const std::filesystem::path path = program.replace_extension(".footprints.csv");
    if (!std::filesystem::exists(path)) return;
    for (Footprint& each : records::rows_of<Footprint>(records::Table::load(path)))
        footprints[each.subject] = std::move(each);
}

// A row of flash.csv: the flash of a program that uses several operations of the format in the
// implementation. `operations` is "nine" or "own", as in bench/device/link_subjects.py.
struct Flash {
    std::string operations, format, implementation;
    int flash_bytes, ram_bytes;

    static constexpr auto columns = std::tuple(
        column("operations", &Flash::operations), column("format", &Flash::format),
        column("implementation", &Flash::implementation),
        column("flash_bytes", &Flash::flash_bytes), column("ram_bytes", &Flash::ram_bytes));
};

std::vector<Flash> flash_of(const Footprints& footprints) {
    std::vector<Flash> programs;
    for (const auto& [name, footprint] : footprints) {
        for (const std::string operations : {"nine", "own"}) {
            if (!name.starts_with(operations + '_')) continue;
            // Format and implementation are spelled as those of a subject.
            const reference::NamedSubject named =
                reference::parse_symbol("add" + name.substr(operations.size()));
            programs.push_back({operations, reference::format_name(named.subject.format),
                                named.implementation, footprint.flash_bytes, footprint.ram_bytes});
        }
    }
    return programs;
}

// The hash of the code of each subject.
std::map<std::string, std::string> kernel_hashes(const std::vector<Row>& rows) {
    std::map<std::string, std::string> hashes;
    for (const Row& row : rows) {
        const auto [entry, fresh] = hashes.emplace(row.subject, "");
        if (!fresh) continue;
        try {
            entry->second = instructions::fingerprint(*row.program, row.subject);
        } catch (const instructions::TranslationError&) {
            // A program from elsewhere: it is measured without a hash.
        }
    }
    return hashes;
}

std::vector<Figures> figures_of(const std::vector<Row>& rows, const Footprints& footprints) {
    const std::map<std::string, std::string> hashes = kernel_hashes(rows);
    std::vector<Figures> figures;
    for (const Row& row : rows) {
        const auto footprint = footprints.find(row.subject);
        const auto bytes = [&](int Footprint::*kind) {
            return footprint == footprints.end() ? std::nullopt
                                                 : std::optional(footprint->second.*kind);
        };
        const auto judged = [&](double error) {
            return row.errors.count() > 0 ? std::optional(error) : std::nullopt;
        };
        // A result that is neither pinned nor below half an ulp has a magnitude by which formats
        // can be compared.
        const auto regular = [&](double error) {
            return row.regular > 0 ? std::optional(error) : std::nullopt;
        };
        figures.push_back({operation_name(row.named.subject),
                           reference::format_name(row.named.subject.format),
                           row.named.implementation,
                           row.operands,
                           row.samples,
                           row.regular,
                           row.cycles_min,
                           row.cycles_mean(),
                           row.cycles_max,
                           text_of(row.cycles_max_witness),
                           judged(row.errors.max_ulp()),
                           text_of(row.errors.max_witness()),
                           judged(row.errors.rms_ulp()),
                           bytes(&Footprint::flash_bytes),
                           row.stack_bytes,
                           judged(row.errors.mean_ulp()),
                           bytes(&Footprint::ram_bytes),
                           row.errors.wrong(),
                           regular(row.max_error),
                           regular(row.rms_error()),
                           hashes.at(row.subject)});
    }
    return figures;
}

std::string json_of(const std::vector<Row>& rows, const std::vector<simulator::Elf>& programs) {
    std::vector<records::SimulatedBenchmark> benchmarks;
    for (const Row& row : rows) {
        benchmarks.push_back({row.subject + "/" + row.operands,
                              row.samples,
                              row.cycles_mean(),
                              {{"cycles_min", row.cycles_min},
                               {"cycles_max", row.cycles_max},
                               {"max_ulp", row.errors.max_ulp()},
                               {"rms_ulp", row.errors.rms_ulp()},
                               {"stack_bytes", row.stack_bytes}}});
    }
    nlohmann::json hashes;
    for (const simulator::Elf& program : programs) {
        hashes[program.path().filename().string()] = program.sha256();
    }
    return records::benchmark_document(benchmarks, {{"sha256", hashes}}).dump(1) + "\n";
}

}  // namespace

std::uint64_t measure_cycles(const CycleOptions& options) {
    const std::vector<simulator::Elf> programs(options.programs.begin(), options.programs.end());
    Footprints footprints;
    std::vector<Row> rows;
    for (const simulator::Elf& program : programs) {
        load_footprints(footprints, program.path());
        add_rows(rows, program, options.selection);
    }
    if (rows.empty()) throw std::invalid_argument("no subject of the device programs is selected");

    records::Progress progress("cycles", rows.size());
    in_parallel(options.threads, rows.size(), [&](std::size_t i) {
        try {
            simulator::Chip chip(*rows[i].program);
            chip.run_until_function("main");
            run(chip, rows[i], options.samples);
        } catch (const simulator::SimulationError& error) {
            rows[i].failure = error.what();
        }
        progress.advance();
    });

    std::uint64_t violations = 0;
    for (const Row& row : rows) {
        if (row.failure.empty()) continue;
        ++violations;
        fmt::print(stderr, "{}: {} operands: {}\n", row.subject, row.operands, row.failure);
    }
    std::erase_if(rows, [](const Row& row) { return !row.failure.empty(); });
    for (const Row& row : rows) {
        if (row.errors.wrong() == 0 || !catalogue::is_held_to_its_definition(row.named)) continue;
        violations += row.errors.wrong();
        fmt::print(
            stderr,
            "{}: the results of {} of {} {} operands contradict the definition, the first: {}\n",
            row.subject, row.errors.wrong(), row.samples, row.operands,
            text_of(row.errors.wrong_witness()));
    }
    records::table_of(figures_of(rows, footprints)).save(options.output / "operations.csv");
    records::table_of(flash_of(footprints)).save(options.output / "flash.csv");
    records::write_whole(options.output / "operations.json", json_of(rows, programs));
    return violations;
}

}  // namespace operations
