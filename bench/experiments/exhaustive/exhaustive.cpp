// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/exhaustive/exhaustive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <mutex>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>
#include <utility>

#include "bench/chip/instructions/compiled_function.hpp"
#include "bench/chip/instructions/fingerprint.hpp"
#include "bench/experiments/exhaustive/measurement.hpp"
#include "bench/lab/operands/boundary.hpp"
#include "bench/lab/operands/operand_class.hpp"
#include "bench/lab/operands/search.hpp"
#include "bench/lab/parallel.hpp"
#include "bench/lab/records/csv.hpp"
#include "bench/lab/records/progress.hpp"
#include "bench/lab/records/record.hpp"
#include "bench/lab/records/whole_file.hpp"
#include "bench/lab/subjects/device_subject.hpp"
#include "bench/lab/subjects/witness.hpp"

namespace machine_code {
namespace {

using instructions::CompiledFunction;
using records::column;

constexpr int exhaustive_bits = 32;
constexpr std::size_t calls_of_a_batch = 512;  // whose raws and cycles fit the first-level cache

// Runs parts of a function's inputs.
class Worker {
  public:
    Worker(const CompiledFunction& function, const Oracle& oracle)
        : session_(function),
          oracle_(oracle),
          arity_(function.arity()),
          operands_(calls_of_a_batch * arity_),
          results_(calls_of_a_batch * function.result_count()),
          cycles_(calls_of_a_batch) {}

    // Inputs first..last-1 of all. An input is the concatenation of the operands' bits.
    Part exhaust(std::uint64_t first, std::uint64_t last) {
        const reference::NumberFormat& format = oracle_.subject.operand_format;
        Part part;
        for (std::uint64_t i = first; i < last; ++i)
            add(part, [&](std::span<std::int64_t> raws) {
                for (std::size_t k = 0; k < raws.size(); ++k)
                    raws[k] = format.extend(i >> (int(k) * format.width));
            });
        run_batch(part);
        return part;
    }

    // A part of a search: its share of the boundary table; then half of the budget on random
    // operands, and a quarter each on climbing towards the largest error and the most cycles.
    Part search(std::span<const operands::BoundaryCase> cases, std::uint64_t index,
                std::uint64_t budget, std::uint64_t seed) {
        Part part;
        const reference::Operation operation = oracle_.subject.operation;
        const reference::NumberFormat& operand_format = oracle_.subject.operand_format;
        for (std::uint64_t i = index; i < cases.size(); i += operations::exhaustive_parts)
            add(part, [&](std::span<std::int64_t> raws) {
                std::copy(cases[i].operands.begin(), cases[i].operands.end(), raws.begin());
            });

        using operands::OperandClass;
        constexpr OperandClass classes[] = {OperandClass::small, OperandClass::physics,
                                            OperandClass::full};
        constexpr std::uint64_t kinds = std::size(classes) + 1;
        for (const OperandClass each : classes) {
            operands::Sampler sampler(operation, operand_format, each, seed);
            for (std::uint64_t i = 0; i < budget / 2 / kinds; ++i)
                add(part, [&](std::span<std::int64_t> raws) { sampler.next(raws); });
        }
        std::mt19937_64 random(seed);
        for (std::uint64_t i = 0; i < budget / 2 / kinds; ++i)
            add(part, [&](std::span<std::int64_t> raws) {
                for (std::int64_t& raw : raws) raw = operand_format.extend(random());
            });
        run_batch(part);

        const auto climb = [&](std::uint64_t start, auto&& height) {
            operands::search_worst(operation, operand_format, budget / 4, start,
                                   [&](std::span<const std::int64_t> raws) {
                                       add(part, [&](std::span<std::int64_t> first) {
                                           std::copy(raws.begin(), raws.end(), first.begin());
                                       });
                                       run_batch(part);
                                       return height();
                                   });
        };
        climb(seed, [&] {
            const reference::Judgement judgement =
                oracle_.judge(std::span(operands_).first(arity_),
                              std::span(results_).first(results_.size() / calls_of_a_batch));
            return judgement.excluded ? -INFINITY : std::abs(judgement.error_ulp);
        });
        climb(~seed, [&] { return double(cycles_[0]); });
        return part;
    }

    std::vector<std::uint32_t> reached_blocks() const { return session_.reached_blocks(); }

  private:
    template <class Fill>
    void add(Part& part, Fill&& fill) {
        fill(std::span(operands_).subspan(count_ * arity_, arity_));
        if (++count_ == calls_of_a_batch) run_batch(part);
    }

