// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/rivals/rivals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <list>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/lab/operands/operand_class.hpp"
#include "bench/lab/parallel.hpp"
#include "bench/lab/program/run.hpp"
#include "bench/lab/records/progress.hpp"
#include "bench/lab/records/record.hpp"
#include "bench/lab/subjects/footprint.hpp"
#include "bench/lab/subjects/measurement.hpp"
#include "bench/lab/subjects/witness.hpp"
#include "reference/judge.hpp"
#include "this_build.hpp"

namespace rivals {
namespace {

namespace fs = std::filesystem;
using records::column;
using reference::Operation;
using Operands = std::array<std::int64_t, reference::max_operands>;

const fs::path folder = source_folder() / "bench/experiments/rivals";

// A row of rivals.csv: a function of a rival on a class of operands.
struct Figures {
    std::string rival, variant, origin, version, commit, measured;
    std::string operation, format, operands;
    std::uint64_t samples, regular;
    std::optional<std::uint32_t> cycles_min;
    std::optional<double> cycles_mean;
    std::optional<std::uint32_t> cycles_max;
    std::optional<double> max_ulp;
    std::string max_ulp_witness;
    std::optional<double> rms_ulp, mean_ulp;
    std::optional<double> max_error, rms_error;  // in the unit of the result
    // Shares of the results that are this close to the exact value.
    std::optional<double> within_half_ulp, within_1_ulp, within_8_ulp;
    std::optional<int> flash_bytes, ram_bytes;
    std::optional<std::uint16_t> stack_bytes;
    std::string edges;    // the results for edge cases
    std::string failure;  // why it could not be measured completely

