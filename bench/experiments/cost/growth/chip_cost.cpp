// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "bench/chip/simulator/device_function.hpp"
#include "bench/experiments/cost/growth/cost.hpp"
#include "bench/lab/records/progress.hpp"

namespace growth {
namespace {

using simulator::Chip;
using simulator::DeviceFunction;
using simulator::Elf;

constexpr unsigned numbers[] = {GROWTH_NUMBERS};
constexpr unsigned steps = 64;
constexpr std::uint32_t memory = 2048;

Cost measured(const std::string& search, const std::string& program, unsigned particles) {
    const Elf elf(std::filesystem::path(GROWTH_PROGRAM_FOLDER) /
                  fmt::format("growth_{}_{}.elf", program, particles));
    Chip chip(elf);
    chip.run_until_function("main");
    DeviceFunction build(chip, "build", {.result = 0, .operands = {}});
    DeviceFunction step(chip, "step", {.result = 0, .operands = {}});
    DeviceFunction error(chip, "error", {.result = 1, .operands = {}});
    build.set_budget(100'000'000);
    step.set_budget(100'000'000);
    Cost cost{search, particles, 0, elf.ram_bytes(), build().stack_bytes};
    for (unsigned i = 0; i < steps; ++i) {
        const auto outcome = step();
        cost.per_step += static_cast<double>(outcome.cycles) / steps;
        cost.stack = std::max<std::uint32_t>(cost.stack, outcome.stack_bytes);
    }
    if (const auto code = error().as<std::uint8_t>(); code != 0)
        throw std::runtime_error(
            fmt::format("box of {} particles: the world reports error {}", particles, code));
    if (cost.ram + cost.stack > memory)
        throw std::runtime_error(
            fmt::format("box of {} particles: {} bytes of data and {} of stack, the chip has {}",
                        particles, cost.ram, cost.stack, memory));
    return cost;
}

}  // namespace

std::vector<Cost> costs_on_chip() {
    std::vector<Cost> costs;
    records::Progress progress("growth on the chip", 2 * std::size(numbers));
    for (const auto& [search, program] :
         {std::pair("brute_force", "BruteForce"), {"sort_and_sweep", "SortAndSweep"}})
        for (const unsigned particles : numbers) {
            costs.push_back(measured(search, program, particles));
            progress.advance();
        }
    return costs;
}

}  // namespace growth
