// SPDX-License-Identifier: GPL-3.0-or-later
// Long runs of scenes on the chip and on the host, side by side: soak [STEPS [SEED]], by default
// 10^7 steps of 2^-8 s of the lever, the stack and the box in Q16.16. The machine code of the chip
// runs translated to that of the host, ten times as fast as in the simulator. The simulator also
// takes the first 1,000 steps and then one in 50, and must end with the same variables after the
// same number of cycles. Every 50 steps it computes the hash of the state, which must be that of
// the host. Every 100 steps all particles get new velocities along y, the same on both sides;
// otherwise the stack would be at rest after 127 steps and the lever would repeat its swings to the
// bit after 65,535. A difference or an error is reported with the steps between which it began and
// the command that reproduces it.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdlib>
#include <iterator>
#include <random>
#include <thread>

#include "bench/chip/instructions/compiled_function.hpp"
#include "bench/chip/simulator/device_function.hpp"
#include "bench/experiments/scenes/chip_run.hpp"
#include "bench/experiments/scenes/host/describe.hpp"
#include "bench/lab/parallel.hpp"
#include "bench/lab/records/progress.hpp"

namespace scene_bench {
namespace {

constexpr int exponent = 8;
// The stack is at rest 100 steps after a push, but between two pushes it moves.
constexpr unsigned long between_hashes = 50, between_pushes = 100, compared_at_first = 1000;

// The step of a program, translated and in the simulator. Both work on variables of their own.
class ChipStep {
  public:
    ChipStep(simulator::Chip& chip, const instructions::Compilation& compilation)
        : chip_(chip),
          simulated_(chip, symbol, {.result = 0, .operands = {}}),
          translated_(chip.elf(), symbol, instructions::interface_of_variables(chip.elf()),
                      compilation),
          session_(translated_),
          variables_(
              session_.memory().subspan(simulator::Chip::ram_begin, chip.elf().ram_bytes())) {
        simulated_.set_budget(50'000'000);
        read();
    }

    // Copies the variables of the simulator to the translation.
    void read() { chip_.read(simulator::Chip::ram_begin, variables_); }
    // Copies the variables of the translation to the simulator.
    void write() { chip_.write(simulator::Chip::ram_begin, variables_); }

    void take() {
        std::uint32_t cycles;
        session_.run({}, {}, {&cycles, 1});
    }
    // A step of both, from the variables of the translation. Throws std::runtime_error if they
    // differ afterwards.
    void compare() {
        write();
        const std::uint32_t expected = simulated_().cycles;
        std::uint32_t cycles;
        session_.run({}, {}, {&cycles, 1});
        if (cycles != expected)
            throw std::runtime_error(
                fmt::format("the translation takes {} cycles, the simulator {}", cycles, expected));
        if (!std::equal(variables_.begin(), variables_.end(),
                        chip_.data() + simulator::Chip::ram_begin))
            throw std::runtime_error("translation and simulator leave different variables");
    }

  private:
    static constexpr const char* symbol = "step_8";
    simulator::Chip& chip_;
    simulator::DeviceFunction simulated_;
    instructions::CompiledFunction translated_;
    instructions::CompiledFunction::Session session_;
    std::span<std::uint8_t> variables_;
};

// The first difference, or nothing.
template <class SceneType>
std::string soaked(unsigned long steps, std::uint32_t seed, records::Progress& progress) {
    using World = WorldOf<SceneType, scalars::q16_16, scenes::SemiImplicit>;
    using Raw = std::int32_t;
    World world;
    scenes::build<SceneType>(world);
    simulator::Chip chip{simulator::Elf(program_path(scene_programs(), SceneType::name, "q16_16",
                                                     scenes::SemiImplicit::name, "hash"))};
    chip.run_until_function("main");
    simulator::DeviceFunction build(chip, "build", {.result = 0, .operands = {}}),
        position_of(chip, "position_of", {.result = 2, .operands = {1}}),
        error(chip, "world_error", {.result = 1, .operands = {}}),
        hash(chip, "state_hash", {.result = 4, .operands = {}});
    for (simulator::DeviceFunction* function : {&build, &hash}) function->set_budget(50'000'000);
    build();
    // Compiling takes as long as about 100,000 steps.
    ChipStep step(chip, steps > 100'000 ? instructions::Compilation{}
                                        : instructions::Compilation{.options = "-O0"});
    std::mt19937 random(seed);
    for (unsigned long done = 0; done < steps;) {
        const unsigned long from = done, until = std::min(from + between_hashes, steps);
        const auto parted = [&](std::string_view how) {
            return fmt::format("{}: between steps {} and {}: {}; again: scene_soak {} {}",
                               SceneType::name, from, until, how, until, seed);
        };
        try {
            for (; done < until; ++done) {
                world.step(PowerOfTwoStep{exponent});
                if (done < compared_at_first || done + 1 == until)
                    step.compare();
                else
                    step.take();
            }
        } catch (const std::runtime_error& error) {
            return parted(error.what());
        }
        const auto on_host = engine::state_hash(world), on_chip = hash().as<std::uint32_t>();
        if (on_host != on_chip)
            return parted(
                fmt::format("the host's hash is {:08x}, the chip's {:08x}", on_host, on_chip));
        const auto code = static_cast<engine::Error>(error().as<std::uint8_t>());
        if (code != engine::Error::none || world.error() != code)
            return parted(fmt::format("{} on the chip, {} on the host", engine::describe(code),
                                      engine::describe(world.error())));
        progress.advance(done - from);
        if (done % between_pushes != 0) continue;
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
        step.read();
    }
    return "";
}

template <class Number>
bool number(const char* text, Number& value) {
    const char* const end = text + std::string_view(text).size();
    const auto [rest, status] = std::from_chars(text, end, value);
    return status == std::errc() && rest == end && value > 0;
}

}  // namespace
}  // namespace scene_bench

int main(int argc, char** argv) {
    using namespace scene_bench;
    unsigned long steps = 10'000'000;
    std::uint32_t seed = 1;
    if (argc > 3 || (argc > 1 && !number(argv[1], steps)) || (argc > 2 && !number(argv[2], seed))) {
        fmt::print(stderr, "usage: soak [STEPS [SEED]], whole numbers above 0\n");
        return 2;
    }
    std::string (*const scenes[])(unsigned long, std::uint32_t, records::Progress&) = {
        soaked<scenes::Stack>, soaked<scenes::BoxOfParticles>, soaked<scenes::Lever>};
    constexpr std::size_t count = std::size(scenes);
    std::atomic<int> status{0};
    try {
        records::Progress progress("soak", count * steps);
        operations::in_parallel(std::thread::hardware_concurrency(), count, [&](std::size_t i) {
            const std::string found = scenes[i](steps, seed, progress);
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
                   count, steps, count * ((steps - 1) / between_hashes + 1));
    return status;
}
