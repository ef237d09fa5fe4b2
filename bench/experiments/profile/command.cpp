// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench profile.
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "bench/chip/profile/profiler.hpp"
#include "bench/chip/profile/report.hpp"
#include "bench/chip/profile/stack_bound.hpp"
#include "bench/experiments/haptic/device_loop.hpp"
#include "bench/experiments/haptic/scenarios.hpp"
#include "bench/experiments/profile/files.hpp"
#include "bench/lab/program/build.hpp"
#include "bench/lab/program/experiment.hpp"
#include "bench/lab/program/output.hpp"
#include "bench/lab/records/progress.hpp"
#include "this_build.hpp"

namespace profile {
namespace {

using simulator::Chip;

constexpr double longest = 3600;  // seconds

struct Options {
    std::filesystem::path program;
    double seconds = 1;
    std::optional<int> from, to;
    std::string scenario;
    std::filesystem::path output, figures;
};

void check(const Options& options) {
    if (!(options.seconds > 0 && options.seconds <= longest))
        throw std::runtime_error(fmt::format("--seconds {}: more than 0 and at most {} are allowed",
                                             options.seconds, longest));
    for (const auto& [name, marker] : {std::pair("--from", options.from), {"--to", options.to}})
        if (marker && (*marker < 0 || *marker > 255))
            throw std::runtime_error(
                fmt::format("{} {}: a marker is a byte, 0 to 255", name, *marker));
}

// Runs the program from reset for the given time, or from the end of the write of one marker to the
// end of the next write of the other.
Profile measure(const Options& options, Chip& chip) {
    std::optional<int> marker;
    chip.on_gpior0_write([&](Cycle, std::uint8_t value) { marker = value; });
    Profiler profiler(chip);
    const auto end = static_cast<Cycle>(options.seconds * Chip::frequency);
    constexpr Cycle millisecond = Chip::frequency / 1000;
    records::Progress progress("profile", end / millisecond);
    Cycle shown = 0;
    // Returns whether the marker came before the end.
    const auto run_to = [&](const std::optional<int>& wanted) {
        while (chip.cycle() < end) {
            marker.reset();
            profiler.step();
            if (chip.cycle() - shown >= millisecond) {
                progress.advance((chip.cycle() - shown) / millisecond);
                shown += (chip.cycle() - shown) / millisecond * millisecond;
            }
            if (wanted && marker == wanted) return true;
        }
        return !wanted;
    };
    const auto require = [&](const std::optional<int>& wanted) {
        if (!run_to(wanted))
            throw std::runtime_error(fmt::format("{}: GPIOR0 was not written {} within {} s",
                                                 options.program.string(), *wanted,
                                                 options.seconds));
    };
    if (options.from) {
        require(options.from);
        profiler.restart();
    }
    require(options.to);
    return profiler.profile();
}

// The program alone, or in the loop with the plant, which advances when the chip observes it.
Profile measure(const Options& options, const simulator::Elf& elf) {
    if (options.scenario.empty()) {
        Chip chip(elf);
        return measure(options, chip);
    }
    const haptic::Scenario scenario = haptic::scenario(options.scenario);
    haptic::DeviceLoop loop(elf, scenario.adapted(haptic::published_parameters()), scenario.script);
    return measure(options, loop.chip());
}

int run(const Options& options) {
    check(options);
    for (const auto& folder : {options.output, options.figures})
        if (!folder.empty()) fixbench::require_writable(folder);
    const simulator::Elf elf(options.program);
    const Profile profile = measure(options, elf);
    const StackBound bound = static_stack_bound(elf);
    fmt::print("{}", readable_report(profile, bound));
    const std::string program = options.program.stem().string();
    const auto& figures = options.figures.empty() ? options.output : options.figures;
    if (!options.output.empty()) save_tables(profile, bound, program, options.output);
    if (!figures.empty()) save_figure(profile, program, figures);
    return EXIT_SUCCESS;
}

const std::filesystem::path lever = build_folder() / "firmware/lever.elf";

const fixbench::Registration registration({
    .name = "profile",
    .description =
        "Where each cycle and stack byte of a program for the ATmega328P goes, function by\n"
        "function; the latencies of its interrupts; and a bound on its stack from its machine\n"
        "code. With --output, for firmware.elf: profile_firmware.csv, interrupts_firmware.csv,\n"
        "stack_firmware.csv, stacks_firmware.folded and the flame graph firmware_flame.svg.\n\n"
        "A function's cycles include its call and return; an inlined function counts for the\n"
        "one that it was inlined into. A marker is a byte that the program writes to GPIOR0.\n\n"
        "Example: fixbench profile firmware.elf --seconds 5 --output profile",
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<Options>();
            command.add_option("program", options->program, "the ELF file")->required();
            command
                .add_option("--seconds", options->seconds,
                            "simulated time from reset; with markers, the longest")
                ->capture_default_str();
            CLI::Option* const from =
                command.add_option("--from", options->from, "begin after this marker");
            command.add_option("--to", options->to, "end at the next marker with this value")
                ->needs(from);
            command.add_option(
                "--scenario", options->scenario,
                "scenario of `fixbench haptic`: a lever coupled to the model of its device");
            command.add_option("--output", options->output, "folder for the files");
            command.add_option("--figures", options->figures,
                               "folder for the flame graph, if not that of --output");
            return [options](const fixbench::Call&) { return run(*options); };
        },
    .steps = {{.name = "profile",
               .arguments = [](const fixbench::Mode& mode) -> std::vector<std::string> {
                   return {"profile", lever,      "--scenario", "poke_while_held", "--seconds",
                           "5",       "--output", mode.data,    "--figures",       mode.figures};
               },
               .writes = {"profile_lever.csv", "interrupts_lever.csv", "stack_lever.csv",
                          "stacks_lever.folded"},
               .figures = {"lever_flame.svg"},
               .targets = {"lever"},
               .reads = {lever},
               .full_seconds = 1,
               .quick_seconds = 1}},
});

}  // namespace
}  // namespace profile
