// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench stability.
#include <memory>

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

}  // namespace
}  // namespace stability
