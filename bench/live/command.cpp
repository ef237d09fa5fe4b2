// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/live/command.hpp"

#include <memory>

#include "bench/live/lever.hpp"

namespace live {

void add_lever_command(CLI::App& app, fixbench::Action& action) {
    const auto options = std::make_shared<Options>();
    options->firmware = HAPTIC_FIRMWARE_FOLDER;
    CLI::App* const command = app.add_subcommand(
        "lever",
        "The device live in a terminal of 80 x 24: the lever's firmware in the simulated chip,\n"
        "paced to the clock on the wall; the keys are the hand, the dial and what goes wrong.\n\n"
        "With --record what was shown is written: lever.cast (asciinema), lever.svg (plays in a\n"
        "browser, the first 10 s) and replay.json (for the replay page of the report). With\n"
        "--scenario besides it needs no terminal and nobody: the same files for the same "
        "program.\n\n"
        "Keys: up, down (k, j) push the lever; space grips it or lets go; right, left (l, h) turn\n"
        "the dial; u unplugs a sensor, the other, none; s stalls the servo; f asks for a full\n"
        "frame; r resets; q ends.\n\n"
        "Examples: fixbench lever\n"
        "          fixbench lever --scenario demonstration --record recordings");
    command->add_option("--arithmetic", options->arithmetic, "q16_16, published or float")
        ->capture_default_str()
        ->check(CLI::IsMember({"q16_16", "published", "float"}));
    command->add_option(
        "--scenario", options->scenario,
        "what happens besides the keys: demonstration, or one of `fixbench haptic`");
    command
        ->add_option("--seconds", options->seconds,
                     "ends after so long; a recording of a scenario with it, after 60 s at most")
        ->check(CLI::Range(0.1, 3600.0));
    command->add_option("--record", options->record, "folder for recordings");
    command->add_option("--firmware", options->firmware, "folder of the programs")
        ->check(CLI::ExistingDirectory);
    command->callback([options, &action] { action = [options] { return run_lever(*options); }; });
}

}  // namespace live
