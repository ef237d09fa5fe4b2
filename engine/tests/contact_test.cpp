// SPDX-License-Identifier: MIT
// Contacts, rods and ropes in motion, and the two broad phases.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <utility>

#include "reference/trajectories/invariants.hpp"
#include "runs.hpp"

using namespace engine::literals;
using namespace scenes;
using engine::Fixed;

namespace {

struct Collision : engine::Uses {
    static constexpr unsigned particles = 2, contacts = 1;
    static constexpr bool radii = true, collisions = true;
};
using Number = Fixed<16, 16>;
constexpr double ulp = 1.0 / 65536;

Number any_between(int low, int high) {
    return Number::from_raw(*rc::gen::inRange<int32_t>(low * 65536, high * 65536));
}

double kinetic_energy(const reference::State& state) {
    double sum = 0;
    for (const auto& p : state) {
        const auto& v = p.velocity;
        sum += (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / 2;
    }
    return sum;
}

double apart(const reference::ParticleState& a, const reference::ParticleState& b) {
    const auto &x = a.position, &y = b.position;
    return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}

// The largest | |a - b| / length - 1 | of a rope (1: only where too long) or of rods in a row.
template <class Scene, class Number, class Method>
double largest_misfit(double length, bool only_excess) {
    double largest = 0;
    runs::run<Scene, Method, Number, 8>([&](const auto& world) {
        reference::ParticleState last;
        for (const auto& particle : runs::state_of(world)) {
            const double excess = apart(particle, last) / length - 1;
            largest = std::max(largest, only_excess ? excess : std::abs(excess));
            last = particle;
        }
    });
    return largest;
}

struct Crowd : engine::Uses {
    static constexpr unsigned char dimensions = 3;
    static constexpr unsigned particles = 40, contacts = 40 * 39 / 2;
    static constexpr bool radii = true, collisions = true;
    using Solver = engine::WorstFirst<1>;  // moves nothing in the broad phase
};
struct CrowdByForce : Crowd {
    using BroadPhase = engine::BruteForce;
};
struct CrowdBySweep : Crowd {
    using BroadPhase = engine::SortAndSweep;
};
struct CrowdByCachedSweep : Crowd {
    using BroadPhase = engine::CachedSortAndSweep;
};

template <class World>
std::set<std::pair<int, int>> pairs(World& world) {
    world.collect_constraints(engine::BinaryStep<8>());
    std::set<std::pair<int, int>> found;
    for (const auto& row : world.rows())
        RC_ASSERT(found.insert(std::minmax<int>(row.a, row.b)).second);
    return found;
}

}  // namespace

// With different masses, the change of the second velocity is the rest of the first's, so that the
// momentum is lost by the rounding of the share (times the change), of the first's part, and of
// each component.
RC_GTEST_PROP(Contact, MomentumIsConservedToTheRounding, ()) {
    engine::World<Number, Collision> world;
    world.set_restitution(any_between(0, 1));
    typename decltype(world)::Body disc;
    disc.radius = 1_d;
    double mass[2];
    bool collided = false;
    for (int i = 0; i < 2; ++i) {
        disc.inverse_mass = Number::from_raw(*rc::gen::inRange<int32_t>(1 << 14, 1 << 18));
        mass[i] = 1 / runs::to_double(disc.inverse_mass);
        disc.position = {any_between(-1, 1), any_between(-1, 1)};
        disc.velocity = {any_between(-10, 10), any_between(-10, 10)};
        world.add_particle(disc);
    }
    const auto start = runs::state_of(world);
    world.step(engine::BinaryStep<10>());
    const auto end = runs::state_of(world);
    for (int axis = 0; axis < 2; ++axis) {
        double change = 0;
        for (int i = 0; i < 2; ++i) {
            const double by = end[i].velocity[axis] - start[i].velocity[axis];
            change += mass[i] * by;
            collided = collided || by != 0;
        }
        constexpr double largest_change = 60;  // of a closing velocity of at most 20 sqrt 2 m/s
        const double bound = (mass[0] + mass[1]) * ulp * (0.5 * largest_change + 1);
        RC_ASSERT(std::abs(change) <= bound);
    }
    RC_CLASSIFY(collided, "collide");
}

TEST(Contact, EqualDiscsSwapVelocitiesHeadOn) {
    engine::World<Number, Collision> world;
    world.set_restitution(1_d);
    typename decltype(world)::Body disc;
    disc.radius = 0.5_d;
    disc.inverse_mass = 1_d;
    disc.velocity = {3_d, 0_d};
    const auto a = world.add_particle(disc);
    disc.position = {1.5_d, 0_d};
    disc.velocity = {-1_d, 0_d};
    const auto b = world.add_particle(disc);
    for (int i = 0; i < 64; ++i) world.step(engine::BinaryStep<6>());
    EXPECT_EQ(runs::to_double(world[a].velocity[0]), -1);
    EXPECT_EQ(runs::to_double(world[b].velocity[0]), 3);
    // The truth after 1 s: they met at 0.125 s.
    EXPECT_NEAR(runs::to_double(world[a].position[0]), 0.375 - 0.875, 2 / 64.0);
    EXPECT_NEAR(runs::to_double(world[b].position[0]), 1.375 + 2.625, 2 / 64.0);
}

// At 0.75 s the first ball's momentum has passed through three others to the last.
TEST(Contact, CradleHandsMomentumToTheLastBall) {
    const auto check = [](auto scalar) {
        const auto state = runs::run<NewtonsCradle, SemiImplicit, decltype(scalar), 9>()[2];
        const auto truth = (*reference::trajectory("newtons_cradle", {0.75}))[0];
        for (std::size_t i = 0; i < 5; ++i) {
            EXPECT_NEAR(state[i].velocity[0], truth[i].velocity[0], 0.05) << i;
        }
        EXPECT_GT(truth[4].velocity[0], 1);
    };
    check(double());
    check(Number());
    check(Fixed<8, 24>());
}

TEST(Contact, BouncesReachTheirHeights) {
    const auto check = [](auto scalar, double tolerance) {
        const BouncingBall::Parameters<double> with;
        std::vector<double> tops;
        double last = HUGE_VAL, before = HUGE_VAL;  // before it falls
        runs::run<BouncingBall, Verlet, decltype(scalar), 10>([&](const auto& world) {
            const double height = runs::to_double(world.particles()[0].position[1]) - with.radius;
            if (last > before && height <= last) tops.push_back(last);
            before = last;
            last = height;
        });
        ASSERT_GE(tops.size(), 4u);
        double height = with.height - with.radius;
        for (int i = 0; i < 4; ++i) {
            height *= with.restitution * with.restitution;
            EXPECT_NEAR(tops[i], height, tolerance) << i;
        }
    };
    check(double(), 1e-4);
    check(Number(), 2e-3);
    check(Fixed<8, 24>(), 1e-4);
}

TEST(Contact, RopeIsNeverLongerThanAStepMakesIt) {
    // At the event the fall of 5.6 m/s continues to the end of the step: 0.022 m of 2 m.
    EXPECT_LT((largest_misfit<RopeSwing, double, SemiImplicit>(2, true)), 0.011);
    EXPECT_LT((largest_misfit<RopeSwing, Number, SemiImplicit>(2, true)), 0.011);
    EXPECT_LT((largest_misfit<RopeSwing, Number, Verlet>(2, true)), 0.011);
}

// A rope that were slack in every other step would let its end fall in these, and swing too slowly.
template <class Number, class Method, int K>
void expect_a_taut_rope_to_act_in_every_step(double tolerance) {
    unsigned first = 0, step = 0, idle = 0;
    const auto made = runs::run<RopeSwing, Method, Number, K>([&](const auto& world) {
        ++step;
        const bool acts = world.rows().size() == 1;
        if (acts && first == 0) first = step;
        if (!acts && first != 0) ++idle;
    });
    EXPECT_LE(idle, (step - first) / 40) << "of " << step - first;
    const auto truth = reference::trajectory("rope_swing", runs::observed_times<RopeSwing>());
    double largest = 0;
    for (std::size_t i = 0; i < made.size(); ++i)
        largest = std::max(largest, apart(made[i][0], truth->at(i)[0]));
    EXPECT_LT(largest, tolerance);
}
TEST(Contact, ATautRopeActsInEveryStep) {
    expect_a_taut_rope_to_act_in_every_step<double, Verlet, 6>(0.04);
    expect_a_taut_rope_to_act_in_every_step<double, Verlet, 8>(0.015);
    expect_a_taut_rope_to_act_in_every_step<double, Verlet, 10>(0.001);
    expect_a_taut_rope_to_act_in_every_step<double, SemiImplicit, 8>(0.012);
    expect_a_taut_rope_to_act_in_every_step<float, Verlet, 10>(0.001);
    expect_a_taut_rope_to_act_in_every_step<Number, Verlet, 6>(0.04);
    expect_a_taut_rope_to_act_in_every_step<Number, Verlet, 8>(0.015);
    expect_a_taut_rope_to_act_in_every_step<Number, Verlet, 10>(0.002);
    expect_a_taut_rope_to_act_in_every_step<Fixed<8, 24>, Verlet, 8>(0.015);
    expect_a_taut_rope_to_act_in_every_step<Fixed<32, 32>, Verlet, 10>(0.001);
}

TEST(Contact, RodsKeepTheirLength) {
    EXPECT_LT((largest_misfit<Pendulum, double, SemiImplicit>(1, false)), 1e-4);
    EXPECT_LT((largest_misfit<Pendulum, Number, SemiImplicit>(1, false)), 1e-4);
    EXPECT_LT((largest_misfit<DoublePendulum, double, SemiImplicit>(1, false)), 1e-3);
    EXPECT_LT((largest_misfit<DoublePendulum, Number, Verlet>(1, false)), 1e-3);
    EXPECT_LT((largest_misfit<ChainOfRods, double, SemiImplicit>(0.5, false)), 2e-3);
    EXPECT_LT((largest_misfit<ChainOfRods, Number, Verlet>(0.5, false)), 2e-3);
}

TEST(Contact, BoxKeepsItsEnergyAndItsBalls) {
    const auto check = [](auto scalar, auto method, double drift) {
        using Scalar = decltype(scalar);
        runs::WorldOf<BoxOfParticles, SemiImplicit, Scalar> fresh;
        scenes::build<BoxOfParticles>(fresh);
        const auto start = runs::state_of(fresh);
        unsigned hits = 0;
        runs::run<BoxOfParticles, decltype(method), Scalar, 8>([&](const auto& world) {
            const auto state = runs::state_of(world);
            ASSERT_NEAR(kinetic_energy(state), kinetic_energy(start), drift);
            // The motion of one step is 1.5 m/s * 2^-8 s.
            for (std::size_t a = 0; a < state.size(); ++a) {
                for (double x : state[a].position) ASSERT_LT(std::abs(x), 1 - 0.125 + 0.01);
                for (std::size_t b = 0; b < a; ++b)
                    ASSERT_GT(apart(state[a], state[b]), 0.25 - 0.02);
            }
            hits += world.rows().size();
        });
        EXPECT_GT(hits, 20u);
    };
    check(double(), SemiImplicit(), 1e-12);
    check(double(), Verlet(), 1e-12);
    check(double(), Published(), 1e-12);
    check(Number(), SemiImplicit(), 1e-4);
    check(Fixed<8, 24>(), SemiImplicit(), 1e-6);
}

TEST(Contact, StackComesToRest) {
    const auto check = [](auto scalar, double tolerance) {
        const auto end = runs::run<Stack, SemiImplicit, decltype(scalar), 8>().back();
        for (std::size_t i = 0; i < end.size(); ++i) {
            EXPECT_NEAR(end[i].position[1], 0.25 + 0.5 * i, tolerance) << i;
            EXPECT_NEAR(end[i].velocity[1], 0, 0.05) << i;
        }
    };
    check(double(), 2e-3);
    check(Number(), 2e-3);
    check(Fixed<8, 8>(), 3e-2);
}

RC_GTEST_PROP(BroadPhase, SweepsFindWhatBruteForceFinds, ()) {
    engine::World<Number, CrowdByForce> by_force;
    engine::World<Number, CrowdBySweep> by_sweep;
    engine::World<Number, CrowdByCachedSweep> by_cached_sweep;
    const int count = *rc::gen::inRange(0, 41);
    for (int i = 0; i < count; ++i) {
        typename decltype(by_force)::Body ball;
        ball.inverse_mass = *rc::gen::inRange(0, 4) == 0 ? Number() : Number(1_d);
        ball.radius = any_between(0, 2);
        by_force.add_particle(ball);
        by_sweep.add_particle(ball);
        by_cached_sweep.add_particle(ball);
    }
    // The order of one search is the start of the next.
    for (int look = 0; look < 3; ++look) {
        for (int i = 0; i < count; ++i) {
            // Sometimes on whole metres, for edges that just touch.
            const bool whole = *rc::gen::inRange(0, 3) == 0;
            for (unsigned char axis = 0; axis < 3; ++axis) {
                Number x = any_between(-5, 5);
                if (whole) x = fixedpoint::floor(x);
                by_force.particles()[i].position[axis] = x;
                by_sweep.particles()[i].position[axis] = x;
                by_cached_sweep.particles()[i].position[axis] = x;
            }
        }
        const auto expected = pairs(by_force);
        RC_ASSERT(pairs(by_sweep) == expected);
        RC_ASSERT(pairs(by_cached_sweep) == expected);
        RC_CLASSIFY(!expected.empty(), "touch");
    }
}
