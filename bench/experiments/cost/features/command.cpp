// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/cost/features/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "bench/experiments/cost/features/linked.hpp"
#include "bench/lab/records/csv.hpp"
#include "bench/lab/records/progress.hpp"
#include "bench/chip/simulator/device_function.hpp"

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

int run(const std::filesystem::path& output) {
    const std::filesystem::path folder = FEATURE_PROGRAM_FOLDER;
    const Elf empty(folder / "features_empty.elf");
    const auto programs = load_programs(folder);
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
    if (output.empty())
        fmt::print("{}", table.to_csv());
    else
        table.save(output / "features.csv");
    return clean ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

void add_features_command(CLI::App& app, fixbench::Action& action) {
    const auto output = std::make_shared<std::filesystem::path>();
    CLI::App* const command = app.add_subcommand(
        "features",
        "What each feature of the engine costs: flash and RAM beside an empty program and cycles\n"
        "a step, in Q16.16 at -O2, of the lever's scene and of a scene with everything, with the\n"
        "feature in and out. Fails where a program holds code or a table that it does not use.\n\n"
        "Example: fixbench features --output results/data");
    command->add_option("--output", *output, "folder for features.csv; printed without");
    command->callback([&action, output] { action = [output] { return run(*output); }; });
}

}  // namespace features