    static constexpr auto columns = std::tuple(
        column("rival", &Figures::rival), column("variant", &Figures::variant),
        column("origin", &Figures::origin), column("version", &Figures::version),
        column("commit", &Figures::commit), column("measured", &Figures::measured),
        column("operation", &Figures::operation), column("format", &Figures::format),
        column("operands", &Figures::operands), column("samples", &Figures::samples),
        column("regular", &Figures::regular), column("cycles_min", &Figures::cycles_min),
        column("cycles_mean", &Figures::cycles_mean), column("cycles_max", &Figures::cycles_max),
        column("max_ulp", &Figures::max_ulp), column("max_ulp_witness", &Figures::max_ulp_witness),
        column("rms_ulp", &Figures::rms_ulp), column("mean_ulp", &Figures::mean_ulp),
        column("max_error", &Figures::max_error), column("rms_error", &Figures::rms_error),
        column("within_half_ulp", &Figures::within_half_ulp),
        column("within_1_ulp", &Figures::within_1_ulp),
        column("within_8_ulp", &Figures::within_8_ulp),
        column("flash_bytes", &Figures::flash_bytes), column("ram_bytes", &Figures::ram_bytes),
        column("stack_bytes", &Figures::stack_bytes), column("edges", &Figures::edges),
        column("failure", &Figures::failure));
};

nlohmann::json manifest() {
    std::ifstream stream(folder / "rivals.json");
    return nlohmann::json::parse(stream);
}

// The output of build_rival.py. Throws its one line of error if it fails.
nlohmann::json build(const std::string& rival, const fs::path& source, const fs::path& scratch) {
    std::vector<std::string> arguments = {folder / "build_rival.py", rival, "--output", scratch};
    if (!source.empty()) arguments.insert(arguments.end(), {"--source", source});
    const fixbench::Ran ran = fixbench::run(arguments);
    if (!ran.succeeded) {
        const std::size_t end = ran.err.find_last_not_of('\n');
        throw std::invalid_argument(fmt::format("{}: {}", rival, ran.err.substr(0, end + 1)));
    }
    return nlohmann::json::parse(ran.out);
}

struct Case {
    const char* name;
    std::vector<std::int64_t> operands;
};

// Operands for which operations overflow or have no value.
std::vector<Case> edges_of(const reference::Subject& subject) {
    const reference::NumberFormat& format = subject.operand_format;
    const std::int64_t max = format.max(), min = format.min();
    // A whole number, or the nearest to it in a format with many fraction bits.
    const auto whole = [&](int number) {
        if (format.is_float()) return reference::raw_of_double(format, number);
        const double raw = std::ldexp(number, format.fraction);
        return raw >= double(max) ? max : raw <= double(min) ? min : std::int64_t(raw);
    };
    const std::int64_t one = whole(1), minus_one = whole(-1);
    switch (subject.operation) {
        case Operation::add:
            return {{"MAX + MAX", {max, max}}, {"MIN + MIN", {min, min}}};
        case Operation::subtract:
            return {{"MIN - MAX", {min, max}}, {"0 - MIN", {0, min}}};
        case Operation::multiply:
            return {{"MAX MAX", {max, max}}, {"MIN MAX", {min, max}}, {"MIN -1", {min, minus_one}}};
        case Operation::divide:
            return {{"1 / 0", {one, 0}},
                    {"-1 / 0", {minus_one, 0}},
                    {"0 / 0", {0, 0}},
                    {"MIN / -1", {min, minus_one}},
                    {"MAX / ulp", {max, 1}}};
        case Operation::remainder:
            return {{"1 mod 0", {one, 0}}};
        case Operation::sqrt:
            return {{"sqrt -1", {minus_one}}, {"sqrt MAX", {max}}};
        case Operation::log:
            return {{"log 0", {0}}, {"log -1", {minus_one}}};
        case Operation::log2:
        case Operation::log10:
            return {{"of 0", {0}}, {"of -1", {minus_one}}};
        case Operation::asin:
        case Operation::acos:
            return {{"of 2", {whole(2)}}, {"of -2", {whole(-2)}}};
        case Operation::exp:
            return {{"exp MAX", {max}}, {"exp MIN", {min}}};
        case Operation::pow:
            return {{"0^0", {0, 0}},
                    {"0^-1", {0, minus_one}},
                    {"(-1)^MAX", {minus_one, max}},
                    {"MAX^MAX", {max, max}}};
        case Operation::length2:
            return {{"(MAX, MAX)", {max, max}}};
        case Operation::multiply_add:
            return {{"MAX 1 + MAX", {max, one, max}}, {"MAX MAX + MIN", {max, max, min}}};
        case Operation::exp2:
        case Operation::sinh:
        case Operation::cosh:
        case Operation::tanh:
        case Operation::cbrt:
        case Operation::tan:
        case Operation::sin:
        case Operation::sin_turns:
        case Operation::cos_turns:
        case Operation::cos:
        case Operation::atan:
            return {{"of MAX", {max}}, {"of MIN", {min}}};
        case Operation::atan2:
            return {{"(0, 0)", {0, 0}}, {"(MIN, MIN)", {min, min}}, {"(0, -1)", {0, minus_one}}};
        default:
            return {};
    }
}

std::string number_text(const reference::NumberFormat& format, std::int64_t raw) {
    if (raw == format.max()) return "MAX";
    if (raw == format.min()) return "MIN";
    if (reference::is_nan(format, raw)) return "NaN";
    return fmt::format("{:.6g}", reference::to_double(format, raw));
}

// A function of a rival's program.
struct Subject {
    const simulator::Elf* program;
    std::string symbol;
    Figures known;  // everything that is not measured
};

template <class Use>
void with_call(const Subject& subject, Use&& use) {
    simulator::Chip chip(*subject.program);
    chip.run_until_function("main");
    operations::DeviceSubject call(chip, subject.symbol);
    use(call);
}

std::string edges_text(const Subject& subject) {
    const reference::Subject named = reference::parse_symbol(subject.symbol).subject;
    std::string text;
    for (const Case& each : edges_of(named)) {
        std::string result;
        try {
            with_call(subject, [&](operations::DeviceSubject& call) {
                result = number_text(named.format, call.call(each.operands).raws[0]);
            });
        } catch (const simulator::SimulationError&) {
            result = "does not return";
        }
        text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", each.name, result);
    }
    return text;
}

Figures measure(const Subject& subject, operands::OperandClass operand_class,
                std::uint64_t samples) {
    Figures figures = subject.known;
    figures.operands = operands::class_name(operand_class);
    figures.edges = edges_text(subject);
    operations::Measurement measurement;
    reference::ErrorStatistics errors;  // of results for which the exact value is in range
    std::array<std::uint64_t, 3> near{};
    try {
        with_call(subject, [&](operations::DeviceSubject& call) {
            const reference::Subject& named = call.named().subject;
            operands::Sampler sampler(named.operation, named.operand_format, operand_class, 1);
            Operands operands{};
            const std::span used(operands.data(), call.arity());
            for (std::uint64_t i = 0;
                 i < samples && measurement.cycles_sum < operations::measurement_cycles; ++i) {
                sampler.next(used);
                const operations::DeviceResult result = call.call(used);
                const reference::Judgement judgement = reference::judge(
                    named, used,
                    std::span(result.raws.data(), reference::shape(named.operation).results));
                measurement.add(used, result, judgement);
                if (!judgement.regular()) continue;
                errors.add(judgement, used);
                const double error = std::abs(judgement.error_ulp);
                near[0] += error <= 0.5;
                near[1] += error <= 1;
                near[2] += error <= 8;
            }
        });
    } catch (const simulator::SimulationError& error) {
        figures.failure = error.what();
    }
    figures.samples = measurement.samples;
    figures.regular = measurement.regular;
    if (measurement.samples == 0) return figures;
    figures.cycles_min = measurement.cycles_min;
    figures.cycles_mean = measurement.cycles_mean();
    figures.cycles_max = measurement.cycles_max;
    figures.stack_bytes = measurement.stack_bytes;
    if (measurement.regular == 0) return figures;
    figures.max_ulp = errors.max_ulp();
    figures.max_ulp_witness = operations::text_of(errors.max_witness());
    figures.rms_ulp = errors.rms_ulp();
    figures.mean_ulp = errors.mean_ulp();
    figures.max_error = measurement.max_error;
    figures.rms_error = measurement.rms_error();
    const auto share = [&](std::uint64_t count) {
        return static_cast<double>(count) / static_cast<double>(measurement.regular);
    };
    figures.within_half_ulp = share(near[0]);
    figures.within_1_ulp = share(near[1]);
    figures.within_8_ulp = share(near[2]);
    return figures;
}

std::map<std::string, operations::Footprint> footprints_of(fs::path program) {
    const auto table = records::Table::load(program.replace_extension(".footprints.csv"));
    std::map<std::string, operations::Footprint> footprints;
    for (operations::Footprint& each : records::rows_of<operations::Footprint>(table))
        footprints[each.subject] = std::move(each);
    return footprints;
}

// Replaces the rows of the same rivals by those of the present run. A row that is equal except for
// its date is kept.
records::Table joined(const records::Table& measured, const fs::path& kept) {
    const records::Table earlier =
        kept.empty() ? records::Table(measured.columns()) : records::Table::load(kept);
    if (earlier.columns() != measured.columns())
        throw std::invalid_argument(fmt::format(
            "the columns of {} are not those of the present rivals.csv", kept.string()));
    const std::size_t rival = measured.column("rival"), date = measured.column("measured");
    const auto undated = [&](std::vector<std::string> row) {
        row[date].clear();
        return row;
    };
    std::vector<std::vector<std::string>> rows = measured.rows();
    for (const auto& row : earlier.rows()) {
        const auto same = std::find_if(rows.begin(), rows.end(), [&](const auto& each) {
            return undated(each) == undated(row);
        });
        const bool again = std::any_of(measured.rows().begin(), measured.rows().end(),
                                       [&](const auto& each) { return each[rival] == row[rival]; });
        if (same != rows.end())
            *same = row;
        else if (!again)
            rows.push_back(row);
    }
    std::sort(rows.begin(), rows.end(),
              [&](const auto& a, const auto& b) { return undated(a) < undated(b); });
    records::Table table(measured.columns());
    for (auto& row : rows) table.add(std::move(row));
    return table;
}

}  // namespace

std::vector<std::string> known_rivals() {
    std::vector<std::string> names;
    const nlohmann::json rows = manifest();
    for (const auto& [name, row] : rows.items()) names.push_back(name);
    return names;
}

void measure_rivals(const Options& options) {
    std::list<simulator::Elf> programs;  // subjects point to them
    std::vector<Subject> subjects;
    const fs::path scratch = options.output / "rivals.build";
    struct Removed {
        fs::path folder;
        ~Removed() {
            std::error_code ignored;
            fs::remove_all(folder, ignored);
        }
    } const removed{scratch};
    const nlohmann::json rows = manifest();
    for (const auto& [name, row] : rows.items()) {
        const auto source = options.sources.find(name);
        if (row.contains("include") && source == options.sources.end()) continue;
        fs::create_directories(scratch);
        const nlohmann::json built =
            build(name, source == options.sources.end() ? fs::path() : source->second, scratch);
        for (const auto& [variant, path] : built["programs"].items()) {
            programs.emplace_back(path.get<std::string>());
            const auto footprints = footprints_of(path.get<std::string>());
            for (const std::string& symbol : operations::subjects_of(programs.back())) {
                const reference::NamedSubject named = reference::parse_symbol(symbol);
                Figures known{};
                known.rival = name;
                known.variant = variant;
                known.origin = row["origin"];
                known.version = built["version"];
                known.commit = built["commit"];
                known.measured = options.date;
                known.operation = reference::shape(named.subject.operation).name;
                known.format = reference::format_name(named.subject.format);
                if (const auto weight = footprints.find(symbol); weight != footprints.end()) {
                    known.flash_bytes = weight->second.flash_bytes;
                    known.ram_bytes = weight->second.ram_bytes;
                }
                subjects.push_back({&programs.back(), symbol, known});
            }
        }
    }

    constexpr operands::OperandClass classes[] = {operands::OperandClass::physics,
                                                  operands::OperandClass::full};
    std::vector<Figures> figures(subjects.size() * std::size(classes));
    records::Progress progress("rivals", figures.size());
    operations::in_parallel(options.threads, figures.size(), [&](std::size_t i) {
        figures[i] = measure(subjects[i / std::size(classes)], classes[i % std::size(classes)],
                             options.samples);
        progress.advance();
    });
    joined(records::table_of(figures), options.kept).save(options.output / "rivals.csv");
}

}  // namespace rivals
