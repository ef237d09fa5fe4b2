// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench growth.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
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

// A row of growth.csv and of growth_host.csv. The work that is fitted is the chip's cycles; on the
// host, the tests of a particle against a wall or another particle. Box2D's is not counted.
struct Point {
    std::string where, broad_phase;
    unsigned particles;
    double cost;
    std::string unit;
    std::optional<double> pairs{}, ns_per_test{};
    std::optional<std::uint32_t> ram{}, stack{};    // of the chip
    std::optional<std::size_t> runs{}, rejected{};  // of the host
    std::string fit_of{};
    std::optional<double> fitted{}, fit_constant{}, fit_linear{};
    std::string fit_term{};
    std::optional<double> fit_factor{}, fit_worst_percent{};
    bool cheapest = false;

    static constexpr auto columns = std::tuple(
        column("where", &Point::where), column("broad_phase", &Point::broad_phase),
        column("particles", &Point::particles), column("cost_per_step", &Point::cost, "{:.1f}"),
        column("unit", &Point::unit), column("pairs_tested", &Point::pairs, "{:.1f}"),
        column("ns_per_test", &Point::ns_per_test, "{:.3f}"), column("ram_bytes", &Point::ram),
        column("stack_bytes", &Point::stack), column("runs", &Point::runs),
        column("runs_rejected", &Point::rejected), column("fit_of", &Point::fit_of),
        column("fitted", &Point::fitted, "{:.1f}"),
        column("fit_constant", &Point::fit_constant, "{:.5g}"),
        column("fit_linear", &Point::fit_linear, "{:.5g}"), column("fit_term", &Point::fit_term),
        column("fit_factor", &Point::fit_factor, "{:.5g}"),
        column("fit_worst_percent", &Point::fit_worst_percent, "{:.1f}"),
        column("cheapest", &Point::cheapest));
};

constexpr double bound = 0.05;     // the largest deviation of a sample from the fit
constexpr std::size_t enough = 6;  // numbers of particles, twice the terms of a fit
constexpr double walls = 4;        // of the discs' box

double tests(const Cost& cost) { return walls * cost.particles + cost.pairs; }
// Discs that overlap along one axis: their number per disc grows with the root of N.
double strips(const Cost& cost) { return cost.particles * std::sqrt(cost.particles); }

struct Model {
    const char *search, *of, *term;
    double (*grown)(const Cost&);
    double (*work)(const Cost&);
};
constexpr auto cycles = [](const Cost& cost) { return cost.per_step; };
constexpr auto pairs = [](const Cost& cost) { return cost.pairs; };
constexpr Model on_chip[] = {{"brute_force", "cycles", "pairs", pairs, cycles},
                             {"sort_and_sweep", "cycles", "pairs", pairs, cycles}};
// Every pair is N (N - 1) / 2 of them: that needs no fit.
constexpr Model on_host[] = {{"sort_and_sweep", "tests", "N^1.5", strips, tests}};

Point point(const Cost& cost, bool host) {
    Point point{.where = host ? "host" : "chip",
                .broad_phase = cost.broad_phase,
                .particles = cost.particles,
                .cost = cost.per_step,
                .unit = host ? "ns" : "cycles"};
    const bool counted = cost.broad_phase != "box2d";
    if (counted) point.pairs = cost.pairs;
    if (host) {
        if (counted) point.ns_per_test = cost.per_step / tests(cost);
        point.runs = cost.runs;
        point.rejected = cost.rejected;
    } else {
        point.ram = cost.ram;
        point.stack = cost.stack;
    }
    return point;
}

// Writes the model's fit into the points of its broad phase. Returns whether the fit is within the
// bound.
bool fits(const Model& model, const std::vector<Cost>& costs, std::vector<Point>& points) {
    std::vector<Sample> samples;
    for (const Cost& cost : of_search(costs, model.search))
        samples.push_back({1.0 * cost.particles, model.grown(cost), model.work(cost)});
    const Fit fit = fitted(samples);
    for (std::size_t i = 0; i < costs.size(); ++i) {
        const Cost& cost = costs[i];
        Point& point = points[i];
        if (cost.broad_phase != model.search) continue;
        point.fit_of = model.of;
        point.fitted = fit({1.0 * cost.particles, model.grown(cost), 0});
        point.fit_constant = fit.a;
        point.fit_linear = fit.b;
        point.fit_term = model.term;
        point.fit_factor = fit.c;
        point.fit_worst_percent = 100 * fit.worst;
    }
    fmt::print(
        stderr,
        "{}: {} = {:.5g} + {:.5g} N + {:.5g} {}, largest miss {:.1f} % of at most {:.0f} %{}\n",
        model.search, model.of, fit.a, fit.b, fit.c, model.term, 100 * fit.worst, 100 * bound,
        samples.size() < enough ? ": too few numbers of particles to judge" : "");
    return samples.size() < enough || fit.worst <= bound;
}

int run(const Options& options) {
    if (!options.host) fixbench::build({"growth_programs"});
    const auto costs = options.host ? costs_on_host(options.most) : costs_on_chip();
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
    const std::span<const Model> models = options.host ? std::span<const Model>(on_host) : on_chip;
    for (const Model& model : models) all_fit = fits(model, costs, points) && all_fit;
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
        "The cost of a step against the number N of particles in a box, with either broad\n"
        "phase, and the pairs that it tests. On the simulated chip N goes up to what the memory\n"
        "holds, and the cycles must follow the pairs. With --host it times discs in the plane\n"
        "on this machine, in nanoseconds, compared with Box2D, and the tests must follow the\n"
        "particles. Exits with 1 if they miss by more than 5 %. File: growth.csv or\n"
        "growth_host.csv.\n\n"
        "Example: fixbench growth",
    .prints = {"growth.csv", "growth_host.csv"},
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<Options>();
            command.add_flag("--host", options->host, "time this machine instead");
            command.add_option("--most", options->most, "largest number of particles on the host")
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
