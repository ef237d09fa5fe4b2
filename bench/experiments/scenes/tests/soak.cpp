// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that run for long on the simulated chip and on the host, side by side: soak [STEPS
// [EVERY]], 10^7 steps of 2^-8 s of the lever, the stack and the box in Q16.16. The hash of the
// state is compared every 10^5 steps. What differs, or reports an error, is told with the steps
// between which that began: the runs begin where the scene does, so that the same call shows it
// again.
#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <iterator>
#include <thread>

#include "bench/chip/simulator/device_function.hpp"
#include "bench/experiments/scenes/chip_run.hpp"
#include "bench/experiments/scenes/host/describe.hpp"
#include "bench/lab/parallel.hpp"

namespace scene_bench {
namespace {

constexpr int exponent = 8;

// What differs first, or nothing.
template <class SceneType>
std::string soaked(unsigned long steps, unsigned long every) {
    WorldOf<SceneType, scalars::q16_16, scenes::SemiImplicit> world;
    scenes::build<SceneType>(world);
    simulator::Chip chip{simulator::Elf(program_path(SCENE_PROGRAMS, SceneType::name, "q16_16",
                                                     scenes::SemiImplicit::name, "hash"))};
    chip.run_until_function("main");
    simulator::DeviceFunction build(chip, "build", {.result = 0, .operands = {}}),
        step(chip, "step_8", {.result = 0, .operands = {}}),
        error(chip, "world_error", {.result = 1, .operands = {}}),
        hash(chip, "state_hash", {.result = 4, .operands = {}});
    for (simulator::DeviceFunction* function : {&build, &step, &hash})
        function->set_budget(50'000'000);
    build();
    for (unsigned long done = 0; done < steps;) {
        const unsigned long from = done;
        for (; done < std::min(from + every, steps); ++done) {
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
    }
    fmt::print("{}: {} steps, the last hash {:08x}\n", SceneType::name, steps,
               engine::state_hash(world));
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
    unsigned long steps = 10'000'000, every = 100'000;
    if (argc > 3 || (argc > 1 && !number(argv[1], steps)) ||
        (argc > 2 && !number(argv[2], every))) {
        fmt::print(stderr, "usage: soak [STEPS [EVERY]], whole numbers above 0\n");
        return 2;
    }
    std::string (*const scenes[])(unsigned long, unsigned long) = {
        soaked<scenes::Stack>, soaked<scenes::BoxOfParticles>, soaked<scenes::Lever>};
    std::string found[std::size(scenes)];
    try {
        operations::in_parallel(std::thread::hardware_concurrency(), std::size(scenes),
                                [&](std::size_t i) { found[i] = scenes[i](steps, every); });
    } catch (const std::exception& error) {
        fmt::print(stderr, "soak: {}\n", error.what());
        return 1;
    }
    int status = 0;
    for (const std::string& what : found)
        if (!what.empty()) {
            fmt::print(stderr, "soak: {}\n", what);
            status = 1;
        }
    return status;
}
