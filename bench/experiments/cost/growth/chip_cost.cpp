// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <engine/hash.hpp>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "bench/chip/simulator/device_function.hpp"
#include "bench/experiments/cost/growth/box.hpp"
#include "bench/experiments/cost/growth/cost.hpp"
#include "bench/experiments/cost/growth/counted.hpp"
#include "bench/lab/records/progress.hpp"
#include "this_build.hpp"

namespace growth {
namespace {

using simulator::Chip;
using simulator::DeviceFunction;
using simulator::Elf;

using Numbers = std::integer_sequence<unsigned, GROWTH_NUMBERS>;
constexpr unsigned steps = 64;
constexpr std::uint32_t memory = 2048;

struct Motion {
    double pairs;  // tested in a step, on average
    std::uint32_t hash;
};

template <unsigned N, class Search>
Motion motion() {
    World<N, Counted<Search>> world;
    build<N, Counted<Search>>(world);
    for (unsigned i = 0; i < steps; ++i) growth::step(world);
    return {static_cast<double>(world.pair_memory().pairs) / steps, engine::state_hash(world)};
}

Cost measured(const std::string& search, const std::string& program, unsigned particles,
              const Motion& on_host) {
    const Elf elf(build_folder() / "bench/experiments/cost/growth" /
                  fmt::format("growth_{}_{}.elf", program, particles));
    Chip chip(elf);
    chip.run_until_function("main");
    DeviceFunction build(chip, "build", {.result = 0, .operands = {}});
    DeviceFunction step(chip, "step", {.result = 0, .operands = {}});
    DeviceFunction error(chip, "error", {.result = 1, .operands = {}});
    DeviceFunction hash(chip, "state_hash", {.result = 4, .operands = {}});
    for (DeviceFunction* function : {&build, &step, &hash}) function->set_budget(100'000'000);
    Cost cost{search, particles, 0, on_host.pairs, elf.ram_bytes(), build().stack_bytes};
    for (unsigned i = 0; i < steps; ++i) {
        const auto outcome = step();
        cost.per_step += static_cast<double>(outcome.cycles) / steps;
        cost.stack = std::max<std::uint32_t>(cost.stack, outcome.stack_bytes);
    }
    if (const auto code = error().as<std::uint8_t>(); code != 0)
        throw std::runtime_error(
            fmt::format("box of {} particles: the world reports error {}", particles, code));
    if (hash().as<std::uint32_t>() != on_host.hash)
        throw std::runtime_error(fmt::format(
            "box of {} particles: the pairs counted on the host belong to another motion",
            particles));
    if (cost.ram + cost.stack > memory)
        throw std::runtime_error(
            fmt::format("box of {} particles: {} bytes of data and {} of stack, the chip has {}",
                        particles, cost.ram, cost.stack, memory));
    return cost;
}

template <class Search, unsigned... N>
void add(std::vector<Cost>& costs, const char* search, const char* program,
         records::Progress& progress, std::integer_sequence<unsigned, N...>) {
    ((costs.push_back(measured(search, program, N, motion<N, Search>())), progress.advance()), ...);
}

}  // namespace

std::vector<Cost> costs_on_chip() {
    std::vector<Cost> costs;
    records::Progress progress("growth on the chip", 2 * Numbers::size());
    add<engine::BruteForce>(costs, "brute_force", "BruteForce", progress, Numbers());
    add<engine::SortAndSweep>(costs, "sort_and_sweep", "SortAndSweep", progress, Numbers());
    return costs;
}

}  // namespace growth
