// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/advise/advise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

#include "bench/experiments/advise/candidate.hpp"
#include "bench/experiments/advise/driver.hpp"
#include "bench/lab/parallel.hpp"
#include "bench/lab/program/build.hpp"
#include "bench/lab/program/scratch.hpp"
#include "bench/lab/records/progress.hpp"
#include "bench/lab/records/whole_file.hpp"

namespace advise {
namespace {

namespace fs = std::filesystem;

// Cycles of the operations of a step, from the table: those of the format itself, or of the named
// format whose kernels its width uses. Operations that the table does not contain count as 0.
class Estimates {
  public:
    explicit Estimates(const fs::path& file) {
        if (!fs::exists(file)) return;
        const records::Table table = records::Table::load(file);
        const auto column = [&](const char* name) { return table.column(name); };
        for (const auto& row : table.rows()) {
            const std::string &format = row[column("format")],
                              &implementation = row[column("implementation")];
            if (row[column("operands")] != "physics") continue;
            if (implementation != (format == "float" ? "libc" : "default")) continue;
            cycles_[format][row[column("operation")]] =
                std::strtod(row[column("cycles_mean")].c_str(), nullptr);
        }
    }
    std::optional<double> operator()(const Format& format, const Operations& operations) const {
        auto known = cycles_.find(format.name());
        if (known == cycles_.end()) {
            static const std::map<int, const char*> alike = {
                {8, "q4_4"}, {16, "q8_8"}, {24, "q12_12"}, {32, "q8_24"}};
            const auto like = alike.find(format.width());
            if (like != alike.end()) known = cycles_.find(like->second);
        }
        if (known == cycles_.end()) return {};
        double sum = 0;
        for (const auto& [operation, times] : operations) {
            const auto cycles = known->second.find(operation);
            if (cycles != known->second.end()) sum += times * cycles->second;
        }
        return sum;
    }

  private:
    std::map<std::string, std::map<std::string, double>> cycles_;
};

}  // namespace

bool advise_program(const Options& given) {
    Options options = given;
    options.program = fs::canonical(options.program);
    const Data data = load(options.data);
    const fixbench::Scratch scratch;
    const fs::path rows = scratch.folder() / "rows.txt";
    records::write_whole(rows, text_of(data));

    const fs::path recorder = scratch.folder() / "record";
    compile_for_host(options.program, "record.cpp", {"-DRECORD"}, recorder);
    const int integer_bits = record(options, data, recorder, rows, {}).integer_bits;
    const std::vector<Format> formats = candidates(integer_bits);
    const Recorded recorded = record(options, data, recorder, rows, formats);
    records::table_of(recorded.ranges).save(options.output / "ranges.csv");
    if (options.ranges_only) return true;

    std::vector<Candidate> all = run_on_host(options, scratch.folder(), rows, formats, recorded);
    const Estimates estimate(options.measured);
    fixbench::build({"avr_kernels"});
    records::Progress progress("advise", all.size());
    const auto measure = [&](bool wide) {
        operations::in_parallel(options.threads, all.size(), [&](std::size_t i) {
            if ((all[i].format.width() == 64) != wide) return;
            // What does not compile has run no operation.
            if (all[i].advice.failure.empty())
                all[i].advice.cycles_estimated = estimate(all[i].format, all[i].operations);
            if (all[i].advice.meets)
                measure_on_chip(options, data, scratch.folder(), recorded.outputs, all[i]);
            progress.advance();
        });
    };
    measure(false);
    // Numbers of 64 bits are several times slower: they are left out if narrower ones suffice.
    const auto met = [](const Candidate& each) {
        return each.advice.meets && each.advice.cycles_mean;
    };
    if (std::any_of(all.begin(), all.end(), met))
        std::erase_if(all, [](const Candidate& each) { return each.format.width() == 64; });
    else
        measure(true);

    std::vector<Advice> advice;
    for (const Candidate& each : all) advice.push_back(each.advice);
    std::stable_sort(advice.begin(), advice.end(), [](const Advice& a, const Advice& b) {
        constexpr double unknown = std::numeric_limits<double>::infinity();
        return std::tuple(!a.meets, a.cycles_mean.value_or(unknown)) <
               std::tuple(!b.meets, b.cycles_mean.value_or(unknown));
    });
    records::table_of(advice).save(options.output / "advice.csv");
    if (advice.front().meets) return true;
    const auto nearest = std::min_element(
        advice.begin(), advice.end(),
        [](const Advice& a, const Advice& b) { return a.max_error < b.max_error; });
    fmt::print(stderr, "advise: no format stays within {:.3g}; the closest is {} with {:.3g}{}{}\n",
               options.error, nearest->format, nearest->max_error,
               nearest->failure.empty() ? "" : ": ", nearest->failure);
    return false;
}

}  // namespace advise
