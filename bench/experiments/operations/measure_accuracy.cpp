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
#include "bench/lab/records/record.hpp"
#include "bench/lab/subjects/host_subject.hpp"
#include "bench/lab/subjects/witness.hpp"
#include "reference/error_statistics.hpp"

namespace operations {

namespace {

using reference::ErrorStatistics;
using reference::NumberFormat;

using Operands = std::array<std::int64_t, reference::max_operands>;

// The quick run shows that each subject runs and is judged; the bounds come from the full run. The
// quick run exhausts spaces of up to 2^16 inputs, the full run those of 2^24, and those of 2^32
// that matter, which an earlier run may have done.
constexpr int quick_exhaustive_bits = 16, full_exhaustive_bits = 24;

constexpr std::uint64_t random_samples = 200'000, quick_random_samples = 2'000;
constexpr std::uint64_t search_evaluations = 400'000, quick_search_evaluations = 4'000;

// Nearly all uniform operands have the largest magnitudes: they would reduce the mean errors.
constexpr operands::OperandClass random_classes[] = {
    operands::OperandClass::small, operands::OperandClass::physics, operands::OperandClass::full,
    operands::OperandClass::published};

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
    for (const operands::BoundaryCase& each :
         operands::boundary_cases(job.subject.operation, job.subject.operand_format)) {
        statistics.add(job.judge_own(each.operands), each.operands);
    }
    Operands operands{};
    const std::span used(operands.data(), reference::shape(job.subject.operation).operands);
    for (const operands::OperandClass each : random_classes) {
        operands::Sampler sampler(job.subject.operation, job.subject.operand_format, each, 1);
        const std::uint64_t wanted = quick ? quick_random_samples : random_samples;
        for (std::uint64_t i = operands::distinct_samples(each, wanted); i > 0; --i) {
            sampler.next(used);
            statistics.add(job.judge_own(used), used);
        }
    }
    const auto worst = operands::search_worst(job.subject.operation, job.subject.operand_format,
                                              quick ? quick_search_evaluations : search_evaluations,
                                              1, [&](std::span<const std::int64_t> each) {
                                                  return std::abs(job.judge_own(each).error_ulp);
                                              });
    statistics.add(job.judge_own(worst.operands), worst.operands);
    return statistics;
}

bool is_exhaustive(const HostSubject& job, bool quick) {
    if (job.input_bits() > exhaustive_bits) return false;
    if (job.input_bits() <= quick_exhaustive_bits) return true;
    if (quick) return false;
    if (job.input_bits() <= full_exhaustive_bits) return true;
    // 2^32 inputs: for the default's operations, and for the published product and quotient. Not
    // for lengths, which are bounded by construction; nor sincos, which is sin and cos; nor the
    // functions of a split with unequal parts, which use Q16.16's; nor 2^32 floats, which would
    // take the exact judge half a day.
    const reference::Subject& subject = job.subject;
    if (subject.format.is_float() || subject.operand_format.is_float()) return false;
    if (job.implementation == "published") {
        return subject.operation == reference::Operation::multiply ||
               subject.operation == reference::Operation::divide;
    }
    const bool square = 2 * subject.format.fraction == subject.format.width;
    const bool function = reference::shape(subject.operation).kind == reference::Kind::function;
    return job.implementation == "default" && subject.operation != reference::Operation::length2 &&
           subject.operation != reference::Operation::sincos && (square || !function);
}

using records::column;

// A row of accuracy.csv.
struct Accuracy {
    std::string operation, format, implementation;
    std::string operands;
    std::uint64_t samples, defined, underflowed;
    double max_ulp;
    std::string max_ulp_witness;
    double rms_ulp, mean_ulp;
    std::uint64_t violations;

    static constexpr auto columns = std::tuple(
        column("operation", &Accuracy::operation), column("format", &Accuracy::format),
        column("implementation", &Accuracy::implementation),
        column("operands", &Accuracy::operands), column("samples", &Accuracy::samples),
        column("defined", &Accuracy::defined), column("underflowed", &Accuracy::underflowed),
        column("max_ulp", &Accuracy::max_ulp),
        column("max_ulp_witness", &Accuracy::max_ulp_witness),
        column("rms_ulp", &Accuracy::rms_ulp), column("mean_ulp", &Accuracy::mean_ulp),
        column("violations", &Accuracy::violations));
};

// A row of error_histograms.csv.
struct Bin {
    std::string operation, format, implementation;
    double low_ulp, high_ulp, count;

    static constexpr auto columns =
        std::tuple(column("operation", &Bin::operation), column("format", &Bin::format),
                   column("implementation", &Bin::implementation), column("low_ulp", &Bin::low_ulp),
                   column("high_ulp", &Bin::high_ulp), column("count", &Bin::count));
};

// A row of error_along_input.csv.
struct Interval {
    std::string operation, format, implementation;
    double low, high;
    std::uint64_t samples;
    double max_ulp, rms_ulp, mean_ulp;

