// SPDX-License-Identifier: MIT
// A change between two steps takes effect at the start of the next step.
#include <engine.h>
#include <gtest/gtest.h>

#include <type_traits>
#include <utility>

using namespace engine::literals;
using engine::BinaryStep;

namespace {

struct Pull {
    engine::Vector<double, 2> force;
    template <class World>
    void apply(World& world) const {
        world.particles()[0].force += force;
    }
};
struct Sprung : engine::Uses {
    static constexpr unsigned particles = 2, anchored_springs = 2;
    static constexpr bool custom_force = true;
    template <class World>
    using CustomForce = Pull;
    using Integrator = engine::VelocityVerlet;
};

struct ChangeByHand : testing::Test {
    engine::World<double, Sprung> world;
    decltype(world)::Handle body;
    ChangeByHand() {
        decltype(world)::Body description;
        description.position = {2_d, 0_d};
        description.inverse_mass = 1;
        body = world.add_particle(description);
        world.add_anchored_spring(body, {0_d, 0_d}, 4_d, 0_d, 1_d);
        world.step(BinaryStep<4>());
    }
    // One step of h = 1/4 from x = 3, v = 0, under 4 N/m and `length`, and a force.
    void expect_step_from_rest(double length, double force) {
        const double h = 0.25, a = force - 4 * (3 - length);
        const double x = 3 + h * h / 2 * a;
        const double v = h / 2 * a + h / 2 * (force - 4 * (x - length));
        world.step(BinaryStep<2>());
        EXPECT_DOUBLE_EQ(world[body].position[0], x);
        EXPECT_DOUBLE_EQ(world[body].velocity[0], v);
    }
    void rest_at_3() {
        world[body].position = {3_d, 0_d};
        world[body].velocity = {0_d, 0_d};
    }
    // Through a reference from before a step, which the world cannot notice.
    void rest_at_3_unseen() {
        auto& particle = world[body];
        world.step(BinaryStep<4>());
        particle.position = {3_d, 0_d};
        particle.velocity = {0_d, 0_d};
    }
};

TEST_F(ChangeByHand, PositionsUpdateTheForces) {
    rest_at_3();
    expect_step_from_rest(1, 0);
}
TEST_F(ChangeByHand, PositionsInTheListUpdateTheForces) {
    world.particles()[0].position = {3_d, 0_d};
    world.particles()[0].velocity = {0_d, 0_d};
    expect_step_from_rest(1, 0);
}
TEST_F(ChangeByHand, LengthsUpdateTheForces) {
    rest_at_3_unseen();
    world.set_length(world.anchored_springs()[0], 2_d);
    expect_step_from_rest(2, 0);
}
TEST_F(ChangeByHand, ForcesOfTheSceneAct) {
    rest_at_3_unseen();
    world.custom_force().force = {5_d, 0_d};
    expect_step_from_rest(1, 5);
}
TEST_F(ChangeByHand, WhatIsAddedActs) {
    rest_at_3_unseen();
    world.add_anchored_spring(body, {0_d, 0_d}, 0_d, 0_d, 1_d);
    expect_step_from_rest(1, 0);
}
TEST_F(ChangeByHand, AddedParticlesAct) {
    rest_at_3_unseen();
    world.add_particle({});
    expect_step_from_rest(1, 0);
}

// Reading keeps the forces of the previous step, with which a step costs one evaluation.
TEST_F(ChangeByHand, LookingChangesNothing) {
    auto other = world;
    for (int i = 0; i < 8; ++i) {
        const auto& seen = world;
        (void)seen.particles().size();
        (void)seen[body];
        (void)seen.custom_force();
        EXPECT_TRUE(world.integrator_memory().forces_are_current);
        world.step(BinaryStep<4>());
        other.step(BinaryStep<4>());
    }
    EXPECT_EQ(std::as_const(world)[body].position, std::as_const(other)[body].position);
}

template <class T, class = void>
struct CanClear : std::false_type {};
template <class T>
struct CanClear<T, decltype(std::declval<T>().clear())> : std::true_type {};
template <class T, class = void>
struct CanAppend : std::false_type {};
template <class T>
struct CanAppend<T, decltype(void(std::declval<T>().append()))> : std::true_type {};

// Nothing is removed, so no broad phase keeps a removed particle.
TEST(Elements, AreNeitherAddedNorRemovedByHand) {
    using World = engine::World<double, Sprung>;
    using Particles = decltype(std::declval<World&>().particles());
    EXPECT_FALSE(CanClear<Particles>::value);
    EXPECT_FALSE(CanAppend<Particles>::value);
    using Springs = decltype(std::declval<World&>().anchored_springs());
    EXPECT_TRUE(std::is_const<std::remove_reference_t<Springs>>::value);
}

}  // namespace
