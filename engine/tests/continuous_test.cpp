// SPDX-License-Identifier: MIT
// Continuous contacts: nothing passes a thin wall, whatever its speed. The speeds afterwards are
// the closed forms of a collision. A particle that is slow, or has nothing in its way, moves as it
// does without them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <engine/hash.hpp>
#include <random>

#include "runs.hpp"

using namespace engine;
using namespace engine::literals;

namespace {

constexpr double radius = 0.05;  // m

template <bool is_continuous, class ChosenIntegrator = SemiImplicitEuler>
struct Hall : Uses {
    static constexpr unsigned particles = 9, planes = 4, contacts = 40;
    static constexpr bool radii = true, collisions = true, gravity = true;
    static constexpr bool continuous_contacts = is_continuous;
    using Integrator = ChosenIntegrator;
    using Solver = ProjectedGaussSeidel<10>;
};
template <class Scalar, class Integrator = SemiImplicitEuler>
using Watched = World<Scalar, Hall<true, Integrator>>;
template <class Scalar>
using Unwatched = World<Scalar, Hall<false>>;

using runs::to_double;
template <class Scalar>
Scalar scalar(double x) {
    return runs::Rounded<Scalar>::of(x);
}

template <class World>
auto add(World& world, double x, double y, double vx, double vy, double inverse_mass = 1,
         double of_radius = radius) {
    using Scalar = typename World::Scalar;
    typename World::Body body;
    body.position = {scalar<Scalar>(x), scalar<Scalar>(y)};
    body.velocity = {scalar<Scalar>(vx), scalar<Scalar>(vy)};
    body.inverse_mass = scalar<Scalar>(inverse_mass);
    body.radius = scalar<Scalar>(of_radius);
    return world.add_particle(body);
}

// The largest speed that a position in the middle of the range can have with a step of 2^-K s, so
// that it is still in the range after one step.
template <class Scalar>
struct Format {
    static double largest_speed(int) { return 1e9; }
    static double largest_position() { return 1e4; }
};
template <int I, int F, class A>
struct Format<Fixed<I, F, A>> {
    static double largest_position() { return std::ldexp(1.0, I - 2); }
    static double largest_speed(int exponent) {
        const double end = std::ldexp(1.0, I - 1) - 1;
        return std::min(end, std::ldexp(end / 4, exponent));
    }
};

template <class Scalar>
class Continuous : public testing::Test {};
using Formats = testing::Types<Fixed<8, 8>, Fixed<8, 24>, Fixed<16, 16>, SaturatingFixed<16, 16>,
                               Fixed<32, 32>, float, double>;
TYPED_TEST_SUITE(Continuous, Formats);

// From far and near, straight and slanted, between two spheres of the wall and at one of them.
template <class Scalar, class Integrator, int K>
void throw_at_a_wall() {
    std::mt19937 random(17);
    std::uniform_real_distribution<double> part(0, 1);
    const double fastest = Format<Scalar>::largest_speed(K);
    for (double speed = 0.5; speed < fastest * 1.4; speed *= 1.37) {
        const double v = std::min(speed, fastest);
        for (int i = 0; i < 8; ++i) {
            Watched<Scalar, Integrator> world;
            world.set_restitution(0.5_d);
            const double aim = 0.1 * (part(random) - 0.5), slant = 0.4 * (part(random) - 0.5);
            // Its first step ends before the wall, at it or behind it.
            const double way = std::min((0.2 + 1.6 * part(random)) * v * std::ldexp(1.0, -K),
                                        Format<Scalar>::largest_position());
            const auto ball = add(world, -0.11 - way, aim - slant * way, v, slant * v);
            for (int k = 0; k < 8; ++k) add(world, 0, 0.1 * k - 0.35, 0, 0, 0);
            for (int step = 0; step < 20; ++step) {
                const auto before = world[ball].position;
                world.step(BinaryStep<K>());
                const auto& after = world[ball].position;
                if (to_double(after[0]) < 0) continue;
                // A bounce may have sent it around the wall, which is 0.8 m high.
                const double from = to_double(before[0]), to = to_double(after[0]);
                const double y =
                    to_double(before[1]) + to_double(after[1] - before[1]) * from / (from - to);
                ASSERT_GT(std::abs(y), 0.4) << v << " m/s, aimed at " << aim << ", slant " << slant
                                            << ", from " << way << " m, step " << step;
                break;
            }
            ASSERT_EQ(world.error(), Error::none);
        }
    }
}
TYPED_TEST(Continuous, NothingPassesAThinWall) {
    throw_at_a_wall<TypeParam, SemiImplicitEuler, 8>();
    throw_at_a_wall<TypeParam, VelocityVerlet, 8>();
    throw_at_a_wall<TypeParam, ExplicitEuler, 6>();
    throw_at_a_wall<TypeParam, SemiImplicitEuler, 4>();
}

// Without them it passes: the test above tests something.
TEST(Discrete, PassesAThinWall) {
    Unwatched<double> world;
    const auto ball = add(world, -0.3, 0, 100, 0);
    add(world, 0, 0, 0, 0, 0);
    for (int step = 0; step < 20; ++step) world.step(BinaryStep<8>());
    EXPECT_GT(world[ball].position[0], 0);
}

// Two on one line after the collision: the closed form, with momentum and energy.
TYPED_TEST(Continuous, SpeedsAfterACollisionAreThoseOfTheClosedForm) {
    const double fastest = Format<TypeParam>::largest_speed(8) / 2;
    for (double v = 1; v < fastest; v *= 1.9) {
        Watched<TypeParam> world;
        world.set_restitution(1_d);
        // Four steps away, and within the range.
        const double way = std::min(4 * v / 256, Format<TypeParam>::largest_position());
        const auto first = add(world, -0.11 - way, 0, v, 0, 1);
        const auto second = add(world, 0, 0, 0, 0, 0.5);
        for (int step = 0; step < 8; ++step) world.step(BinaryStep<8>());
        const double tolerance =
            std::is_same<TypeParam, Fixed<8, 8>>::value ? 0.02 * v + 0.02 : 1e-3 * v;
        EXPECT_NEAR(to_double(world[first].velocity[0]), -v / 3, tolerance) << v;
        EXPECT_NEAR(to_double(world[second].velocity[0]), 2 * v / 3, tolerance) << v;
    }
}

// A fast particle in a box of planes, and in one of thin walls, stays there.
TYPED_TEST(Continuous, AFastParticleStaysInItsBox) {
    const double v = Format<TypeParam>::largest_speed(8) / 2;
    for (const bool of_planes : {true, false}) {
        Watched<TypeParam> world;
        world.set_restitution(1_d);
        add(world, 0.01, 0.02, v, v * 0.77);
        if (of_planes) {
            world.add_plane({1_d, 0_d}, -0.5_d, 1_d);
            world.add_plane({-1_d, 0_d}, -0.5_d, 1_d);
            world.add_plane({0_d, 1_d}, -0.5_d, 1_d);
            world.add_plane({0_d, -1_d}, -0.5_d, 1_d);
        } else {
            for (int k = 0; k < 8; ++k)
                add(world, 0.3 * std::cos(k * M_PI / 4), 0.3 * std::sin(k * M_PI / 4), 0, 0, 0,
                    0.11);
        }
        for (int step = 0; step < 2000; ++step) {
            world.step(BinaryStep<8>());
            const auto& at = world.particles()[0].position;
            ASSERT_LT(std::hypot(to_double(at[0]), to_double(at[1])), of_planes ? 0.8 : 0.35)
                << step << (of_planes ? " planes" : " walls");
        }
        ASSERT_EQ(world.error(), Error::none);
    }
}

TYPED_TEST(Continuous, WithNothingInTheWayMovesAsWithoutContinuousContacts) {
    Watched<TypeParam> world;
    Unwatched<TypeParam> plain;
    const auto build = [](auto& w) {
        add(w, -20, 0, 100, 3);
        add(w, -20, 1, 90, 3);
        add(w, 5, 30, 0, 0, 0);
        w.gravity = {0_d, -9.81_d};
    };
    build(world), build(plain);
    for (int step = 0; step < 64; ++step) {
        world.step(BinaryStep<8>());
        plain.step(BinaryStep<8>());
        ASSERT_EQ(state_hash(world), state_hash(plain)) << step;
    }
}

// Particles that have not been added are at the origin.
TYPED_TEST(Continuous, ParticlesNotYetAddedAreNotInTheWay) {
    Watched<TypeParam> world;
    const auto ball = add(world, -1, 0, 100, 0);
    for (int step = 0; step < 16; ++step) world.step(BinaryStep<8>());
    EXPECT_NEAR(to_double(world[ball].position[0]), -1 + 16 * 100 / 256.0, 0.05);
}

// Below half a radius per step, contacts are found as without: bit for bit the same.
RC_GTEST_PROP(ContinuousContacts, OfSlowParticlesAreTheSame, ()) {
    using Scalar = Fixed<16, 16>;
    World<Scalar, Hall<true>> world;
    World<Scalar, Hall<false>> plain;
    const auto any = [](double most) {
        return *rc::gen::inRange<int>(-1000, 1001) / 1000.0 * most;
    };
    const unsigned seed = *rc::gen::arbitrary<unsigned>();
    const double restitution = *rc::gen::inRange<int>(0, 9) / 8.0;
    const double speed = any(4);
    const auto build = [&](auto& w) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> part(-1, 1);
        w.set_restitution(scalar<Scalar>(restitution));
        w.add_plane({0_d, 1_d}, -0.5_d, scalar<Scalar>(restitution));
        for (int i = 0; i < 9; ++i)
            add(w, 0.5 * part(random), 0.5 * part(random), speed * part(random),
                speed * part(random));
    };
    build(world), build(plain);
    for (int step = 0; step < 32; ++step) {
        // Corrections and shared velocities stay below the bound here: 6.4 m/s with this step.
        world.step(BinaryStep<8>());
        plain.step(BinaryStep<8>());
        for (const auto& p : plain.particles())
            for (int i = 0; i < 2; ++i) RC_PRE(std::abs(to_double(p.velocity[i])) < 6.3);
        RC_ASSERT(state_hash(world) == state_hash(plain));
    }
}