    static constexpr auto columns =
        std::tuple(column("operation", &Interval::operation), column("format", &Interval::format),
                   column("implementation", &Interval::implementation),
                   column("low", &Interval::low), column("high", &Interval::high),
                   column("samples", &Interval::samples), column("max_ulp", &Interval::max_ulp),
                   column("rms_ulp", &Interval::rms_ulp), column("mean_ulp", &Interval::mean_ulp));
};

// The results for one subject.
struct Found {
    Accuracy accuracy;
    std::vector<Bin> histogram;
    std::vector<Interval> along;
    std::uint64_t wrong = 0;
    std::string wrong_witness;
};

void add_histogram(std::vector<Bin>& bins, const HostSubject& job,
                   const ErrorStatistics& statistics) {
    const gsl_histogram& histogram = statistics.histogram();
    const auto add = [&](double low, double high, double count) {
        if (count == 0) return;
        bins.push_back({operation_name(job.subject), reference::format_name(job.subject.format),
                        job.implementation, low, high, count});
    };
    add(-INFINITY, histogram.range[0], static_cast<double>(statistics.below_histogram()));
    for (std::size_t i = 0; i < histogram.n; ++i) {
        add(histogram.range[i], histogram.range[i + 1], histogram.bin[i]);
    }
    add(histogram.range[histogram.n], INFINITY, static_cast<double>(statistics.above_histogram()));
}

// The largest error, judged exactly: a run over all inputs is off by up to 2^-14 ulp.
double largest_error(const HostSubject& job, const ErrorStatistics& statistics) {
    const auto witness = statistics.max_witness().operands();
    return witness.empty() ? 0 : std::abs(job.judge_own(witness).error_ulp);
}

void add_statistics(Found& found, const HostSubject& job, const ErrorStatistics& statistics,
                    bool exhaustive) {
    found.accuracy = {operation_name(job.subject),
                      reference::format_name(job.subject.format),
                      job.implementation,
                      exhaustive ? "all" : "boundary, random, search",
                      statistics.count(),
                      statistics.defined(),
                      statistics.underflowed(),
                      largest_error(job, statistics),
                      text_of(statistics.max_witness()),
                      statistics.rms_ulp(),
                      statistics.mean_ulp(),
                      statistics.wrong()};
    add_histogram(found.histogram, job, statistics);
    found.wrong = statistics.wrong();
    if (found.wrong != 0) found.wrong_witness = text_of(statistics.wrong_witness());
}

// The results of an earlier run for a subject, found by the first three columns.
class Kept {
  public:
    explicit Kept(const std::filesystem::path& folder)
        : accuracy_(records::Table::load(folder / "accuracy.csv")),
          histograms_(records::Table::load(folder / "error_histograms.csv")) {}

    // The row of the subject, if all inputs were run.
    const std::vector<std::string>* row(const HostSubject& job) const {
        for (const auto& row : accuracy_.rows())
            if (is_of(row, job) && row[accuracy_.column("operands")] == "all") return &row;
        return nullptr;
    }

    // Adds the rows of the subject, after checking that they agree with the present code: its error
    // at the operands of the largest error is the same, and no sample has a larger one.
    void add(const HostSubject& job, Found& found) const {
        const std::vector<std::string>& kept = *row(job);
        const std::string largest = kept[accuracy_.column("max_ulp")];
        std::vector<std::int64_t> witness;
        std::istringstream words(kept[accuracy_.column("max_ulp_witness")]);
        for (std::int64_t raw; words >> raw;) witness.push_back(raw);
        const auto stale = [&](const std::string& reason) {
            throw std::runtime_error(
                fmt::format("{}: the kept row over all inputs is not of this code: {}; "
                            "`fixbench all --exhaustive --only accuracy` runs them again",
                            job.name(), reason));
        };
        if (witness.size() != reference::shape(job.subject.operation).operands)
            stale("it names no operands");
        const double there = std::abs(job.judge_own(witness).error_ulp);
        if (records::cell(there) != largest)
            stale(fmt::format("at {} its error is {} ulp, not {}",
                              kept[accuracy_.column("max_ulp_witness")], records::cell(there),
                              largest));
        const ErrorStatistics samples = sample(job, true);
        if (samples.wrong() != 0)
            stale(fmt::format("{} contradicts the definition", text_of(samples.wrong_witness())));
        if (samples.max_ulp() > there)
            stale(fmt::format("at {} its error is {} ulp, and the kept maximum {}",
                              text_of(samples.max_witness()), records::cell(samples.max_ulp()),
                              largest));
        const auto text = [&](const char* name) { return kept[accuracy_.column(name)]; };
        const auto count = [&](const char* name) { return std::stoull(text(name)); };
        const auto number = [&](const char* name) { return std::stod(text(name)); };
        found.accuracy = {text("operation"),    text("format"),     text("implementation"),
                          text("operands"),     count("samples"),   count("defined"),
                          count("underflowed"), number("max_ulp"),  text("max_ulp_witness"),
                          number("rms_ulp"),    number("mean_ulp"), count("violations")};
        for (const auto& row : histograms_.rows())
            if (is_of(row, job))
                found.histogram.push_back({row[0], row[1], row[2], std::stod(row[3]),
                                           std::stod(row[4]), std::stod(row[5])});
    }

