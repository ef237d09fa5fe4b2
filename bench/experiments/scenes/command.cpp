// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench scenes, initial_states and workload.
#include <memory>

#include "bench/experiments/scenes/initial_states.hpp"
#include "bench/experiments/scenes/measure_scenes.hpp"
#include "bench/experiments/scenes/workload.hpp"
#include "bench/lab/program/build.hpp"
#include "bench/lab/program/experiment.hpp"

namespace scene_bench {
namespace {

using fixbench::Call;

const fixbench::Registration scenes({
    .name = "scenes",
    .description =
        "Error of every scene of engine/src/scenes/ in every scalar, method and time step, "
        "against\n"
        "cycles on the simulated chip. Builds the device programs that were selected where they\n"
        "are out of date. File: scenes.csv.\n\n"
        "error is against the truth; error_method that of the same method in 50 digits; and\n"
        "error_arithmetic is against the same method in 50 digits. Each is the largest distance "
        "of\n"
        "a particle at any quarter of a second, in metres. Rows without cycles ran on the host,\n"
        "which the chip equals bit for bit. A run that failed is a row with its reason.\n\n"
        "Example: fixbench scenes --scene pendulum --scalar q16_16,float",
    .prints = {"scenes.csv"},
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<SceneOptions>();
            options->programs = SCENE_PROGRAMS;
            fixbench::add_selection(command, "--scene", options->scenes,
                                    "only these scenes, e.g. pendulum,lever");
            fixbench::add_selection(command, "--scalar", options->scalars,
                                    "only these scalars, e.g. q16_16,q16_16_saturating,float");
            fixbench::add_selection(command, "--method", options->methods,
                                    "only these methods, e.g. velocity_verlet");
            command.add_flag("--quick", options->quick,
                             "on the chip only steps of 2^-8 s, of semi-implicit Euler and of "
                             "Q16.16; on the host all else, and longer steps");
            return [options](const Call& call) {
                options->output = call.output;
                options->threads = call.threads;
                fixbench::build(programs_of(*options));
                measure_scenes(*options);
                return fixbench::held;
            };
        },
    .steps = {{.name = "scenes",
               .passes_quick = true,
               .writes = {"scenes.csv"},
               .targets = {"scene_programs"},
               .quick_targets = {"scene_quick_programs"},
               .reads = {SCENE_PROGRAMS},
               .full_seconds = 240,
               .quick_seconds = 60}},
});

const fixbench::Registration states({
    .name = "initial_states",
    .description =
        "Error of every scene in every scalar and method from eight initial states drawn from\n"
        "seeds: smallest, median and largest. On the host, which the chip equals bit for bit in\n"
        "fixed point; float is the host's. File: initial_states.csv.\n\n"
        "error is against the truth from the same start; of the box, whose truth is not known,\n"
        "against the same method and step in double. Runs that fail, or are off by more than the\n"
        "size of the scene, are not held.\n\n"
        "Example: fixbench initial_states --scene pendulum",
    .prints = {"initial_states.csv"},
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<StateOptions>();
            fixbench::add_selection(command, "--scene", options->scenes,
                                    "only these scenes, e.g. pendulum,lever");
            return [options](const Call& call) {
                options->output = call.output;
                options->threads = call.threads;
                measure_initial_states(*options);
                return fixbench::held;
            };
        },
    .steps = {{.name = "initial_states",
               .writes = {"initial_states.csv"},
               .full_seconds = 30,
               .quick_seconds = 30}},
});

const fixbench::Registration workload({
    .name = "workload",
    .description =
        "The published lever with the 2016 design's arithmetic, ours and float on one source: its "
        "step,\n"
        "what its parts cost inside the running engine, and how many steps a second that makes,\n"
        "beside the published figures. Files: workload.csv, workload_rounds.csv (cycles by rounds\n"
        "of contact resolution) and workload_trace.csv (one step, call by call).",
    .prints = {"workload.csv"},
    .add =
        [](CLI::App&) {
            return [](const Call& call) {
                fixbench::build({"workload_programs"});
                measure_workload({WORKLOAD_PROGRAMS, call.output, call.threads});
                return fixbench::held;
            };
        },
    .steps = {{.name = "workload",
               .writes = {"workload.csv", "workload_rounds.csv", "workload_trace.csv"},
               .targets = {"workload_programs"},
               .reads = {WORKLOAD_PROGRAMS},
               .full_seconds = 15,
               .quick_seconds = 15}},
});

}  // namespace
}  // namespace scene_bench
