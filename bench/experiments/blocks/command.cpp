// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench blocks.
#include <fmt/format.h>

#include <algorithm>

#include "bench/experiments/blocks/limit_cycles.hpp"
#include "bench/experiments/blocks/measure_blocks.hpp"
#include "bench/lab/program/build.hpp"
#include "bench/lab/program/experiment.hpp"
#include "bench/lab/records/record.hpp"
#include "this_build.hpp"

namespace blocks {
namespace {

using records::column;

// A row of blocks.csv.
struct Row {
    std::string block, format;
    double cycles_mean;
    std::uint32_t cycles_max;
    double against_float;  // cycles relative to those in binary32
    std::uint32_t flash;
    double max_error, rms_error;

    static constexpr auto columns = std::tuple(
        column("block", &Row::block), column("format", &Row::format),
        column("cycles_mean", &Row::cycles_mean, "{:.1f}"), column("cycles_max", &Row::cycles_max),
        column("cycles_against_float", &Row::against_float, "{:.2f}"),
        column("flash_bytes", &Row::flash), column("max_error", &Row::max_error, "{:.3g}"),
        column("rms_error", &Row::rms_error, "{:.3g}"));
};

int run(const std::filesystem::path& output) {
    constexpr unsigned steps = 1000;
    fixbench::build({"block_programs"});
    const auto measurements = measure(steps);
    std::vector<Row> rows;
    bool held = true;
    for (const Measurement& m : measurements) {
        const auto in_float =
            std::find_if(measurements.begin(), measurements.end(), [&](const Measurement& other) {
                return other.block == m.block && other.format == "binary32";
            });
        rows.push_back({m.block, m.format, m.cycles_mean, m.cycles_max,
                        m.cycles_mean / in_float->cycles_mean, m.flash, m.max_error, m.rms_error});
        if (m.format != "binary32" && m.unlike_host != 0) {
            fmt::print(stderr, "{} {}: {} of {} outputs differ from the host's\n", m.block,
                       m.format, m.unlike_host, m.outputs);
            held = false;
        }
    }
    const std::vector<LimitCycle> cycles = limit_cycles();
    for (const LimitCycle& cycle : cycles) {
        if (cycle.bound_ulp && static_cast<double>(cycle.largest_ulp) > *cycle.bound_ulp) {
            fmt::print(stderr, "{} {}: a limit cycle of {} ulp, and the bound is {}\n",
                       cycle.filter, cycle.format, cycle.largest_ulp, *cycle.bound_ulp);
            held = false;
        }
    }
    records::table_of(rows).save(output / "blocks.csv");
    records::table_of(cycles).save(output / "limit_cycles.csv");
    return held ? fixbench::held : fixbench::check_failed;
}

const fixbench::Registration registration({
    .name = "blocks",
    .description =
        "What the library's building blocks (PID, filters, tables, polynomials, complex\n"
        "numbers, matrices, quaternions) cost on the chip in fixed point and in float: cycles a\n"
        "step, flash above that of an empty program, and the error against a run in double.\n"
        "What filters leave without input, with their error feedback and without. Fails if a\n"
        "fixed-point result differs from the host's, or a bound does not hold.\n"
        "Files: blocks.csv, limit_cycles.csv.\n\n"
        "Example: fixbench blocks",
    .prints = {"blocks.csv", "limit_cycles.csv"},
    .add = [](CLI::App&) { return [](const fixbench::Call& call) { return run(call.output); }; },
    .steps = {{.name = "blocks",
               .writes = {"blocks.csv", "limit_cycles.csv"},
               .targets = {"block_programs"},
               .reads = {build_folder() / "bench/experiments/blocks"},
               .full_seconds = 5,
               .quick_seconds = 8}},
});

}  // namespace
}  // namespace blocks
