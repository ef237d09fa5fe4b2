// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench region.
#include <memory>

#include "bench/experiments/haptic/region/region.hpp"
#include "bench/lab/program/build.hpp"
#include "bench/lab/program/experiment.hpp"
#include "this_build.hpp"

namespace haptic::region {
namespace {

const fixbench::Registration registration({
    .name = "region",
    .description =
        "Searches where a held lever is at rest: arm length x loop rate x stiffness of the\n"
        "hand, for each arithmetic, with and without the selective damping, compared with the\n"
        "linear theory. The plants are those on which the 2016 design falls and swings as\n"
        "published. The firmware's lever runs on the host, on the chip's schedule; the\n"
        "simulated chip checks it at the shortest arm, and differences are printed. A lever\n"
        "swings if, after a poke, it moves by more than 1.5 degrees in the last of four\n"
        "seconds.\n"
        "Files: identification.csv, stable_region.csv, stable_limits.csv, stable_changes.csv,\n"
        "stable_on_chip.csv and oscillation.csv.",
    .prints = {"stable_limits.csv"},
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<Options>();
            command.add_flag("--quick", options->quick, "fewer plants, rates, arms and hands");
            return [options](const fixbench::Call& call) {
                fixbench::build({"held_levers"});
                options->output = call.output;
                options->threads = call.threads;
                measure_region(*options);
                return fixbench::held;
            };
        },
    .steps = {{.name = "region",
               .passes_quick = true,
               .writes = {"identification.csv", "stable_region.csv", "stable_limits.csv",
                          "stable_changes.csv", "stable_on_chip.csv", "oscillation.csv"},
               .targets = {"held_levers"},
               .reads = {build_folder() / "bench/experiments/haptic/region"},
               .full_seconds = 500,
               .quick_seconds = 25}},
});

}  // namespace
}  // namespace haptic::region
