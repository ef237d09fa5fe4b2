// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench stability and dynamics.
#include <memory>

#include "bench/experiments/stability/dynamics.hpp"
#include "bench/experiments/stability/float_extremes.hpp"
#include "bench/experiments/stability/measure_stability.hpp"
#include "bench/lab/program/build.hpp"
#include "bench/lab/program/experiment.hpp"
#include "this_build.hpp"

namespace stability {
namespace {

using fixbench::Call;

const fixbench::Registration measure({
    .name = "stability",
    .description =
        "Stiff and extreme cases, each driven until it breaks: the limit, by a sweep and\n"
        "bisection, and what went wrong first, for every scalar and method of the engine;\n"
        "`contradicting` counts the values of the sweep that contradict it. Files: stability.csv\n"
        "and, unless cases or subjects are selected, envelope.csv, stability_map.csv,\n"
        "ablations.csv and suitability.csv (the smallest error of each width in each scene; not\n"
        "with --quick).\n\n"
        "Example: fixbench stability --case spring_stiffness --scalar q16_16",
    .prints = {"stability.csv"},
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<Options>();
            command.add_flag("--quick", options->quick,
                             "fewer bisections, a coarser sweep and shorter endurance");
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
               .passes_quick = true,
               .writes = {"stability.csv", "envelope.csv", "stability_map.csv", "ablations.csv"},
               .full_only = {"suitability.csv"},
               .targets = {"world_programs"},
               .reads = {build_folder() / "bench/experiments/stability"},
               .full_seconds = 170,
               .quick_seconds = 30}},
});

const fixbench::Registration dynamics({
    .name = "dynamics",
    .description =
        "Motion in the long run, in every scalar and method, next to theory:\n"
        "  growth       spectral radius of the map of a step, fitted to the run, and the method's\n"
        "  energy       gained over up to 10^6 steps\n"
        "  reversal     distance from the start after a run there and back\n"
        "  order        distance between runs whose links were added in another order\n"
        "  dead_band    where rounding holds a damped spring\n"
        "  limit_cycle  the period of what it does there; 1 is rest\n"
        "  divergence   when rounding separates a chaotic double pendulum from its run in double\n"
        "  divergence_rate  how fast the two then separate\n"
        "An empty `measured` is a run that does not fit the format or wraps, or does not\n"
        "separate in its time. File: dynamics.csv.\n\n"
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
               .passes_quick = true,
               .writes = {"dynamics.csv"},
               .full_seconds = 20,
               .quick_seconds = 30}},
});

const fixbench::Registration extremes({
    .name = "float_extremes",
    .description =
        "Compares avr-libc's float on the simulated chip with the host's, which follows IEEE\n"
        "754: every operation of the engine on all pairs of a table of extremes (zeros,\n"
        "subnormals, ends of the range, infinities, NaN) and on seeded random pairs; how many\n"
        "differ, and the first.\n"
        "File: float_extremes.csv.\n\n"
        "Example: fixbench float_extremes",
    .prints = {"float_extremes.csv"},
    .add =
        [](CLI::App&) {
            return [](const Call& call) {
                fixbench::build({"float_operations"});
                measure_float_extremes(call.output);
                return fixbench::held;
            };
        },
    .steps = {{.name = "float_extremes",
               .writes = {"float_extremes.csv"},
               .targets = {"float_operations"},
               .reads = {float_program()},
               .full_seconds = 2,
               .quick_seconds = 2}},
});

}  // namespace
}  // namespace stability
