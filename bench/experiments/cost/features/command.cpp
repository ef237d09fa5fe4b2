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
#include "bench/lab/records/csv.hpp"
#include "bench/lab/records/progress.hpp"

namespace features {
namespace {

using simulator::Chip;
using simulator::DeviceFunction;
using simulator::Elf;

constexpr unsigned steps = 256;  // of 2^-10 s

struct Cost {
    std::uint32_t flash, ram;
    double mean;
    std::uint32_t most;
};

// Beside what an empty program takes.
Cost cost_of(const std::filesystem::path& program, const Elf& empty) {
    const Elf elf(program);
    Chip chip(elf);
    chip.run_until_function("main");
    DeviceFunction build(chip, "build", {.result = 1, .operands = {}});
    DeviceFunction step(chip, "step", {.result = 0, .operands = {}});
    if (const auto error = build().as<std::uint8_t>(); error != 0)
        throw std::runtime_error(
            fmt::format("{}: the world reports error {}", program.string(), error));
    Cost cost{elf.flash_bytes() - empty.flash_bytes(), elf.ram_bytes() - empty.ram_bytes(), 0, 0};
    for (unsigned i = 0; i < steps; ++i) {
        const std::uint32_t cycles = step().cycles;
        cost.mean += static_cast<double>(cycles) / steps;
        cost.most = std::max(cost.most, cycles);
    }
    return cost;
}

int run(const std::vector<std::string>& scenes, const std::filesystem::path& output) {
    const std::filesystem::path folder = FEATURE_PROGRAM_FOLDER;
    auto programs = load_programs(folder);
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
    records::Table table({"scene", "feature", "with", "flash_bytes", "ram_bytes",
                          "cycles_per_step_mean", "cycles_per_step_max"});
    records::Progress progress("features", programs.size());
    bool clean = true;
    for (const Program& program : programs) {
        const Cost cost = cost_of(program.measured, empty);
        table.add({program.scene, program.feature, program.with ? "yes" : "no",
                   std::to_string(cost.flash), std::to_string(cost.ram),
                   fmt::format("{:.1f}", cost.mean), std::to_string(cost.most)});
        for (const auto& symbol : unneeded(Elf(program.measured), program.uses)) {
            fmt::print(stderr, "{} {}: not needed: {}\n", program.scene, program.feature, symbol);
            clean = false;
        }
        progress.advance();
    }
    table.save(output / "features.csv");
    return clean ? fixbench::held : fixbench::check_failed;
}

const fixbench::Registration registration({
    .name = "features",
    .description =
        "What each feature of the engine costs: flash and RAM beside an empty program and cycles\n"
        "a step, in Q16.16 at -O2, of the lever's scene and of a scene with everything, with the\n"
        "feature in and out. Fails where a program holds code or a table that it does not use.\n"
        "File: features.csv.\n\n"
        "Example: fixbench features --scene lever",
    .prints = {"features.csv"},
    .add =
        [](CLI::App& command) {
            const auto scenes = std::make_shared<std::vector<std::string>>();
            fixbench::add_selection(command, "--scene", *scenes, "only lever or everything");
            return [scenes](const fixbench::Call& call) { return run(*scenes, call.output); };
        },
    .steps = {{.name = "features",
               .arguments = [](const fixbench::Mode& mode) -> std::vector<std::string> {
                   return {"features", "--output", mode.data};
               },
               .writes = {"features.csv"},
               .targets = {"feature_programs"},
               .reads = {FEATURE_PROGRAM_FOLDER},
               .full_seconds = 8,
               .quick_seconds = 8}},
});

}  // namespace
}  // namespace features
