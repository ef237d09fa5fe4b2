// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/scenes/chip_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <engine/error.hpp>
#include <limits>
#include <stdexcept>

#include "bench/chip/simulator/chip.hpp"
#include "bench/chip/simulator/device_function.hpp"

namespace scene_bench {
namespace {

using simulator::Chip;
using simulator::DeviceFunction;

constexpr simulator::Cycle longest_step = 50'000'000;

// The functions of the program that serve only to measure it.
std::uint32_t measuring_bytes(const simulator::Elf& elf) {
    std::uint32_t bytes = 0;
    for (const char* name : {"position_of", "world_error", "state_hash"})
        if (elf.has_function(name)) bytes += elf.function(name).size;
    return bytes;
}

std::uint32_t empty_program_bytes(const std::filesystem::path& beside) {
    return simulator::Elf(beside.parent_path() / "empty.elf").flash_bytes();
}

// The address of each particle.
std::vector<std::uint16_t> addresses(Chip& chip, unsigned particles) {
    DeviceFunction position_of(chip, "position_of", {.result = 2, .operands = {1}});
    std::vector<std::uint16_t> found;
    for (unsigned i = 0; i < particles; ++i)
        found.push_back(position_of(static_cast<std::uint8_t>(i)).as<std::uint16_t>());
    return found;
}

State read_state(const Chip& chip, const std::vector<std::uint16_t>& addresses, Layout layout,
                 unsigned dimensions) {
    State state;
    for (const std::uint16_t address : addresses) {
        ParticleState& particle = state.emplace_back();
        for (unsigned i = 0; i < dimensions; ++i) {
            const std::uint8_t* const position = chip.data() + address + i * layout.bytes;
            particle.position[i] = layout.value(position);
            particle.velocity[i] = layout.value(position + dimensions * layout.bytes);
        }
    }
    return state;
}

}  // namespace

double Layout::range() const {
    if (fraction_bits < 0) return std::numeric_limits<double>::infinity();
    return std::ldexp(1.0, 8 * bytes - 1 - fraction_bits);
}

double Layout::value(const std::uint8_t* raw) const {
    if (fraction_bits < 0) {
        float value;
        std::memcpy(&value, raw, sizeof value);
        return value;
    }
    std::uint64_t bits = 0;  // both machines are little-endian
    std::memcpy(&bits, raw, static_cast<std::size_t>(bytes));
    const int unused = 64 - 8 * bytes;
    return std::ldexp(static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused),
                      -fraction_bits);
}

Layout layout_of(std::string_view scalar) {
    if (scalar == "float") return {4, -1};
    int integer_bits = 0, fraction_bits = 0;
    const char* const end = scalar.data() + scalar.size();
    const auto integer = std::from_chars(scalar.data() + 1, end, integer_bits);
    if (scalar.starts_with('q') && integer.ec == std::errc() && integer.ptr != end &&
        std::from_chars(integer.ptr + 1, end, fraction_bits).ec == std::errc())
        return {(integer_bits + fraction_bits) / 8, fraction_bits};
    throw std::runtime_error(
        fmt::format("unknown scalar '{}': allowed are float, q16_16 and the like", scalar));
}

std::filesystem::path program_path(const std::filesystem::path& folder, std::string_view scene,
                                   std::string_view scalar, std::string_view method,
                                   std::string_view exponent) {
    return folder / fmt::format("{}.{}.{}.{}.elf", scene, scalar, method, exponent);
}

ChipRun run_on_chip(const std::filesystem::path& program, const Scene& scene,
                    std::string_view scalar, int exponent, Hashes hashes) {
    Chip chip{simulator::Elf(program)};
    chip.run_until_function("main");
    const Layout layout = layout_of(scalar);
    DeviceFunction build(chip, "build", {.result = 0, .operands = {}});
    DeviceFunction step(chip, fmt::format("step_{}", exponent), {.result = 0, .operands = {}});
    DeviceFunction error(chip, "world_error", {.result = 1, .operands = {}});
    build.set_budget(longest_step);
    step.set_budget(longest_step);

    ChipRun run;
    run.flash_bytes =
        chip.elf().flash_bytes() - measuring_bytes(chip.elf()) - empty_program_bytes(program);
    run.ram_bytes = chip.elf().ram_bytes();
    build();
    const std::vector<std::uint16_t> places = addresses(chip, scene.particles);
    const unsigned steps = scene.duration << exponent;
    const unsigned between = (1u << exponent) / observations_per_second;
    simulator::Cycle cycles = 0;
    const auto observe = [&] {
        run.trajectory.push_back(read_state(chip, places, layout, scene.dimensions));
        if (!finite(run.trajectory.back())) run.failure = "a number is not finite";
        const auto code = static_cast<engine::Error>(error().as<std::uint8_t>());
        if (code != engine::Error::none) run.failure = engine::describe(code);
    };
    observe();
    while (run.steps < steps && run.failure.empty()) {
        const simulator::Outcome outcome = step();
        ++run.steps;
        cycles += outcome.cycles;
        run.cycles_max = std::max(run.cycles_max, outcome.cycles);
        run.stack_bytes = std::max(run.stack_bytes, outcome.stack_bytes);
        if (hashes == Hashes::of_each_step) {
            DeviceFunction hash(chip, "state_hash", {.result = 4, .operands = {}});
            run.hashes.push_back(hash().as<std::uint32_t>());
        }
        if (run.steps % between == 0) observe();
    }
    run.cycles_mean =
        run.steps == 0 ? 0 : static_cast<double>(cycles) / static_cast<double>(run.steps);
    return run;
}

}  // namespace scene_bench
