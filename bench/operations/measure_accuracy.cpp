// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/operations/measure_accuracy.hpp"

#include <fixedpoint/arithmetic/published.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "bench/operands/boundary.hpp"
#include "bench/operands/operand_class.hpp"
#include "bench/operands/search.hpp"
#include "bench/operations/host_subject.hpp"
#include "bench/operations/witness.hpp"
#include "bench/records/csv.hpp"
#include "bench/records/progress.hpp"
#include "reference/bulk.hpp"
#include "reference/error_statistics.hpp"
#include "reference/judge.hpp"

namespace operations {

namespace {

using reference::Arithmetic;
using reference::ErrorStatistics;
using reference::Judgement;
using reference::NumberFormat;
using reference::Operation;
using reference::Subject;

using Operands = std::array<std::int64_t, reference::most_operands>;

// Spaces of up to 2^32 inputs are exhausted, in this many parts whatever the number of threads: the
// sums of a run then do not depend on the machine.
constexpr int exhaustive_bits = 32;
constexpr int quick_exhaustive_bits = 24;
constexpr std::uint64_t parts = 256;

constexpr std::uint64_t random_samples = 2'000'000, quick_random_samples = 20'000;
constexpr std::uint64_t search_evaluations = 4'000'000, quick_search_evaluations = 40'000;

template <Subject subject, class Policy>
Judgement judge_one(std::span<const std::int64_t> operands) {
    constexpr std::size_t results = reference::shape(subject.operation).results;
    std::array<std::int64_t, results> computed;
    evaluate<subject, Policy>(operands, computed);
    // No C type holds exp of a 64-bit format to a fraction of its ulp.
    if constexpr (subject.operation == Operation::exp && subject.format.width == 64) {
        return reference::judge(subject, operands, computed);
    } else {
        return reference::bulk::judge<subject>(operands, computed);
    }
}

// One row of accuracy.csv in the making.
struct Job {
    Subject subject;
    std::string implementation;
    int input_bits;
    std::function<Judgement(std::span<const std::int64_t>)> judge;
    // The errors over part `part` of the whole input space.
    std::function<ErrorStatistics(std::uint64_t part)> exhaust;

