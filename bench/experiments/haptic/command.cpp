// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench haptic.
#include <fmt/format.h>

#include <memory>

#include "bench/experiments/haptic/haptic.hpp"
#include "bench/experiments/haptic/workload.hpp"
#include "bench/lab/program/build.hpp"
#include "bench/lab/program/experiment.hpp"
#include "bench/lab/program/output.hpp"
#include "this_build.hpp"

namespace haptic {
namespace {

const std::vector<std::string> programs = {
    "lever",          "lever_published",          "lever_float",
    "lever_profiled", "lever_published_profiled", "lever_arduino"};

const fixbench::Registration registration({
    .name = "haptic",
    .description =
        "Runs the lever's firmware on the simulated chip, coupled to a model of servo, foam,\n"
        "sensors and hand, through every scenario: does it stay in its envelope and keep its\n"
        "time?\n"
        "Files: haptic.csv and, if all scenarios are run, workload_firmware.csv (the published\n"
        "figures next to ours) and haptic_pins.csv (the timing of the profiling pins).\n\n"
        "With --record each run is written too: <scenario>.<arithmetic>.csv, .vcd (pins, for\n"
        "logic analysers) and .screen.txt.\n\n"
        "Example: fixbench haptic --scenario bounce --arithmetic q16_16 --record recordings",
    .prints = {"haptic.csv"},
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<Options>();
            options->firmware = build_folder() / "firmware";
            fixbench::add_selection(command, "--scenario", options->scenarios,
                                    "only these scenarios");
            fixbench::add_selection(command, "--arithmetic", options->arithmetics,
                                    "only these: q16_16, published, float");
            command
                .add_option("--seconds", options->longest,
                            "scenarios end after this time (default: 240 s; for q16_16 "
                            "without --record, an hour)")
                ->check(CLI::Range(1, 1000000));
            command.add_option("--record", options->record, "folder for recordings");
            CLI::Option* const firmware =
                command.add_option("--firmware", options->firmware, "folder with the programs")
                    ->check(CLI::ExistingDirectory);
            return [options, firmware](const fixbench::Call& call) {
                if (firmware->count() == 0) fixbench::build(programs);
                options->output = call.output;
                options->threads = call.threads;
                if (!options->record.empty()) fixbench::require_writable(options->record);
                const std::uint64_t failed = run_scenarios(*options);
                if (options->scenarios.empty() && options->arithmetics.empty())
                    write_workload(*options);
                if (failed == 0) return fixbench::held;
                fmt::print(stderr, "fixbench: {} runs left their envelope; see haptic.csv\n",
                           failed);
                return fixbench::check_failed;
            };
        },
    .steps = {{.name = "haptic",
               .arguments =
                   [](const fixbench::Mode& mode) {
                       std::vector<std::string> arguments = {"haptic", "--output", mode.data};
                       if (mode.quick) arguments.insert(arguments.end(), {"--seconds", "5"});
                       return arguments;
                   },
               .writes = {"haptic.csv", "haptic_pins.csv", "workload_firmware.csv"},
               .targets = programs,
               .reads = {build_folder() / "firmware"},
               .full_seconds = 400,
               .quick_seconds = 60}},
});

}  // namespace
}  // namespace haptic
