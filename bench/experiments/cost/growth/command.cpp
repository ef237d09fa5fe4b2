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

#include "bench/experiments/cost/growth/discs.hpp"
#include "bench/experiments/cost/growth/fit.hpp"
#include "bench/lab/program/build.hpp"
#include "bench/lab/program/experiment.hpp"
#include "bench/lab/records/record.hpp"
#include "this_build.hpp"

namespace growth {
namespace {

using records::column;

struct Options {
    bool host = false;
    unsigned most = max_discs;
    unsigned rounds = 7;
    std::filesystem::path output;
};

// A row of growth.csv and of growth_host.csv. The pairs of Box2D are not counted, and its cost is
// not fitted.
struct Point {
    std::string where, broad_phase;
    unsigned particles;
    double cost;
    std::string unit;
    std::optional<double> pairs{};
    std::optional<std::uint32_t> ram{}, stack{};    // of the chip
    std::optional<std::size_t> runs{}, rejected{};  // of the host
    std::optional<double> fitted{}, fit_constant{}, fit_linear{}, fit_per_pair{},
        fit_worst_percent{};
    bool cheapest = false;

    static constexpr auto columns = std::tuple(
        column("where", &Point::where), column("broad_phase", &Point::broad_phase),
        column("particles", &Point::particles), column("cost_per_step", &Point::cost, "{:.1f}"),
        column("unit", &Point::unit), column("pairs_tested", &Point::pairs, "{:.1f}"),
        column("ram_bytes", &Point::ram), column("stack_bytes", &Point::stack),
        column("runs", &Point::runs), column("runs_rejected", &Point::rejected),
        column("fitted", &Point::fitted, "{:.1f}"),
        column("fit_constant", &Point::fit_constant, "{:.5g}"),
        column("fit_linear", &Point::fit_linear, "{:.5g}"),
        column("fit_per_pair", &Point::fit_per_pair, "{:.5g}"),
        column("fit_worst_percent", &Point::fit_worst_percent, "{:.1f}"),
        column("cheapest", &Point::cheapest));
};

constexpr double bound = 0.05;     // largest permitted deviation of a cost on the chip from the fit
constexpr std::size_t enough = 6;  // numbers of particles, twice the terms of a fit
constexpr const char* fitted_searches[] = {"brute_force", "sort_and_sweep"};

Point point(const Cost& cost, bool host) {
    Point point{.where = host ? "host" : "chip",
                .broad_phase = cost.broad_phase,
                .particles = cost.particles,
                .cost = cost.per_step,
                .unit = host ? "ns" : "cycles"};
    if (cost.broad_phase != "box2d") point.pairs = cost.pairs;
    if (host) {
        point.runs = cost.runs;
        point.rejected = cost.rejected;
    } else {
        point.ram = cost.ram;
        point.stack = cost.stack;
    }
    return point;
}

// Writes the fit of the costs of a search to its points. Returns whether all deviations are small
// enough.
bool fits(const char* search, const std::vector<Cost>& costs, std::vector<Point>& points) {
    const auto sample = [](const Cost& cost) {
        return Sample{1.0 * cost.particles, cost.pairs, cost.per_step};
    };
    std::vector<Sample> samples;
    for (const Cost& cost : of_search(costs, search)) samples.push_back(sample(cost));
    const Fit fit = fitted(samples);
    for (std::size_t i = 0; i < costs.size(); ++i) {
        Point& point = points[i];
        if (point.broad_phase != search) continue;
        point.fitted = fit(sample(costs[i]));
        point.fit_constant = fit.a;
        point.fit_linear = fit.b;
        point.fit_per_pair = fit.c;
        point.fit_worst_percent = 100 * fit.worst;
    }
    fmt::print(stderr, "{}: {:.5g} + {:.5g} N + {:.5g} {} a pair, largest miss {:.1f} %\n", search,
               fit.a, fit.b, fit.c, points.front().unit, 100 * fit.worst);
    return samples.size() < enough || fit.worst <= bound;
}

int run(const Options& options) {
    if (!options.host) fixbench::build({"growth_programs"});
    const auto costs = options.host ? costs_on_host(options.most, options.rounds) : costs_on_chip();
    std::map<unsigned, double> least;
    for (const Cost& cost : costs) {
        const auto [known, is_new] = least.emplace(cost.particles, cost.per_step);
        if (!is_new) known->second = std::min(known->second, cost.per_step);
    }
    std::vector<Point> points;
    for (const Cost& cost : costs) {
        points.push_back(point(cost, options.host));
        points.back().cheapest = cost.per_step == least[cost.particles];
    }
    bool all_fit = true;
    for (const char* search : fitted_searches) all_fit = fits(search, costs, points) && all_fit;
    // Reported only: another machine has other caches.
    all_fit = all_fit || options.host;
    if (const auto from =
            crossing(of_search(costs, "brute_force"), of_search(costs, "sort_and_sweep")))
        fmt::print(stderr, "sort_and_sweep is cheaper from {} particles upwards\n", *from);
    else
        fmt::print(stderr, "brute_force is cheaper for every number of particles\n");
    records::table_of(points).save(options.output /
                                   (options.host ? "growth_host.csv" : "growth.csv"));
    return all_fit ? fixbench::held : fixbench::check_failed;
}

const fixbench::Registration registration({
    .name = "growth",
    .description =
        "The cost of a step against the number N of particles in a box, with either broad phase,\n"
        "and the pairs that it tests: on the simulated chip in cycles, up to what its memory "
        "holds,\n"
        "or with --host of discs in the plane on this machine, in nanoseconds, beside Box2D. "
        "Exits\n"
        "with 1 where a cost on the chip is more than 5 % off a + b N + c times the pairs; with\n"
        "--host that is reported only, since other machines have other caches. File: growth.csv "
        "or\n"
        "growth_host.csv.\n\n"
        "Example: fixbench growth",
    .prints = {"growth.csv", "growth_host.csv"},
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<Options>();
            command.add_flag("--host", options->host, "time this machine instead");
            command.add_option("--most", options->most, "particles on the host")
                ->check(CLI::Range(144u, max_discs))
                ->capture_default_str();
            command.add_option("--rounds", options->rounds, "runs of each box on the host")
                ->check(CLI::Range(1u, 100u))
                ->capture_default_str();
            return [options](const fixbench::Call& call) {
                options->output = call.output;
                return run(*options);
            };
        },
    .steps = {{.name = "growth",
               .writes = {"growth.csv"},
               .targets = {"growth_programs"},
               .reads = {build_folder() / "bench/experiments/cost/growth"},
               .full_seconds = 2,
               .quick_seconds = 2},
              {.name = "growth_host",
               .arguments = [](const fixbench::Mode& mode) -> std::vector<std::string> {
                   std::vector<std::string> arguments{"growth", "--host", "--output", mode.data};
                   if (mode.quick)
                       arguments.insert(arguments.end(), {"--most", "144", "--rounds", "2"});
                   return arguments;
               },
               .writes = {"growth_host.csv"},
               .full_seconds = 130,
               .quick_seconds = 4,
               .times_host = true}},
});

}  // namespace
}  // namespace growth