  private:
    static bool is_of(const std::vector<std::string>& row, const HostSubject& job) {
        return row[0] == operation_name(job.subject) &&
               row[1] == reference::format_name(job.subject.format) && row[2] == job.implementation;
    }

    records::Table accuracy_, histograms_;
};

// The largest and the rms error in each of many intervals of the input, log-spaced.
void add_along_input(Found& found, const HostSubject& job) {
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
                statistics.add(job.judge_own({&operand, 1}), {&operand, 1});
            }
            found.along.push_back({operation_name(job.subject), reference::format_name(format),
                                   job.implementation, std::ldexp(low, -format.fraction),
                                   std::ldexp(high, -format.fraction), taken, statistics.max_ulp(),
                                   statistics.rms_ulp(), statistics.mean_ulp()});
        }
        low = high;
    }
}

bool is_unary(const HostSubject& job) {
    return reference::shape(job.subject.operation).operands == 1 &&
           job.subject.operand_format == job.subject.format;
}

}  // namespace

std::uint64_t measure_accuracy(const AccuracyOptions& options) {
    std::vector<HostSubject> jobs;
    for (const HostSubject& each : host_subjects()) {
        if (each.same_as_default) continue;
        if (options.selection.selects(each.subject, each.implementation)) jobs.push_back(each);
    }
    if (jobs.empty()) throw std::invalid_argument("no subject of the host is selected");

    std::optional<Kept> kept;
    if (!options.kept.empty()) kept.emplace(options.kept);
    std::vector<Found> found(jobs.size());
    // Sampled jobs share the threads. In an exhaustive job, each thread takes a part of the inputs.
    std::vector<std::size_t> sampled, exhausted;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        const bool exhaustive = is_exhaustive(jobs[i], options.quick);
        const bool long_one = jobs[i].input_bits() > full_exhaustive_bits;
        (exhaustive && !(kept && long_one) ? exhausted : sampled).push_back(i);
        if (kept && exhaustive && long_one && kept->row(jobs[i]) == nullptr)
            fmt::print(stderr,
                       "{}: sampled, since {} holds no row of all its inputs; `fixbench all "
                       "--exhaustive --only accuracy` runs them\n",
                       jobs[i].name(), (options.kept / "accuracy.csv").string());
    }
    records::Progress progress("accuracy, sampled", sampled.size());
    in_parallel(options.threads, sampled.size(), [&](std::size_t k) {
        const HostSubject& job = jobs[sampled[k]];
        Found& its = found[sampled[k]];
        if (is_unary(job) && job.subject.format == reference::q16_16) add_along_input(its, job);
        const bool keeps = kept && is_exhaustive(job, options.quick) && kept->row(job) != nullptr;
        if (keeps)
            kept->add(job, its);
        else
            add_statistics(its, job, sample(job, options.quick), false);
        progress.advance();
    });
    for (const std::size_t i : exhausted) {
        if (is_unary(jobs[i]) && jobs[i].subject.format == reference::q16_16)
            add_along_input(found[i], jobs[i]);
        add_statistics(found[i], jobs[i], exhaust_in_parallel(jobs[i], options.threads), true);
    }

    std::vector<Accuracy> accuracy;
    std::vector<Bin> histograms;
    std::vector<Interval> along;
    std::uint64_t violations = 0;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        Found& its = found[i];
        violations += its.wrong;
        if (its.wrong != 0)
            fmt::print(stderr,
                       "{}: the results of {} operands contradict the definition, the first: {}\n",
                       jobs[i].name(), its.wrong, its.wrong_witness);
        accuracy.push_back(std::move(its.accuracy));
        histograms.insert(histograms.end(), its.histogram.begin(), its.histogram.end());
        along.insert(along.end(), its.along.begin(), its.along.end());
    }
    records::table_of(accuracy).save(options.output / "accuracy.csv");
    records::table_of(histograms).save(options.output / "error_histograms.csv");
    records::table_of(along).save(options.output / "error_along_input.csv");
    return violations;
}

}  // namespace operations