    std::string name() const {
        return fmt::format("{}_{}_{}", reference::shape(subject.operation).name,
                           reference::format_name(subject.format), implementation);
    }
};

template <Subject subject, class Policy>
ErrorStatistics exhaust(std::uint64_t part) {
    constexpr NumberFormat format = subject.format;
    constexpr std::size_t arity = reference::shape(subject.operation).operands;
    constexpr std::uint64_t inputs = std::uint64_t(1) << (format.width * arity);
    constexpr std::uint64_t share = inputs / parts;
    ErrorStatistics statistics;
    std::array<std::int64_t, arity> operands;
    for (std::uint64_t i = part * share; i < (part + 1) * share; ++i) {
        for (std::size_t k = 0; k < arity; ++k) {
            operands[k] = format.sign_extend(i >> (k * format.width));
        }
        statistics.add(judge_one<subject, Policy>(operands), operands);
    }
    return statistics;
}

template <class Policy, Arithmetic arithmetic, NumberFormat format, Operation operation>
void add_job(std::vector<Job>& jobs, const char* implementation) {
    constexpr Subject subject{operation, format, arithmetic};
    constexpr int bits = format.width * static_cast<int>(reference::shape(operation).operands);
    Job job{subject, implementation, bits, judge_one<subject, Policy>, nullptr};
    if constexpr (bits <= exhaustive_bits) job.exhaust = exhaust<subject, Policy>;
    jobs.push_back(std::move(job));
}

template <class Policy, Arithmetic arithmetic, NumberFormat format, Operation... operations>
void add_jobs(std::vector<Job>& jobs, const char* implementation) {
    (add_job<Policy, arithmetic, format, operations>(jobs, implementation), ...);
}

template <NumberFormat format>
void add_format(std::vector<Job>& jobs) {
    using enum Operation;
    add_jobs<fixedpoint::Nearest, Arithmetic::nearest, format, add, subtract, multiply, divide,
             remainder, sqrt, atan, atan2>(jobs, "default");
    add_jobs<fixedpoint::Published, Arithmetic::published, format, multiply, divide, sqrt, atan2>(
        jobs, "published");
    add_jobs<fixedpoint::Saturating, Arithmetic::saturating, format, add, subtract, multiply>(
        jobs, "saturating");
}

std::vector<Job> all_jobs() {
    std::vector<Job> jobs;
    add_format<reference::q4_4>(jobs);
    add_format<reference::q8_8>(jobs);
    add_format<reference::q16_16>(jobs);
    add_format<reference::q32_32>(jobs);
    return jobs;
}

ErrorStatistics exhaust_in_parallel(const Job& job, unsigned threads) {
    std::vector<ErrorStatistics> results(parts);
    records::Progress progress(job.name(), parts);
    std::atomic<std::uint64_t> next{0};
    {
        std::vector<std::jthread> workers;
        for (unsigned i = 0; i < threads; ++i) {
            workers.emplace_back([&] {
                for (std::uint64_t part = next++; part < parts; part = next++) {
                    results[part] = job.exhaust(part);
                    progress.advance();
                }
            });
        }
    }
    ErrorStatistics statistics;
    for (const ErrorStatistics& result : results) statistics.merge(result);
    return statistics;
}

// Boundary table, random operands of every class, and a climb towards the largest error.
ErrorStatistics sample(const Job& job, bool quick) {
    ErrorStatistics statistics;
    records::Progress progress(job.name(), 1);
    for (const operands::BoundaryCase& each : operands::boundary_cases(job.subject.operation, job.subject.format)) {
        statistics.add(job.judge(each.operands), each.operands);
    }
    Operands operands{};
    const std::span used(operands.data(), reference::shape(job.subject.operation).operands);
    for (const operands::OperandClass each : operands::operand_classes) {
        operands::Sampler sampler(job.subject.operation, job.subject.format, each, 1);
        const std::uint64_t wanted = quick ? quick_random_samples : random_samples;
        for (std::uint64_t i = operands::distinct_samples(each, wanted); i > 0; --i) {
            sampler.next(used);
            statistics.add(job.judge(used), used);
        }
    }
    const auto worst = operands::search_worst(
        job.subject.operation, job.subject.format,
        quick ? quick_search_evaluations : search_evaluations, 1,
        [&](std::span<const std::int64_t> each) { return std::abs(job.judge(each).error_ulp); });
    statistics.add(job.judge(worst.operands), worst.operands);
    return statistics;
}

bool is_exhaustive(const Job& job, bool quick) {
    return job.exhaust && job.input_bits <= (quick ? quick_exhaustive_bits : exhaustive_bits);
}

void add_histogram(records::Table& table, const Job& job, const ErrorStatistics& statistics) {
    const gsl_histogram& histogram = statistics.histogram();
    const auto add = [&](double low, double high, double count) {
        if (count == 0) return;
        table.add({std::string(reference::shape(job.subject.operation).name),
                   reference::format_name(job.subject.format), job.implementation,
                   records::cell(low), records::cell(high), records::cell(count)});
    };
    add(-INFINITY, histogram.range[0], static_cast<double>(statistics.below_histogram()));
    for (std::size_t i = 0; i < histogram.n; ++i) {
        add(histogram.range[i], histogram.range[i + 1], histogram.bin[i]);
    }
    add(histogram.range[histogram.n], INFINITY, static_cast<double>(statistics.above_histogram()));
}

// The largest and the rms error in each of many intervals of the input, log-spaced.
void add_along_input(records::Table& table, const Job& job) {
    constexpr int intervals_per_octave = 8;
    constexpr std::uint64_t samples = 2000;
    const NumberFormat& format = job.subject.format;
    double low = 1;
    while (low < static_cast<double>(format.max())) {
        const double high = low * std::exp2(1.0 / intervals_per_octave);
        const auto first = static_cast<std::int64_t>(std::ceil(low));
        const auto last = static_cast<std::int64_t>(std::min(high, static_cast<double>(format.max())));
        if (last >= first) {
            const std::uint64_t count = static_cast<std::uint64_t>(last - first) + 1;
            const std::uint64_t taken = std::min(count, samples);
            ErrorStatistics statistics;
            for (std::uint64_t i = 0; i < taken; ++i) {
                const std::int64_t operand = first + static_cast<std::int64_t>(i * count / taken);
                statistics.add(job.judge({&operand, 1}), {&operand, 1});
            }
            table.add({std::string(reference::shape(job.subject.operation).name),
                       reference::format_name(format), job.implementation,
                       records::cell(std::ldexp(low, -format.fraction)),
                       records::cell(std::ldexp(high, -format.fraction)), fmt::to_string(taken),
                       records::cell(statistics.max_ulp()), records::cell(statistics.rms_ulp()),
                       records::cell(statistics.mean_ulp())});
        }
        low = high;
    }
}

}  // namespace

std::uint64_t measure_accuracy(const AccuracyOptions& options) {
    std::vector<Job> jobs;
    for (Job& job : all_jobs()) {
        if (options.selection.selects(job.subject, job.implementation)) jobs.push_back(std::move(job));
    }
    if (jobs.empty()) throw std::invalid_argument("no subject of the host is selected");

    records::Table accuracy({"operation", "format", "implementation", "inputs", "samples", "defined",
                             "max_ulp", "max_ulp_witness", "rms_ulp", "mean_ulp", "bound",
                             "violations"});
    records::Table histograms({"operation", "format", "implementation", "low_ulp", "high_ulp", "count"});
    records::Table along({"operation", "format", "implementation", "low", "high", "samples", "max_ulp",
                          "rms_ulp", "mean_ulp"});
    std::uint64_t violations = 0;
    for (const Job& job : jobs) {
        const bool exhaustive = is_exhaustive(job, options.quick);
        const ErrorStatistics statistics =
            exhaustive ? exhaust_in_parallel(job, options.threads) : sample(job, options.quick);
        accuracy.add({std::string(reference::shape(job.subject.operation).name),
                      reference::format_name(job.subject.format), job.implementation,
                      exhaustive ? "all" : "boundary, random, search",
                      fmt::to_string(statistics.count()), fmt::to_string(statistics.defined()),
                      records::cell(statistics.max_ulp()), text_of(statistics.max_witness()),
                      records::cell(statistics.rms_ulp()), records::cell(statistics.mean_ulp()),
                      exhaustive ? "exact" : "lower bound", fmt::to_string(statistics.wrong())});
        add_histogram(histograms, job, statistics);
        const bool unary = reference::shape(job.subject.operation).operands == 1;
        if (unary && job.subject.format == reference::q16_16) add_along_input(along, job);
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
