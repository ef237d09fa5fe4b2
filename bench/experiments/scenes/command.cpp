// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench scenes, initial_states and workload.
#include <memory>

#include "bench/experiments/scenes/chip_run.hpp"
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
        "Error of every scene of engine/src/scenes/ in every scalar, method and time step,\n"
        "against cycles on the simulated chip. Builds the selected device programs that are out\n"
        "of date.\n"
        "File: scenes.csv.\n\n"
        "`error` is the distance from the truth, `error_method` that of the same method in 50\n"
        "digits, `error_arithmetic` the distance from that method. Each is the largest over all\n"
        "particles and quarters of a second, in metres. The arithmetic `compensated` is the\n"
        "default one with compensated integration. Rows without cycles ran on the host,\n"
        "whose results equal the chip's bit for bit. A failed run is a row with its reason.\n\n"
        "Example: fixbench scenes --scene pendulum --scalar q16_16,float",
    .prints = {"scenes.csv"},
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<SceneOptions>();
            options->programs = scene_programs();
            fixbench::add_selection(command, "--scene", options->scenes,
                                    "only these scenes, e.g. pendulum,lever");
            fixbench::add_selection(command, "--scalar", options->scalars,
                                    "only these scalars, e.g. q16_16,q16_16_saturating,float");
            fixbench::add_selection(command, "--method", options->methods,
                                    "only these methods, e.g. velocity_verlet");
            command.add_flag("--quick", options->quick,
                             "on the chip, only steps of 2^-8 s, semi-implicit Euler and "
                             "Q16.16; on the host, everything else, with longer steps");
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
               .reads = {scene_programs()},
               .full_seconds = 100,
               .quick_seconds = 60}},
});

const fixbench::Registration states({
    .name = "initial_states",
    .description =
        "Error of every scene in every scalar and method over eight seeded initial states:\n"
        "smallest, median and largest. Runs on the host, whose fixed-point results equal the\n"
        "chip's bit for bit; float is the host's. File: initial_states.csv.\n\n"
        "`error` is against the truth from the same start; for the box, whose truth is not\n"
        "known, against the same method and step in double. Runs that fail, or are off by more\n"
        "than the size of the scene, do not count as held.\n\n"
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
               .full_seconds = 2,
               .quick_seconds = 2}},
});

const fixbench::Registration workload({
    .name = "workload",
    .description =
        "The published lever with the 2016 design's arithmetic, ours and float, from one\n"
        "source: its step, what its parts cost inside the running engine, and how many steps a\n"
        "second that allows, next to the published figures. Files: workload.csv,\n"
        "workload_rounds.csv (cycles by rounds of contact resolution) and workload_trace.csv\n"
        "(one step, call by call).",
    .prints = {"workload.csv"},
    .add =
        [](CLI::App&) {
            return [](const Call& call) {
                fixbench::build({"workload_programs"});
                measure_workload({workload_programs(), call.output, call.threads});
                return fixbench::held;
            };
        },
    .steps = {{.name = "workload",
               .writes = {"workload.csv", "workload_rounds.csv", "workload_trace.csv"},
               .targets = {"workload_programs"},
               .reads = {workload_programs()},
               .full_seconds = 3,
               .quick_seconds = 3}},
});

}  // namespace
}  // namespace scene_bench