    void run_batch(Part& part) {
        const std::span raws = std::span(operands_).first(count_ * arity_);
        const std::span computed =
            std::span(results_).first(count_ * (results_.size() / calls_of_a_batch));
        const std::span cycles = std::span(cycles_).first(count_);
        session_.run(raws, computed, cycles);
        // Registers hold a pattern; a raw without a sign is extended otherwise.
        const reference::NumberFormat& format = oracle_.subject.format;
        if (format.is_unsigned)
            for (std::int64_t& raw : computed) raw = format.extend(std::uint64_t(raw));
        const std::span regular = std::span(regular_).first(count_);
        oracle_.judge_all(raws, computed, part.errors, regular);
        if (oracle_.portable) oracle_.compare_all(raws, computed, part.differences);
        for (std::size_t i = 0; i < count_; ++i)
            part.cycles.add(cycles[i], regular[i], raws.subspan(i * arity_, arity_));
        count_ = 0;
    }

    CompiledFunction::Session session_;
    const Oracle& oracle_;
    std::size_t arity_, count_ = 0;
    std::vector<std::int64_t> operands_, results_;
    std::vector<std::uint32_t> cycles_;
    std::array<bool, calls_of_a_batch> regular_{};
};

struct Job {
    std::string symbol;
    Oracle oracle;
    std::vector<operands::BoundaryCase> boundary{};  // for a search

    int bits() const {
        return oracle.subject.operand_format.width *
               int(reference::shape(oracle.subject.operation).operands);
    }
    bool every_input() const { return bits() <= exhaustive_bits; }
};

std::vector<Job> jobs_of(const simulator::Elf& elf, const std::vector<std::string>& symbols) {
    std::vector<Job> jobs;
    for (const std::string& symbol : symbols) {
        elf.function(symbol);
        const auto oracle = oracle_of(reference::parse_symbol(symbol));
        if (!oracle)
            throw std::invalid_argument(fmt::format(
                "{}: only fixed-point functions can be judged over all inputs", symbol));
        jobs.push_back({symbol, *oracle});
    }
    if (!symbols.empty()) return jobs;
    for (const std::string& symbol : operations::subjects_of(elf))
        if (const auto oracle = oracle_of(reference::parse_symbol(symbol)))
            jobs.push_back({symbol, *oracle});
    if (jobs.empty())
        throw std::invalid_argument(fmt::format("{}: no function to judge", elf.path().string()));
    return jobs;
}

std::uint64_t seed_of(std::string_view symbol, std::uint64_t part) {
    std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
    for (const char c : symbol) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return hash + part;
}

Part run_part(Worker& worker, const Job& job, std::uint64_t index, const Options& options) {
    if (job.every_input()) {
        const std::uint64_t share = (std::uint64_t(1) << job.bits()) / operations::exhaustive_parts;
        return worker.exhaust(index * share, (index + 1) * share);
    }
    const std::uint64_t budget =
        (options.search_operands + operations::exhaustive_parts - 1) / operations::exhaustive_parts;
    return worker.search(job.boundary, index, budget, seed_of(job.symbol, index));
}

// The completed parts of a function's run, in a file next to the results: an interrupted run
// continues from there. It is valid only for the very program that was judged, whatever has been
// built since.
class Checkpoint {
  public:
    Checkpoint(const Options& options, const Measurement& run)
        : path_(options.output / fmt::format("exhaustive.{}.{}-of-{}.checkpoint.json", run.symbol,
                                             options.shard.index, options.shard.count)) {}

    // Restores the completed parts of the run, or nothing if there are none.
    void resume(Measurement& run) const {
        std::ifstream stream(path_);
        if (!stream) return;
        try {
            const auto json = nlohmann::json::parse(stream);
            const auto done = json.at("measurement").get<Measurement>();
            if (json.at("judge") != judge_sha256() || !done.is_of_the_run_of(run)) return;
            run.parts = done.parts;
            run.unreached = done.unreached;
        } catch (const std::exception&) {
            // Not a checkpoint of this program.
        }
    }

    // Saves if the last checkpoint is so old that losing the work since would matter.
    void save_if_due(const Measurement& run) {
        constexpr std::chrono::seconds interval(2);
        const auto now = std::chrono::steady_clock::now();
        if (now - saved_ < interval) return;
        save(run);
        saved_ = std::chrono::steady_clock::now();
    }
    void save(const Measurement& run) const {
        const nlohmann::json json = {{"judge", judge_sha256()}, {"measurement", run}};
        records::write_whole(path_, json.dump() + "\n");
    }

    void remove() const {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }

