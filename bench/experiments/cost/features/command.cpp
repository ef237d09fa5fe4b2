// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench features.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "bench/chip/simulator/device_function.hpp"
#include "bench/experiments/cost/features/linked.hpp"
#include "bench/lab/program/build.hpp"
#include "bench/lab/program/experiment.hpp"
#include "bench/lab/program/names.hpp"
#include "bench/lab/records/progress.hpp"
#include "bench/lab/records/record.hpp"
#include "this_build.hpp"

namespace features {
namespace {

using records::column;
using simulator::Chip;
using simulator::DeviceFunction;
using simulator::Elf;

const std::filesystem::path folder = build_folder() / "bench/experiments/cost/features";
constexpr unsigned steps = 256;  // of 2^-10 s

// A row of features.csv: what the program takes in addition to an empty one.
struct Cost {
    std::string scene, feature;
    bool with;
    std::uint32_t flash, ram;
    double cycles_mean;
    std::uint32_t cycles_max;

    static constexpr auto columns =
        std::tuple(column("scene", &Cost::scene), column("feature", &Cost::feature),
                   column("with", &Cost::with), column("flash_bytes", &Cost::flash),
                   column("ram_bytes", &Cost::ram),
                   column("cycles_per_step_mean", &Cost::cycles_mean, "{:.1f}"),
                   column("cycles_per_step_max", &Cost::cycles_max));
};

Cost cost_of(const Program& program, const Elf& empty) {
    const Elf elf(program.measured);
    Chip chip(elf);
    chip.run_until_function("main");
    DeviceFunction build(chip, "build", {.result = 1, .operands = {}});
    DeviceFunction step(chip, "step", {.result = 0, .operands = {}});
    if (const auto error = build().as<std::uint8_t>(); error != 0)
        throw std::runtime_error(
            fmt::format("{}: the world reports error {}", elf.path().string(), error));
    Cost cost{program.scene,
              program.feature,
              program.with,
              elf.flash_bytes() - empty.flash_bytes(),
              elf.ram_bytes() - empty.ram_bytes(),
              0,
              0};
    for (unsigned i = 0; i < steps; ++i) {
        const std::uint32_t cycles = step().cycles;
        cost.cycles_mean += static_cast<double>(cycles) / steps;
        cost.cycles_max = std::max(cost.cycles_max, cycles);
    }
    return cost;
}

int run(const std::vector<std::string>& scenes, const std::filesystem::path& output) {
    auto programs = load_programs(folder);
    // The lever without the engine shows the price of the engine's generality.
    programs.push_back(
        {"lever", "by_hand", true, {"ANCHORED_RODS"}, folder / "features_by_hand.elf", {}});
    std::vector<std::string> known;
    for (const Program& program : programs) known.push_back(program.scene);
    fixbench::check_names("--scene", scenes, known);
    if (!scenes.empty())
        std::erase_if(programs, [&](const Program& program) {
            return std::find(scenes.begin(), scenes.end(), program.scene) == scenes.end();
        });
    const std::filesystem::path empty_program = folder / "features_empty.elf";
    std::vector<std::string> files = {empty_program};
    for (const Program& program : programs) files.push_back(program.measured);
    fixbench::build(files);

    const Elf empty(empty_program);
    std::vector<Cost> costs;
    records::Progress progress("features", programs.size());
    bool clean = true;
    for (const Program& program : programs) {
        costs.push_back(cost_of(program, empty));
        for (const auto& symbol : unneeded(Elf(program.measured), program.uses)) {
            fmt::print(stderr, "{} {}: not needed: {}\n", program.scene, program.feature, symbol);
            clean = false;
        }
        progress.advance();
    }
    records::table_of(costs).save(output / "features.csv");
    return clean ? fixbench::held : fixbench::check_failed;
}

const fixbench::Registration registration({
    .name = "features",
    .description =
        "What each feature of the engine costs: flash and RAM above those of an empty program,\n"
        "and cycles a step, in Q16.16 at -O2; for the lever's scene and for a scene with\n"
        "everything, with and without the feature; for a chain of two rods with each solver; and\n"
        "for the lever written by hand, without the engine. Fails if a program contains code or a "
        "table that it does not use.\n"
        "File: features.csv.\n\n"
        "Example: fixbench features --scene lever",
    .prints = {"features.csv"},
    .add =
        [](CLI::App& command) {
            const auto scenes = std::make_shared<std::vector<std::string>>();
            fixbench::add_selection(command, "--scene", *scenes, "only lever, everything or chain");
            return [scenes](const fixbench::Call& call) { return run(*scenes, call.output); };
        },
    .steps = {{.name = "features",
               .writes = {"features.csv"},
               .targets = {"feature_programs"},
               .reads = {folder},
               .full_seconds = 3,
               .quick_seconds = 8}},
});

}  // namespace
}  // namespace features
