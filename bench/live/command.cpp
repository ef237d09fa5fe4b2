// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench lever.
#include <memory>

#include "bench/lab/program/build.hpp"
#include "bench/lab/program/experiment.hpp"
#include "bench/live/lever.hpp"

namespace live {
namespace {

const fixbench::Registration registration({
    .name = "lever",
    .description =
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
        "          fixbench lever --scenario demonstration --record recordings",
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<Options>();
            options->firmware = HAPTIC_FIRMWARE_FOLDER;
            command.add_option("--arithmetic", options->arithmetic, "q16_16, published or float")
                ->capture_default_str()
                ->check(CLI::IsMember({"q16_16", "published", "float"}));
            command.add_option(
                "--scenario", options->scenario,
                "what happens besides the keys: demonstration, or one of `fixbench haptic`");
            command
                .add_option(
                    "--seconds", options->seconds,
                    "ends after so long; a recording of a scenario with it, after 60 s at most")
                ->check(CLI::Range(0.1, 3600.0));
            command.add_option("--record", options->record, "folder for recordings");
            CLI::Option* const firmware =
                command.add_option("--firmware", options->firmware, "folder of the programs")
                    ->check(CLI::ExistingDirectory);
            return [options, firmware](const fixbench::Call&) {
                if (firmware->count() == 0)
                    fixbench::build({options->arithmetic == "q16_16"
                                         ? "lever"
                                         : "lever_" + options->arithmetic});
                return run_lever(*options);
            };
        },
    .steps = {{.name = "lever",
               .arguments = [](const fixbench::Mode& mode) -> std::vector<std::string> {
                   return {"lever", "--scenario", "demonstration", "--record", mode.data};
               },
               .writes = {"lever.cast", "lever.svg", "replay.json"},
               .targets = {"lever"},
               .reads = {HAPTIC_FIRMWARE_FOLDER "/lever.elf"},
               .full_seconds = 2,
               .quick_seconds = 2}},
});

}  // namespace
}  // namespace live
