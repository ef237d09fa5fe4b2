// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/operations/measure_accuracy.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/lab/operands/boundary.hpp"
#include "bench/lab/operands/operand_class.hpp"
#include "bench/lab/operands/search.hpp"
#include "bench/lab/parallel.hpp"
#include "bench/lab/records/csv.hpp"
#include "bench/lab/records/progress.hpp"
#include "bench/lab/subjects/host_subject.hpp"
#include "bench/lab/subjects/witness.hpp"
#include "reference/error_statistics.hpp"

namespace operations {

namespace {

using reference::ErrorStatistics;
using reference::NumberFormat;

using Operands = std::array<std::int64_t, reference::most_operands>;

// The quick run exhausts spaces of up to 2^24 inputs, the full one those of 2^32 that matter.
constexpr int quick_exhaustive_bits = 24;

constexpr std::uint64_t random_samples = 2'000'000, quick_random_samples = 20'000;
constexpr std::uint64_t search_evaluations = 4'000'000, quick_search_evaluations = 40'000;

ErrorStatistics exhaust_in_parallel(const HostSubject& job, unsigned threads) {
    std::vector<ErrorStatistics> results(exhaustive_parts);
    records::Progress progress(job.name(), exhaustive_parts);
    in_parallel(threads, exhaustive_parts, [&](std::size_t part) {
        results[part] = job.exhaust(part);
        progress.advance();
    });
    ErrorStatistics statistics;
    for (const ErrorStatistics& result : results) statistics.merge(result);
    return statistics;
}

// Boundary table, random operands of every class, and a climb towards the largest error.
ErrorStatistics sample(const HostSubject& job, bool quick) {
    ErrorStatistics statistics;
    records::Progress progress(job.name(), 1);
    for (const operands::BoundaryCase& each :
         operands::boundary_cases(job.subject.operation, job.subject.operand_format)) {
        statistics.add(job.judge(each.operands), each.operands);
    }
    Operands operands{};
    const std::span used(operands.data(), reference::shape(job.subject.operation).operands);
    for (const operands::OperandClass each : operands::operand_classes) {
        operands::Sampler sampler(job.subject.operation, job.subject.operand_format, each, 1);
        const std::uint64_t wanted = quick ? quick_random_samples : random_samples;
        for (std::uint64_t i = operands::distinct_samples(each, wanted); i > 0; --i) {
            sampler.next(used);
            statistics.add(job.judge(used), used);
        }
    }
    const auto worst = operands::search_worst(
        job.subject.operation, job.subject.operand_format,
        quick ? quick_search_evaluations : search_evaluations, 1,
        [&](std::span<const std::int64_t> each) { return std::abs(job.judge(each).error_ulp); });
    statistics.add(job.judge(worst.operands), worst.operands);
    return statistics;
}

bool is_exhaustive(const HostSubject& job, bool quick) {
    if (!job.exhaust) return false;
    if (job.input_bits <= quick_exhaustive_bits) return true;
    if (quick) return false;
    // 2^32 inputs: for the default's operations, and for the report's product and quotient. Lengths
    // are bounded by construction, sincos is sin and cos, and 2^32 floats would take the exact
    // judge half a day.
    const reference::Subject& subject = job.subject;
    if (subject.format.is_float() || subject.operand_format.is_float()) return false;
    if (job.implementation == "published") {
        return subject.operation == reference::Operation::multiply ||
               subject.operation == reference::Operation::divide;
    }
    return job.implementation == "default" && subject.operation != reference::Operation::length2 &&
           subject.operation != reference::Operation::sincos;
}

void add_histogram(records::Table& table, const HostSubject& job,
                   const ErrorStatistics& statistics) {
    const gsl_histogram& histogram = statistics.histogram();
    const auto add = [&](double low, double high, double count) {
        if (count == 0) return;
        table.add({operation_name(job.subject), reference::format_name(job.subject.format),
                   job.implementation, records::cell(low), records::cell(high),
                   records::cell(count)});
    };
    add(-INFINITY, histogram.range[0], static_cast<double>(statistics.below_histogram()));
    for (std::size_t i = 0; i < histogram.n; ++i) {
        add(histogram.range[i], histogram.range[i + 1], histogram.bin[i]);
    }
    add(histogram.range[histogram.n], INFINITY, static_cast<double>(statistics.above_histogram()));
}

// What an earlier run wrote of a subject: found by the first three columns.
class Kept {
  public:
    explicit Kept(const std::filesystem::path& folder)
        : accuracy_(records::Table::load(folder / "accuracy.csv")),
          histograms_(records::Table::load(folder / "error_histograms.csv")) {}

    // The row of the subject, where all inputs were run.
    const std::vector<std::string>* row(const HostSubject& job) const {
        for (const auto& row : accuracy_.rows())
            if (is_of(row, job) && row[accuracy_.column("bound")] == "exact") return &row;
        return nullptr;
    }