// In a crowd in a box, at any speed, no particle leaves the box, and no energy is gained.
RC_GTEST_PROP(ContinuousContacts, KeepACrowdInItsBox, ()) {
    World<double, Hall<true>> world;
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    std::uniform_real_distribution<double> part(-1, 1);
    const double speed = std::pow(10, *rc::gen::inRange<int>(0, 7));
    world.set_restitution(1_d);
    world.add_plane({1_d, 0_d}, -0.5_d, 1_d);
    world.add_plane({-1_d, 0_d}, -0.5_d, 1_d);
    world.add_plane({0_d, 1_d}, -0.5_d, 1_d);
    world.add_plane({0_d, -1_d}, -0.5_d, 1_d);
    double energy = 0;
    for (int i = 0; i < 9; ++i) {
        const double vx = speed * part(random), vy = speed * part(random);
        add(world, 0.3 * (i % 3) - 0.3, 0.3 * (i / 3) - 0.3, vx, vy);
        energy += vx * vx + vy * vy;
    }
    for (int step = 0; step < 100; ++step) {
        world.step(BinaryStep<8>());
        double now = 0;
        for (const auto& p : world.particles()) {
            RC_ASSERT(std::abs(p.position[0]) < 0.55 && std::abs(p.position[1]) < 0.55);
            now += dot(p.velocity, p.velocity);
        }
        RC_ASSERT(now <= energy * (1 + 1e-9));
    }
}

}  // namespace
