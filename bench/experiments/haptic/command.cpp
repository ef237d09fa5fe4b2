// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <thread>

#include "bench/experiments/haptic/haptic.hpp"
#include "bench/experiments/haptic/workload.hpp"

namespace haptic {

void add_haptic_command(CLI::App& app, fixbench::Action& action) {
    const auto options = std::make_shared<Options>();
    options->firmware = HAPTIC_FIRMWARE_FOLDER;
    options->output = "results/data";
    options->threads = std::max(1u, std::thread::hardware_concurrency());
    CLI::App* const command = app.add_subcommand(
        "haptic",
        "The lever's firmware in the simulated chip, coupled to a model of servo, foam, sensors\n"
        "and hand, through every scenario: does it keep its envelope and its time?\n"
        "Writes haptic.csv and, where all scenarios are run, workload_firmware.csv, the published\n"
        "figures beside ours, and haptic_pins.csv, the profiling pins' timing.\n\n"
        "With --record each run is written too: <scenario>.<arithmetic>.csv, .vcd (pins, as logic\n"
        "analysers have them) and .screen.txt.\n\n"
        "Example: fixbench haptic --scenario bounce --arithmetic q16_16 --record recordings");
    command->add_option("--scenario", options->scenarios, "only these scenarios")->delimiter(',');
    command
        ->add_option("--arithmetic", options->arithmetics, "only these: q16_16, published, float")
        ->delimiter(',');
    command
        ->add_option("--seconds", options->longest,
                     "scenarios end after so long; by default an hour for q16_16, where nothing is "
                     "recorded, and 240 for the others")
        ->check(CLI::Range(1, 1000000));
    command->add_option("--threads", options->threads, "threads to run on")
        ->capture_default_str()
        ->check(CLI::Range(1, 1024));
    command->add_option("--record", options->record, "folder for recordings");
    command->add_option("--firmware", options->firmware, "folder of the programs")
        ->check(CLI::ExistingDirectory);
    command->add_option("--output", options->output, "folder that the data files are written to")
        ->capture_default_str();
    command->callback([options, &action] {
        action = [options] {
            const std::uint64_t failed = run_scenarios(*options);
            if (options->scenarios.empty() && options->arithmetics.empty())
                write_workload(*options);
            if (failed == 0) return EXIT_SUCCESS;
            fmt::print(stderr, "fixbench: {} runs left their envelope: see {}\n", failed,
                       (options->output / "haptic.csv").string());
            return EXIT_FAILURE;
        };
    });
}

}  // namespace haptic
