// SPDX-License-Identifier: MIT
// Pools whose capacities exceed the limits of an 8-bit index: each holds what it states, and every
// element acts.
#include <engine.h>
#include <gtest/gtest.h>

using namespace engine::literals;
using engine::BinaryStep;
using engine::Error;

namespace {

struct Points : engine::Uses {
    static constexpr unsigned particles = 1, anchored_rods = 1;
    using Solver = engine::ProjectedGaussSeidel<1>;
};
struct PointsInSpace : Points {
    static constexpr unsigned char dimensions = 3;
};
struct Pulled : Points {
    static constexpr unsigned anchored_springs = 1;
};
struct Spheres : Points {
    static constexpr bool radii = true;
};
struct Damped : Points {
    static constexpr bool damping = true;
};
struct Compensated : Points {
    static constexpr bool compensated_integration = true;
};
struct Sorted : Points {
    using Solver = engine::WorstFirst<1>;
};
template <class Uses>
constexpr std::size_t numbers_of_a_particle =
    sizeof(typename engine::World<double, Uses>::Particle) / sizeof(double);

struct Nothing : engine::Uses {
    static constexpr bool gravity = true;
};
TEST(Step, OfNoParticleDoesNothing) {
    engine::World<fixedpoint::Q16_16, Nothing> world;
    world.step(BinaryStep<10>());
    EXPECT_EQ(world.particles().size(), 0u);
}

// Position, velocity and inverse mass, and what the scene states in addition.
TEST(Particle, HoldsOnlyWhatItsSceneStates) {
    EXPECT_EQ(numbers_of_a_particle<Points>, 5u);
    EXPECT_EQ(numbers_of_a_particle<PointsInSpace>, 7u);
    EXPECT_EQ(numbers_of_a_particle<Pulled>, 7u);       // the force
    EXPECT_EQ(numbers_of_a_particle<Spheres>, 6u);      // the radius
    EXPECT_EQ(numbers_of_a_particle<Damped>, 6u);       // the factor
    EXPECT_EQ(numbers_of_a_particle<Compensated>, 9u);  // two residuals
    EXPECT_EQ(numbers_of_a_particle<Sorted>, 7u);       // the way back
}

// N particles that fall from rest, side by side.
template <class World>
void add_particles(World& world, unsigned count) {
    typename World::Body body;
    body.inverse_mass = 1_d;
    for (unsigned i = 0; i < count; ++i) {
        body.position[0] += 4;
        ASSERT_TRUE(world.add_particle(body));
    }
}
template <class World>
typename World::Handle handle(unsigned i) {
    return {static_cast<typename World::Index>(i)};
}

template <unsigned N, class SolverType>
struct Hanging : engine::Uses {
    static constexpr unsigned particles = N, anchored_rods = N, anchored_ropes = N;
    static constexpr bool gravity = true;
    using Solver = SolverType;
};

// Rods from 1 m above, and ropes of the same length: none of the particles falls.
template <unsigned N, class Solver>
void expect_all_hang() {
    using World = engine::World<double, Hanging<N, Solver>>;
    World world;
    world.gravity = {0_d, -9.81_d};
    add_particles(world, N);
    for (unsigned i = 0; i < N; ++i) {
        typename World::Vector anchor = world.particles()[i].position;
        anchor[1] = 1_d;
        ASSERT_TRUE(world.add_anchored_rod(handle<World>(i), anchor, 1_d));
        ASSERT_TRUE(world.add_anchored_rope(handle<World>(i), anchor, 1_d, 0_d));
    }
    for (int i = 0; i < 16; ++i) world.step(BinaryStep<8>());
    EXPECT_EQ(world.error(), Error::none);
    for (const auto& particle : world.particles()) {
        EXPECT_NEAR(particle.position[1], 0, 1e-2) << N << " particles";
    }
}

TEST(Pools, RowsOfRodsAndRopesAreCountedApartFromParticles) {
    expect_all_hang<127, engine::ProjectedGaussSeidel<4>>();
    expect_all_hang<128, engine::ProjectedGaussSeidel<4>>();  // 256 rows, 128 particles
    expect_all_hang<129, engine::ProjectedGaussSeidel<4>>();
}

// Two rows per rod and one per rope: 255, 258 and 261.
TEST(Pools, RowsOfOpposedContactsAreCountedApartFromParticles) {
    expect_all_hang<85, engine::WorstFirst<255>>();
    expect_all_hang<86, engine::WorstFirst<255>>();
    expect_all_hang<87, engine::WorstFirst<255>>();
}

template <unsigned N>
struct OneOnManySprings : engine::Uses {
    static constexpr unsigned particles = 1, anchored_springs = N;
};

// Each of 1 N/m and stretched by 1 m.
TEST(Pools, EverySpringPulls) {
    const auto check = [](auto uses, unsigned count) {
        engine::World<double, decltype(uses)> world;
        add_particles(world, 1);
        const auto body = handle<decltype(world)>(0);
        typename decltype(world)::Vector anchor(5_d, 0_d);
        for (unsigned i = 0; i < count; ++i) {
            ASSERT_TRUE(world.add_anchored_spring(body, anchor, 1_d, 0_d, 0_d));
        }
        EXPECT_FALSE(world.add_anchored_spring(body, anchor, 1_d, 0_d, 0_d));
        EXPECT_EQ(world.error(), Error::pool_full);
        EXPECT_EQ(unsigned(world.anchored_springs().size()), count);
        world.step(1.0);
        EXPECT_EQ(world[body].velocity[0], count);
    };
    check(OneOnManySprings<255>(), 255);
    check(OneOnManySprings<256>(), 256);
    check(OneOnManySprings<300>(), 300);
}

template <unsigned N>
struct Many : engine::Uses {
    static constexpr unsigned particles = N, planes = 1, contacts = N;
    static constexpr bool gravity = true;
};

// As many contacts as particles on a floor, and no more.
template <unsigned N>
void expect_all_lie() {
    engine::World<double, Many<N>> world;
    world.gravity = {0_d, -9.81_d};
    add_particles(world, N);
    EXPECT_FALSE(world.add_particle({}));
    EXPECT_EQ(world.error(), Error::pool_full);
    world.clear_error();
    world.add_plane({0_d, 1_d}, 0_d, 0_d);
    for (int i = 0; i < 4; ++i) world.step(BinaryStep<8>());
    EXPECT_EQ(world.error(), Error::none) << N;
    EXPECT_EQ(unsigned(world.rows().size()), N);
    for (const auto& particle : world.particles()) EXPECT_NEAR(particle.position[1], 0, 1e-3);
}

TEST(Pools, EveryParticleFindsItsContact) {
    expect_all_lie<254>();
    expect_all_lie<255>();
    expect_all_lie<256>();
    expect_all_lie<300>();
}

TEST(Pools, TheLargestPoolFills) {
    static engine::World<float, Many<65535>> world;
    add_particles(world, 65535);
    EXPECT_FALSE(world.add_particle({}));
    EXPECT_EQ(world.error(), Error::pool_full);
}

struct Few : engine::Uses {
    static constexpr unsigned particles = 300, contacts = 512;
    static constexpr bool radii = true, collisions = true;
};
struct FewSwept : Few {
    using BroadPhase = engine::SortAndSweep;
};
struct FewCached : Few {
    using BroadPhase = engine::CachedSortAndSweep;
};

// 300 particles 4 m apart: each touches the next two, 2.5 m in radius.
TEST(Pools, BroadPhasesReachEveryParticle) {
    const auto rows = [](auto uses) {
        engine::World<double, decltype(uses)> world;
        typename decltype(world)::Body body;
        body.inverse_mass = 1_d;
        body.radius = 2.5_d;
        for (unsigned i = 0; i < 300; ++i) {
            body.position[0] = 4.0 * ((i * 7) % 300);  // in no order
            world.add_particle(body);
        }
        world.collect_constraints(BinaryStep<8>());
        EXPECT_EQ(world.error(), Error::none);
        return unsigned(world.rows().size());
    };
    EXPECT_EQ(rows(Few()), 299u);
    EXPECT_EQ(rows(FewSwept()), 299u);
    EXPECT_EQ(rows(FewCached()), 299u);
}

}  // namespace
