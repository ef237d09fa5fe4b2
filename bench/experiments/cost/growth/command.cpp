// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench growth.
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "bench/experiments/cost/growth/fit.hpp"
#include "bench/lab/program/build.hpp"
#include "bench/lab/program/experiment.hpp"
#include "bench/lab/records/record.hpp"

namespace growth {
namespace {

using records::column;

struct Options {
    bool host = false;
    unsigned most = 4096;
    std::filesystem::path output;
};

// A row of growth.csv and of growth_host.csv.
struct Point {
    std::string where, broad_phase;
    unsigned particles;
    double cost;
    std::string unit;
    std::optional<std::uint32_t> ram, stack;  // of the chip
    double fitted, fit_constant, fit_linear, fit_quadratic, fit_worst_percent;
    bool cheapest;

    static constexpr auto columns = std::tuple(
        column("where", &Point::where), column("broad_phase", &Point::broad_phase),
        column("particles", &Point::particles), column("cost_per_step", &Point::cost, "{:.1f}"),
        column("unit", &Point::unit), column("ram_bytes", &Point::ram),
        column("stack_bytes", &Point::stack), column("fitted", &Point::fitted, "{:.1f}"),
        column("fit_constant", &Point::fit_constant, "{:.5g}"),
        column("fit_linear", &Point::fit_linear, "{:.5g}"),
        column("fit_quadratic", &Point::fit_quadratic, "{:.5g}"),
        column("fit_worst_percent", &Point::fit_worst_percent, "{:.1f}"),
        column("cheapest", &Point::cheapest));
};

int run(const Options& options) {
    if (!options.host) fixbench::build({"growth_programs"});
    const auto costs = options.host ? costs_on_host(options.most) : costs_on_chip();
    const char* const where = options.host ? "host" : "chip";
    const char* const unit = options.host ? "ns" : "cycles";
    std::vector<Point> points;
    const auto brute = of_search(costs, "brute_force"), sweep = of_search(costs, "sort_and_sweep");
    for (const auto& series : {brute, sweep}) {
        const Fit fit = fitted(series);
        for (std::size_t i = 0; i < series.size(); ++i) {
            const Cost& cost = series[i];
            const bool cheapest = brute[i].per_step < sweep[i].per_step
                                      ? cost.broad_phase == "brute_force"
                                      : cost.broad_phase == "sort_and_sweep";
            const auto on_chip = [&](std::uint32_t bytes) {
                return options.host ? std::nullopt : std::optional(bytes);
            };
            points.push_back({where, cost.broad_phase, cost.particles, cost.per_step, unit,
                              on_chip(cost.ram), on_chip(cost.stack), fit(cost.particles), fit.a,
                              fit.b, fit.c, 100 * fit.worst, cheapest});
        }
        fmt::print(stderr, "{}: {:.5g} + {:.5g} N + {:.5g} N^2 {}, within {:.1f} %\n",
                   series.front().broad_phase, fit.a, fit.b, fit.c, unit, 100 * fit.worst);
    }
    if (const auto from = crossing(brute, sweep))
        fmt::print(stderr, "sort_and_sweep is the cheaper from {} particles on\n", *from);
    else
        fmt::print(stderr, "brute_force is the cheaper up to the end\n");
    records::table_of(points).save(options.output /
                                   (options.host ? "growth_host.csv" : "growth.csv"));
    return fixbench::held;
}

const fixbench::Registration registration({
    .name = "growth",
    .description =
        "The cost of a step against the number of particles in a box, with either broad phase,\n"
        "and its fit by a + b N + c N^2: on the simulated chip up to what its memory holds, or\n"
        "with --host on this machine, in nanoseconds. File: growth.csv or growth_host.csv.\n\n"
        "Example: fixbench growth",
    .prints = {"growth.csv", "growth_host.csv"},
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<Options>();
            command.add_flag("--host", options->host, "time this machine instead");
            command.add_option("--most", options->most, "particles on the host")
                ->check(CLI::Range(16, 4096))
                ->capture_default_str();
            return [options](const fixbench::Call& call) {
                options->output = call.output;
                return run(*options);
            };
        },
    .steps = {{.name = "growth",
               .arguments = [](const fixbench::Mode& mode) -> std::vector<std::string> {
                   return {"growth", "--output", mode.data};
               },
               .writes = {"growth.csv"},
               .targets = {"growth_programs"},
               .reads = {GROWTH_PROGRAM_FOLDER},
               .full_seconds = 2,
               .quick_seconds = 2},
              {.name = "growth_host",
               .arguments = [](const fixbench::Mode& mode) -> std::vector<std::string> {
                   return {"growth",   "--host", "--most", mode.quick ? "64" : "4096",
                           "--output", mode.data};
               },
               .writes = {"growth_host.csv"},
               .full_seconds = 20,
               .quick_seconds = 1,
               .times_host = true}},
});

}  // namespace
}  // namespace growth
