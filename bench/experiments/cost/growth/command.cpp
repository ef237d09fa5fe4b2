// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench growth.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "bench/experiments/cost/growth/fit.hpp"
#include "bench/lab/program/build.hpp"
#include "bench/lab/program/experiment.hpp"
#include "bench/lab/records/record.hpp"

namespace growth {
namespace {

using records::column;

struct Options {
    bool host = false;
    unsigned most = 16384;
    std::filesystem::path output;
};

// A row of growth.csv and of growth_host.csv.
struct Point {
    std::string where, broad_phase;
    unsigned particles;
    double cost;
    std::string unit;
    std::optional<std::uint32_t> ram, stack;    // of the chip
    std::optional<std::size_t> runs, rejected;  // of the host
    double fitted, fit_constant, fit_linear;
    std::string fit_term;
    double fit_factor, fit_worst_percent;
    bool cheapest;

    static constexpr auto columns = std::tuple(
        column("where", &Point::where), column("broad_phase", &Point::broad_phase),
        column("particles", &Point::particles), column("cost_per_step", &Point::cost, "{:.1f}"),
        column("unit", &Point::unit), column("ram_bytes", &Point::ram),
        column("stack_bytes", &Point::stack), column("runs", &Point::runs),
        column("runs_rejected", &Point::rejected), column("fitted", &Point::fitted, "{:.1f}"),
        column("fit_constant", &Point::fit_constant, "{:.5g}"),
        column("fit_linear", &Point::fit_linear, "{:.5g}"), column("fit_term", &Point::fit_term),
        column("fit_factor", &Point::fit_factor, "{:.5g}"),
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
    std::map<unsigned, double> least;
    for (const Cost& cost : costs) {
        const auto [known, is_new] = least.emplace(cost.particles, cost.per_step);
        if (!is_new) known->second = std::min(known->second, cost.per_step);
    }
    for (const auto& [what, term] : {std::pair("brute_force", squares),
                                     {"sort_and_sweep", options.host ? strips : squares},
                                     {"box2d", trees}}) {
        const auto series = of_search(costs, what);
        if (series.empty()) continue;  // Box2D is not for the chip
        const Fit fit = fitted(series, term);
        for (const Cost& cost : series) {
            const auto on_chip = [&](auto number) {
                return options.host ? std::nullopt : std::optional(number);
            };
            const auto on_host = [&](auto number) {
                return options.host ? std::optional(number) : std::nullopt;
            };
            points.push_back({where, what, cost.particles, cost.per_step, unit, on_chip(cost.ram),
                              on_chip(cost.stack), on_host(cost.runs), on_host(cost.rejected),
                              fit(cost.particles), fit.a, fit.b, term.name, fit.c, 100 * fit.worst,
                              cost.per_step == least[cost.particles]});
        }
        fmt::print(stderr, "{}: {:.5g} + {:.5g} N + {:.5g} {} {}, within {:.1f} %\n", what, fit.a,
                   fit.b, fit.c, term.name, unit, 100 * fit.worst);
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
        "The cost of a step against the number N of particles in a box, with either broad phase,\n"
        "and its fit: on the simulated chip up to what its memory holds, or with --host of discs\n"
        "in the plane on this machine, in nanoseconds, beside Box2D. File: growth.csv or\n"
        "growth_host.csv.\n\n"
        "Example: fixbench growth",
    .prints = {"growth.csv", "growth_host.csv"},
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<Options>();
            command.add_flag("--host", options->host, "time this machine instead");
            command.add_option("--most", options->most, "particles on the host")
                ->check(CLI::Range(144, 16384))
                ->capture_default_str();
            return [options](const fixbench::Call& call) {
                options->output = call.output;
                return run(*options);
            };
        },
    .steps = {{.name = "growth",
               .writes = {"growth.csv"},
               .targets = {"growth_programs"},
               .reads = {GROWTH_PROGRAM_FOLDER},
               .full_seconds = 2,
               .quick_seconds = 2},
              {.name = "growth_host",
               .arguments = [](const fixbench::Mode& mode) -> std::vector<std::string> {
                   return {"growth",   "--host", "--most", mode.quick ? "144" : "16384",
                           "--output", mode.data};
               },
               .writes = {"growth_host.csv"},
               .full_seconds = 80,
               .quick_seconds = 1,
               .times_host = true}},
});

}  // namespace
}  // namespace growth
