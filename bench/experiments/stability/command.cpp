// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench stability, dynamics and advise.
#include <cmath>
#include <map>
#include <memory>
#include <thread>

#include "bench/experiments/stability/advise.hpp"
#include "bench/experiments/stability/dynamics.hpp"
#include "bench/experiments/stability/measure_stability.hpp"
#include "bench/lab/program/build.hpp"
#include "bench/lab/program/experiment.hpp"

namespace stability {
namespace {

using fixbench::Call;
using fixbench::Mode;

const fixbench::Registration measure({
    .name = "stability",
    .description =
        "Stiff and extreme cases, each driven to where it breaks: the limit by bisection, and "
        "what\n"
        "went wrong first, for every scalar and method of the engine. Files: stability.csv\n"
        "and, where neither cases nor subjects are picked, envelope.csv, stability_map.csv, "
        "ablations.csv\n"
        "and suitability.csv (the least error of each width in each scene; not with --quick).\n\n"
        "Example: fixbench stability --case spring_stiffness --scalar q16_16",
    .prints = {"stability.csv"},
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<Options>();
            command.add_flag("--quick", options->quick, "fewer bisections and shorter endurance");
            fixbench::add_selection(command, "--case", options->cases, "only these cases");
            fixbench::add_selection(command, "--scalar", options->scalars,
                                    "only these scalars, e.g. q16_16,float");
            fixbench::add_selection(command, "--integrator", options->integrators,
                                    "only these integrators, e.g. explicit_euler,velocity_verlet");
            return [options](const Call& call) {
                options->output = call.output;
                options->threads = call.threads;
                check_selection(*options);
                if (!is_selection(*options)) fixbench::build({"world_programs"});
                measure_stability(*options);
                return fixbench::held;
            };
        },
    .steps = {{.name = "stability",
               .arguments =
                   [](const Mode& mode) {
                       std::vector<std::string> arguments = {"stability", "--output", mode.data};
                       if (mode.quick) arguments.push_back("--quick");
                       return arguments;
                   },
               .writes = {"stability.csv", "envelope.csv", "stability_map.csv", "ablations.csv"},
               .full_only = {"suitability.csv"},
               .targets = {"world_programs"},
               .reads = {ABLATION_PROGRAMS},
               .full_seconds = 400,
               .quick_seconds = 30}},
});

const fixbench::Registration dynamics({
    .name = "dynamics",
    .description =
        "Motion in the long run, in every scalar and method, beside theory: growth (spectral\n"
        "radius of the map of a step, fitted to the run, beside the method's own), energy (gained\n"
        "over up to 10^6 steps), reversal (distance from the start after a run there and back),\n"
        "order (distance between runs whose links were added in another order), dead_band (where\n"
        "rounding holds a damped spring) and limit_cycle (its period; 1 is rest). An empty\n"
        "`measured` is a run that does not fit the format or wraps. File: dynamics.csv.\n\n"
        "Example: fixbench dynamics --quick",
    .prints = {"dynamics.csv"},
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<DynamicsOptions>();
            command.add_flag("--quick", options->quick, "energies up to 10^5 steps");
            return [options](const Call& call) {
                options->output = call.output;
                options->threads = call.threads;
                measure_dynamics(*options);
                return fixbench::held;
            };
        },
    .steps = {{.name = "dynamics",
               .arguments =
                   [](const Mode& mode) {
                       std::vector<std::string> arguments = {"dynamics", "--output", mode.data};
                       if (mode.quick) arguments.push_back("--quick");
                       return arguments;
                   },
               .writes = {"dynamics.csv"},
               .full_seconds = 120,
               .quick_seconds = 20}},
});

const fixbench::Registration advice({
    .name = "advise",
    .description =
        "Number formats, splits, methods and steps that run a scene within an error, cheapest\n"
        "first, with cycles, flash and the bits that each quantity is away from overflow. All\n"
        "splits Q2.14 to Q12.4, Q4.28 to Q24.8 and Q12.52 to Q40.24 are tried, and float. Exits\n"
        "with 1 where nothing meets the error.\n\n"
        "Example: fixbench advise --scene pendulum --error 5 --unit mm",
    .add =
        [](CLI::App& command) {
            struct Asked {
                AdviceOptions options;
                double unit = 1;
            };
            const auto asked = std::make_shared<Asked>();
            AdviceOptions& options = asked->options;
            options.data = FIXBENCH_SOURCE_FOLDER "/results/data";
            options.threads = std::max(1u, std::thread::hardware_concurrency());
            command
                .add_option("--scene", options.scene,
                            "a scene of engine/src/scenes/, e.g. pendulum")
                ->required();
            command.add_option("--error", options.error, "the largest error of a position")
                ->required()
                ->check([](const std::string& text) {
                    double error = 0;
                    return CLI::detail::lexical_cast(text, error) && std::isfinite(error) &&
                                   error > 0
                               ? std::string()
                               : "a number above 0 is needed, not " + text;
                });
            command.add_option("--unit", asked->unit, "of the error: m, cm, mm or um")
                ->transform(CLI::CheckedTransformer(std::map<std::string, double>{
                    {"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}}));
            command
                .add_option("--data", options.data, "folder of scenes.csv, for cycles and flash")
                ->capture_default_str();
            command.add_option("--lines", options.most, "so many lines at most")
                ->capture_default_str()
                ->check(CLI::Range(1, 10000));
            return [asked](const Call&) {
                AdviceOptions settled = asked->options;
                settled.error *= asked->unit;
                return advise(settled) ? fixbench::held : fixbench::check_failed;
            };
        },
});

}  // namespace
}  // namespace stability
