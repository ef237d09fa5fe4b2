// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that run for a long time on the simulated chip and on the host, side by side: soak
// [STEPS], by default 10^7 steps of 2^-8 s of the lever, the stack and the box in Q16.16. Every 100
// steps the hashes of both states are compared, and all particles get other velocities along y, the
// same on both sides. Left alone, the stack comes to rest after 127 steps and the lever repeats its
// swings to the last bit after 65,535, so that nothing more would be tested. A difference or an
// error is reported with the steps between which it occurred. The velocities are drawn from one
// seed, so that the same call reproduces it.
#include <fmt/format.h>

#include <atomic>
#include <charconv>
#include <cstdlib>
#include <iterator>
#include <random>
#include <thread>

#include "bench/chip/simulator/device_function.hpp"
#include "bench/experiments/scenes/chip_run.hpp"
#include "bench/experiments/scenes/host/describe.hpp"
#include "bench/lab/parallel.hpp"
#include "bench/lab/records/progress.hpp"

namespace scene_bench {
namespace {

constexpr int exponent = 8;
constexpr unsigned long between_pushes = 100;

// The first difference, or nothing.
template <class SceneType>
std::string soaked(unsigned long steps, records::Progress& progress) {
    using World = WorldOf<SceneType, scalars::q16_16, scenes::SemiImplicit>;
    using Raw = std::int32_t;
    World world;
    scenes::build<SceneType>(world);
    simulator::Chip chip{simulator::Elf(program_path(SCENE_PROGRAMS, SceneType::name, "q16_16",
                                                     scenes::SemiImplicit::name, "hash"))};
    chip.run_until_function("main");
    simulator::DeviceFunction build(chip, "build", {.result = 0, .operands = {}}),
        step(chip, "step_8", {.result = 0, .operands = {}}),
        position_of(chip, "position_of", {.result = 2, .operands = {1}}),
        error(chip, "world_error", {.result = 1, .operands = {}}),
        hash(chip, "state_hash", {.result = 4, .operands = {}});
    for (simulator::DeviceFunction* function : {&build, &step, &hash})
        function->set_budget(50'000'000);
    build();
    std::mt19937 random(1);
    for (unsigned long done = 0; done < steps;) {
        const unsigned long from = done, until = std::min(from + between_pushes, steps);
        for (; done < until; ++done) {
            world.step(PowerOfTwoStep{exponent});
            step();
        }
        const auto on_host = engine::state_hash(world), on_chip = hash().as<std::uint32_t>();
        if (on_host != on_chip)
            return fmt::format("{}: between steps {} and {} host and chip part: {:08x}, {:08x}",
                               SceneType::name, from, done, on_host, on_chip);
        const auto code = static_cast<engine::Error>(error().as<std::uint8_t>());
        if (code != engine::Error::none || world.error() != code)
            return fmt::format("{}: between steps {} and {}: {} on the chip, {} on the host",
                               SceneType::name, from, done, engine::describe(code),
                               engine::describe(world.error()));
        std::uint8_t i = 0;
        for (auto& particle : world.particles()) {
            const Raw velocity = static_cast<Raw>(random() % (1 << 18)) - (1 << 17);  // +-2 m/s
            particle.velocity[1] = scalars::q16_16::from_raw(velocity);
            const auto position = position_of(i++).template as<std::uint16_t>();
            std::uint8_t bytes[sizeof velocity];
            std::memcpy(bytes, &velocity, sizeof bytes);
            chip.write(static_cast<std::uint16_t>(position + (World::dimensions + 1) * sizeof(Raw)),
                       bytes);
        }
        progress.advance(done - from);
    }
    return "";
}

bool number(const char* text, unsigned long& value) {
    const char* const end = text + std::string_view(text).size();
    const auto [rest, status] = std::from_chars(text, end, value);
    return status == std::errc() && rest == end && value > 0;
}

}  // namespace
}  // namespace scene_bench

int main(int argc, char** argv) {
    using namespace scene_bench;
    unsigned long steps = 10'000'000;
    if (argc > 2 || (argc > 1 && !number(argv[1], steps))) {
        fmt::print(stderr, "usage: soak [STEPS], a whole number above 0\n");
        return 2;
    }
    std::string (*const scenes[])(unsigned long, records::Progress&) = {
        soaked<scenes::Stack>, soaked<scenes::BoxOfParticles>, soaked<scenes::Lever>};
    constexpr std::size_t count = std::size(scenes);
    std::atomic<int> status{0};
    try {
        records::Progress progress("soak", count * steps);
        operations::in_parallel(std::thread::hardware_concurrency(), count, [&](std::size_t i) {
            const std::string found = scenes[i](steps, progress);
            if (found.empty()) return;
            fmt::print(stderr, "soak: {}\n", found);
            status = 1;
        });
    } catch (const std::exception& error) {
        fmt::print(stderr, "soak: {}\n", error.what());
        return 1;
    }
    if (status == 0)
        fmt::print("soak: {} scenes, {} steps each: {} hashes of the chip's state are the host's\n",
                   count, steps, count * ((steps - 1) / between_pushes + 1));
    return status;
}
