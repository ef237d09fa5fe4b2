// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench lever.
#include <memory>

#include "bench/lab/program/build.hpp"
#include "bench/lab/program/experiment.hpp"
#include "bench/live/lever.hpp"
#include "this_build.hpp"

namespace live {
namespace {

const fixbench::Registration registration({
    .name = "lever",
    .description =
        "Shows the device live in a terminal of 80 x 24: the lever's firmware on the simulated\n"
        "chip, in real time. The keys are the hand, the dial and the faults.\n\n"
        "With --record, what was shown is written: lever.cast (asciinema), lever.svg (plays the\n"
        "first 10 s in a browser) and replay.json (for the replay page of the report). With\n"
        "--scenario as well, it needs neither terminal nor keys, and the same program gives the\n"
        "same files.\n\n"
        "Keys: up, down (k, j) push the lever; space grips it or lets go; right, left (l, h)\n"
        "turn the dial; u unplugs a sensor, then the other, then none; s stalls the servo; f\n"
        "asks for a full frame; r resets; q ends.\n\n"
        "Examples: fixbench lever\n"
        "          fixbench lever --scenario demonstration --record recordings",
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<Options>();
            options->firmware = build_folder() / "firmware";
            command.add_option("--arithmetic", options->arithmetic, "q16_16, published or float")
                ->capture_default_str()
                ->check(CLI::IsMember({"q16_16", "published", "float"}));
            command.add_option(
                "--scenario", options->scenario,
                "what happens besides the keys: demonstration, or a scenario of `fixbench haptic`");
            command
                .add_option("--seconds", options->seconds,
                            "end after this time; a recorded scenario ends after at most 60 s")
                ->check(CLI::Range(0.1, 3600.0));
            command.add_option("--record", options->record, "folder for recordings");
            CLI::Option* const firmware =
                command.add_option("--firmware", options->firmware, "folder with the programs")
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
               .reads = {build_folder() / "firmware/lever.elf"},
               .full_seconds = 2,
               .quick_seconds = 2}},
});

}  // namespace
}  // namespace live