    // Adds the rows of the subject, once they agree with the code as it is: it errs as it did at
    // the operands of the largest error, and at no sample by more.
    void add(const HostSubject& job, records::Table& accuracy, records::Table& histograms) const {
        const std::vector<std::string>& kept = *row(job);
        const std::string largest = kept[accuracy_.column("max_ulp")];
        std::vector<std::int64_t> witness;
        std::istringstream words(kept[accuracy_.column("max_ulp_witness")]);
        for (std::int64_t raw; words >> raw;) witness.push_back(raw);
        const auto stale = [&](const std::string& reason) {
            throw std::runtime_error(
                fmt::format("{}: the row that is kept of all inputs is not of this code: {}; "
                            "`fixbench all --exhaustive --only accuracy` runs them again",
                            job.name(), reason));
        };
        if (witness.size() != reference::shape(job.subject.operation).operands)
            stale("it names no operands");
        const double there = std::abs(job.judge(witness).error_ulp);
        if (records::cell(there) != largest)
            stale(fmt::format("at {} it errs by {} ulp, not {}",
                              kept[accuracy_.column("max_ulp_witness")], records::cell(there),
                              largest));
        const ErrorStatistics samples = sample(job, true);
        if (samples.wrong() != 0)
            stale(fmt::format("{} breaks the definition", text_of(samples.wrong_witness())));
        if (samples.max_ulp() > there)
            stale(fmt::format("at {} it errs by {} ulp, and {} was the most",
                              text_of(samples.max_witness()), records::cell(samples.max_ulp()),
                              largest));
        accuracy.add(kept);
        for (const auto& row : histograms_.rows())
            if (is_of(row, job)) histograms.add(row);
    }

  private:
    static bool is_of(const std::vector<std::string>& row, const HostSubject& job) {
        return row[0] == operation_name(job.subject) &&
               row[1] == reference::format_name(job.subject.format) && row[2] == job.implementation;
    }

    records::Table accuracy_, histograms_;
};

// The largest and the rms error in each of many intervals of the input, log-spaced.
void add_along_input(records::Table& table, const HostSubject& job) {
    constexpr int intervals_per_octave = 8;
    constexpr std::uint64_t samples = 2000;
    const NumberFormat& format = job.subject.format;
    double low = 1;
    while (low < static_cast<double>(format.max())) {
        const double high = low * std::exp2(1.0 / intervals_per_octave);
        const auto first = static_cast<std::int64_t>(std::ceil(low));
        const auto last =
            static_cast<std::int64_t>(std::min(high, static_cast<double>(format.max())));
        if (last >= first) {
            const std::uint64_t count = static_cast<std::uint64_t>(last - first) + 1;
            const std::uint64_t taken = std::min(count, samples);
            ErrorStatistics statistics;
            for (std::uint64_t i = 0; i < taken; ++i) {
                const std::int64_t operand = first + static_cast<std::int64_t>(i * count / taken);
                statistics.add(job.judge({&operand, 1}), {&operand, 1});
            }
            table.add({operation_name(job.subject), reference::format_name(format),
                       job.implementation, records::cell(std::ldexp(low, -format.fraction)),
                       records::cell(std::ldexp(high, -format.fraction)), fmt::to_string(taken),
                       records::cell(statistics.max_ulp()), records::cell(statistics.rms_ulp()),
                       records::cell(statistics.mean_ulp())});
        }
        low = high;
    }
}

}  // namespace

std::uint64_t measure_accuracy(const AccuracyOptions& options) {
    std::vector<HostSubject> jobs;
    for (const HostSubject& each : host_subjects()) {
        if (each.same_as_default) continue;
        if (options.selection.selects(each.subject, each.implementation)) jobs.push_back(each);
    }
    if (jobs.empty()) throw std::invalid_argument("no subject of the host is selected");

    records::Table accuracy({"operation", "format", "implementation", "inputs", "samples",
                             "defined", "max_ulp", "max_ulp_witness", "rms_ulp", "mean_ulp",
                             "bound", "violations"});
    records::Table histograms(
        {"operation", "format", "implementation", "low_ulp", "high_ulp", "count"});
    records::Table along({"operation", "format", "implementation", "low", "high", "samples",
                          "max_ulp", "rms_ulp", "mean_ulp"});
    std::uint64_t violations = 0;
    std::optional<Kept> kept;
    if (!options.kept.empty()) kept.emplace(options.kept);
    for (const HostSubject& job : jobs) {
        const bool unary = reference::shape(job.subject.operation).operands == 1 &&
                           job.subject.operand_format == job.subject.format;
        if (unary && job.subject.format == reference::q16_16) add_along_input(along, job);
        const bool exhaustive = is_exhaustive(job, options.quick);
        if (kept && exhaustive && job.input_bits > quick_exhaustive_bits) {
            if (kept->row(job) == nullptr)
                throw std::runtime_error(
                    fmt::format("{}: {} holds no row of all its inputs; `fixbench all --exhaustive "
                                "--only accuracy` runs them",
                                job.name(), (options.kept / "accuracy.csv").string()));
            kept->add(job, accuracy, histograms);
            continue;
        }
        const ErrorStatistics statistics =
            exhaustive ? exhaust_in_parallel(job, options.threads) : sample(job, options.quick);
        accuracy.add({operation_name(job.subject), reference::format_name(job.subject.format),
                      job.implementation, exhaustive ? "all" : "boundary, random, search",
                      fmt::to_string(statistics.count()), fmt::to_string(statistics.defined()),
                      records::cell(statistics.max_ulp()), text_of(statistics.max_witness()),
                      records::cell(statistics.rms_ulp()), records::cell(statistics.mean_ulp()),
                      exhaustive ? "exact" : "lower bound", fmt::to_string(statistics.wrong())});
        add_histogram(histograms, job, statistics);
        if (statistics.wrong() != 0) {
            violations += statistics.wrong();
            fmt::print(stderr, "{}: {} operands break the definition, the first: {}\n", job.name(),
                       statistics.wrong(), text_of(statistics.wrong_witness()));
        }
    }
    accuracy.save(options.output / "accuracy.csv");
    histograms.save(options.output / "error_histograms.csv");
    along.save(options.output / "error_along_input.csv");
    return violations;
}

}  // namespace operations
