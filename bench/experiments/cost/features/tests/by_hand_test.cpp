// SPDX-License-Identifier: GPL-3.0-or-later
// The lever written by hand moves like the engine's, to the last bit, so that their costs can be
// compared.
#include <engine.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <scenes/lever.hpp>

#include "bench/chip/simulator/device_function.hpp"
#include "this_build.hpp"

namespace {

using namespace engine::literals;

TEST(ByHand, MovesAsTheEngine) {
    using Scene = scenes::Lever::Uses<scenes::SemiImplicit>;
    using World = engine::World<engine::Fixed<16, 16>, Scene>;
    World world;
    scenes::Lever::build(world, scenes::Lever::Parameters<World::Scalar>());
    ASSERT_EQ(world.error(), engine::Error::none);

    simulator::Chip chip(
        simulator::Elf(build_folder() / "bench/experiments/cost/features/features_by_hand.elf"));
    chip.run_until_function("main");
    simulator::DeviceFunction build(chip, "build", {.result = 1, .operands = {}});
    simulator::DeviceFunction step(chip, "step", {.result = 0, .operands = {}});
    build();
    const auto lever = chip.elf().object("lever").address;
    for (int i = 0; i < 4096; ++i) {
        step();
        world.step(engine::BinaryStep<10>());
        std::array<std::int32_t, 4> state;  // position, velocity
        chip.read(static_cast<std::uint16_t>(lever),
                  {reinterpret_cast<std::uint8_t*>(state.data()), sizeof state});
        const auto& end = world.particles()[0];
        ASSERT_EQ(state,
                  (std::array<std::int32_t, 4>{end.position[0].raw(), end.position[1].raw(),
                                               end.velocity[0].raw(), end.velocity[1].raw()}))
            << "after step " << i;
    }
}

}  // namespace