  private:
    static const std::string& judge_sha256() {
        static const std::string hash = [] {
            std::ifstream stream("/proc/self/exe", std::ios::binary);
            const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
            return simulator::sha256_of(
                {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
        }();
        return hash;
    }

    std::filesystem::path path_;
    std::chrono::steady_clock::time_point saved_ = std::chrono::steady_clock::now();
};

// Runs the parts that the checkpoint does not contain.
void run_parts(const simulator::Elf& elf, const Job& job, const Options& options,
               Measurement& measurement, Checkpoint& checkpoint) {
    const Shard& shard = options.shard;
    const std::uint64_t first = operations::exhaustive_parts * (shard.index - 1) / shard.count;
    const std::uint64_t last = operations::exhaustive_parts * shard.index / shard.count;
    std::vector<std::uint64_t> missing;
    for (std::uint64_t k = first; k < last; ++k)
        if (!measurement.parts.contains(k)) missing.push_back(k);
    if (missing.empty()) return;

    const operations::Calling calling = operations::calling_of(job.oracle.subject);
    const CompiledFunction function(
        elf, job.symbol, instructions::interface_of(calling.signature, calling.pointers));
    records::Progress progress(job.symbol, last - first);
    progress.advance(last - first - missing.size());
    bool resumed = !measurement.parts.empty();
    std::mutex recording;
    operations::in_parallel(options.threads, missing.size(), [&](std::size_t k) {
        Worker worker(function, job.oracle);
        Part part = run_part(worker, job, missing[k], options);
        const std::vector<std::uint32_t> blocks = worker.reached_blocks();
        const std::vector<std::uint32_t> unreached =
            function.unreached({blocks.begin(), blocks.end()});
        const std::lock_guard lock(recording);
        measurement.parts.emplace(missing[k], std::move(part));
        std::set<std::uint32_t> common;
        if (!std::exchange(resumed, true))
            common.insert(unreached.begin(), unreached.end());
        else
            std::set_intersection(measurement.unreached.begin(), measurement.unreached.end(),
                                  unreached.begin(), unreached.end(),
                                  std::inserter(common, common.end()));
        measurement.unreached = std::move(common);
        checkpoint.save_if_due(measurement);
        progress.advance();
    });
}

// Identifies the run of a job; without any parts yet.
Measurement run_of(const simulator::Elf& elf, const Job& job, const Options& options) {
    return {.symbol = job.symbol,
            .elf_sha256 = elf.sha256(),
            .kernel_sha256 = instructions::fingerprint(elf, job.symbol),
            .every_input = job.every_input(),
            .search_operands = job.every_input() ? 0 : options.search_operands,
            .has_portable = job.oracle.portable != nullptr,
            .parts = {},
            .unreached = {}};
}

// A row of exhaustive.csv. A search has no means, since these would describe the search.
struct Row {
    std::string operation, format, implementation, operands;
    std::uint64_t inputs;
    double max_ulp;
    std::string max_ulp_witness;
    std::optional<double> rms_ulp, mean_ulp;
    std::uint64_t cycles_min;
    std::optional<double> cycles_mean;
    std::uint64_t cycles_max;
    std::string cycles_max_witness;
    std::uint64_t unreached_instructions, violations;
    std::optional<std::uint64_t> portable_differences;  // if there is portable code
    std::string kernel_sha256;

    static constexpr auto columns = std::tuple(
        column("operation", &Row::operation), column("format", &Row::format),
        column("implementation", &Row::implementation), column("operands", &Row::operands),
        column("inputs", &Row::inputs), column("max_ulp", &Row::max_ulp),
        column("max_ulp_witness", &Row::max_ulp_witness), column("rms_ulp", &Row::rms_ulp),
        column("mean_ulp", &Row::mean_ulp), column("cycles_min", &Row::cycles_min),
        column("cycles_mean", &Row::cycles_mean), column("cycles_max", &Row::cycles_max),
        column("cycles_max_witness", &Row::cycles_max_witness),
        column("unreached_instructions", &Row::unreached_instructions),
        column("violations", &Row::violations),
        column("portable_differences", &Row::portable_differences),
        column("kernel_sha256", &Row::kernel_sha256));
};

Row row_of(const Measurement& measurement, const Part& total) {
    const reference::NamedSubject named = reference::parse_symbol(measurement.symbol);
    const auto mean = [&](std::optional<double> value) {
        return measurement.every_input ? value : std::nullopt;
    };
    return {std::string(reference::shape(named.subject.operation).name),
            reference::format_name(named.subject.format),
            named.implementation,
            measurement.every_input ? "all" : "search",
            total.cycles.calls,
            total.errors.max_ulp(),
            operations::text_of(total.errors.max_witness()),
            mean(total.errors.rms_ulp()),
            mean(total.errors.mean_ulp()),
            total.cycles.min,
            mean(total.cycles.mean()),
            total.cycles.max,
            operations::text_of(total.cycles.max_witness),
            measurement.unreached.size(),
            total.errors.wrong(),
            measurement.has_portable ? std::optional(total.differences.count) : std::nullopt,
            measurement.kernel_sha256};
}

void report(const Measurement& measurement, const Part& total) {
    if (total.errors.wrong() != 0)
        fmt::print(stderr,
                   "{}: the results of {} operands contradict the definition, the first: {}\n",
                   measurement.symbol, total.errors.wrong(),
                   operations::text_of(total.errors.wrong_witness()));
    if (total.differences.count != 0)
        fmt::print(stderr, "{}: {} results differ from the portable code's, the first: {}\n",
                   measurement.symbol, total.differences.count,
                   operations::text_of(total.differences.witness));
    for (const std::uint32_t address : measurement.unreached)
        fmt::print(stderr, "{}: no input reached 0x{:04x}\n", measurement.symbol, address);
}

// Replaces the rows of the same functions by those of the measurements.
std::uint64_t save(const std::vector<Measurement>& measurements,
                   const std::filesystem::path& output) {
    const std::filesystem::path path = output / "exhaustive.csv";
    std::map<std::vector<std::string>, std::vector<std::string>> rows;
    const auto add = [&](const records::Table& of) {
        for (const auto& row : of.rows()) rows[{row.begin(), row.begin() + 3}] = row;
    };
    records::Table table = records::table_of(std::vector<Row>());
    if (std::filesystem::exists(path)) {
        const records::Table old = records::Table::load(path);
        if (old.columns() != table.columns())
            throw std::runtime_error(
                fmt::format("{}: its columns are not those of this version", path.string()));
        add(old);
    }
    std::vector<Row> measured;
    std::uint64_t violations = 0;
    for (const Measurement& measurement : measurements) {
        const Part total = measurement.total();
        measured.push_back(row_of(measurement, total));
        report(measurement, total);
        violations += total.errors.wrong() + total.differences.count;
    }
    add(records::table_of(measured));
    for (auto& [key, row] : rows) table.add(std::move(row));
    table.save(path);
    return violations;
}

}  // namespace

Shard parse_shard(const std::string& text) {
    Shard shard;
    const char* const end = text.data() + text.size();
    const auto [slash, bad_index] = std::from_chars(text.data(), end, shard.index);
    if (bad_index == std::errc() && slash != end && *slash == '/') {
        const auto [rest, bad_count] = std::from_chars(slash + 1, end, shard.count);
        if (bad_count == std::errc() && rest == end && shard.index >= 1 &&
            shard.index <= shard.count && shard.count <= operations::exhaustive_parts)
            return shard;
    }
    throw std::invalid_argument(fmt::format("shard '{}': allowed is i/n with 1 <= i <= n <= {}",
                                            text, operations::exhaustive_parts));
}

std::uint64_t run_exhaustive(const Options& options) {
    const simulator::Elf elf(options.program);
    std::uint64_t violations = 0;
    std::vector<Checkpoint> checkpoints;
    for (Job& job : jobs_of(elf, options.symbols)) {
        const reference::Subject& subject = job.oracle.subject;
        Measurement measurement = run_of(elf, job, options);
        Checkpoint& checkpoint = checkpoints.emplace_back(options, measurement);
        checkpoint.resume(measurement);
        if (!job.every_input())
            job.boundary = operands::boundary_cases(subject.operation, subject.operand_format);
        run_parts(elf, job, options, measurement, checkpoint);
        // Saves the finished function, too: it is not run again if a later one is interrupted.
        checkpoint.save(measurement);
        if (measurement.is_complete()) {
            violations += save({measurement}, options.output);
            continue;
        }
        const std::string name = fmt::format("exhaustive.{}.{}-of-{}.json", job.symbol,
                                             options.shard.index, options.shard.count);
        records::write_whole(options.output / name, nlohmann::json(measurement).dump() + "\n");
        const Part total = measurement.total();
        violations += total.errors.wrong() + total.differences.count;
    }
    for (const Checkpoint& checkpoint : checkpoints) checkpoint.remove();
    return violations;
}

std::uint64_t merge_exhaustive(const std::vector<std::filesystem::path>& shards,
                               const std::filesystem::path& output) {
    std::map<std::string, Measurement> by_symbol;
    for (const std::filesystem::path& path : shards) {
        Measurement shard;
        try {
            std::ifstream stream(path);
            nlohmann::json::parse(stream).get_to(shard);
        } catch (const std::exception& error) {
            throw std::runtime_error(
                fmt::format("{}: not a shard's file: {}", path.string(), error.what()));
        }
        const auto [place, fresh] = by_symbol.emplace(shard.symbol, shard);
        if (!fresh) place->second.join(shard);
    }
    std::vector<Measurement> measurements;
    for (auto& [symbol, measurement] : by_symbol) {
        if (!measurement.is_complete())
            throw std::runtime_error(fmt::format("{}: the shards hold {} of {} parts", symbol,
                                                 measurement.parts.size(),
                                                 operations::exhaustive_parts));
        measurements.push_back(std::move(measurement));
    }
    if (measurements.empty()) throw std::runtime_error("no shards to merge");
    return save(measurements, output);
}

}  // namespace machine_code
