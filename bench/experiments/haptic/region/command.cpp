// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/region/command.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <thread>

#include "bench/experiments/haptic/region/region.hpp"

namespace haptic::region {

void add_region_command(CLI::App& app, fixbench::Action& action) {
    const auto options = std::make_shared<Options>();
    options->output = "results/data";
    options->threads = std::max(1u, std::thread::hardware_concurrency());
    CLI::App* const command = app.add_subcommand(
        "region",
        "Where a held lever is still: arm length x loop rate x stiffness of the hand, for each\n"
        "arithmetic, with and without the selective damping, over a family of plants, beside the\n"
        "linear theory. The firmware's lever runs on the host by the chip's schedule; the\n"
        "simulated chip checks it at the shortest arm, and differences are printed. It swings\n"
        "where, after a poke, it moves by more than 1.5 degrees in the last of four seconds.\n"
        "Writes stable_region.csv, stable_limits.csv, stable_changes.csv, stable_on_chip.csv and\n"
        "oscillation.csv.");
    command->add_flag("--quick", options->quick, "fewer plants, rates, arms and hands");
    command->add_option("--output", options->output, "folder that the data files are written to")
        ->capture_default_str();
    command->add_option("--threads", options->threads, "threads to run on")
        ->capture_default_str()
        ->check(CLI::Range(1, 1024));
    command->callback([options, &action] {
        action = [options] {
            measure_region(*options);
            return EXIT_SUCCESS;
        };
    });
}

}  // namespace haptic::region
