// SPDX-License-Identifier: GPL-3.0-or-later
// The engine and Box2D are timed on the same discs: both start alike, conserve their energy, and
// keep their discs apart and in the box.
#include "bench/experiments/cost/growth/discs.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <engine/hash.hpp>
#include <thread>
#include <vector>

#include "bench/experiments/cost/growth/box2d_discs.hpp"
#include "bench/experiments/cost/growth/counted.hpp"
#include "bench/experiments/cost/growth/stopwatch.hpp"

namespace growth {
namespace {

constexpr unsigned number = 64, steps = warm_steps + timed_steps;
constexpr float steps_way = 4 * 1.42f / (1 << exponent_of_step);  // m, of the fastest at the start

std::vector<Disc> discs_of(const DiscWorld<number, engine::SortAndSweep>& world) {
    std::vector<Disc> discs;
    for (const auto& particle : world.particles()) {
        Disc disc{};
        for (unsigned char axis = 0; axis < 2; ++axis) {
            disc.position[axis] = fixedpoint::to_float<float>(particle.position[axis]);
            disc.velocity[axis] = fixedpoint::to_float<float>(particle.velocity[axis]);
        }
        discs.push_back(disc);
    }
    return discs;
}

std::vector<Disc> discs_of(const b2World& world) {
    std::vector<Disc> discs;
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
        if (body->GetType() == b2_dynamicBody)
            discs.insert(discs.begin(),
                         Disc{{body->GetPosition().x, body->GetPosition().y},
                              {body->GetLinearVelocity().x, body->GetLinearVelocity().y}});
    return discs;
}

double energy_of(const std::vector<Disc>& discs) {
    double sum = 0;
    for (const Disc& disc : discs)
        sum += (disc.velocity[0] * disc.velocity[0] + disc.velocity[1] * disc.velocity[1]) / 2;
    return sum;
}

unsigned changed(const std::vector<Disc>& discs) {
    unsigned count = 0;
    for (unsigned i = 0; i < number; ++i)
        count += std::abs(discs[i].velocity[0] - disc(i, number).velocity[0]) > 0.01f ||
                 std::abs(discs[i].velocity[1] - disc(i, number).velocity[1]) > 0.01f;
    return count;
}

void expect_a_box_of_discs(const std::vector<Disc>& discs) {
    for (unsigned i = 0; i < number; ++i) {
        for (const float x : discs[i].position)
            EXPECT_LE(std::abs(x), half_edge(number) - disc_radius + 2 * steps_way) << i;
        for (unsigned j = 0; j < i; ++j)
            EXPECT_GE(std::hypot(discs[i].position[0] - discs[j].position[0],
                                 discs[i].position[1] - discs[j].position[1]),
                      2 * disc_radius - 4 * steps_way)
                << i << " and " << j;
    }
}

TEST(Discs, AreTheSameInBothEngines) {
    DiscWorld<number, engine::SortAndSweep> ours;
    build<number, engine::SortAndSweep>(ours);
    const auto theirs = box2d_discs(number);
    const auto mine = discs_of(ours), other = discs_of(*theirs);
    ASSERT_EQ(mine.size(), number);
    ASSERT_EQ(other.size(), number);
    for (unsigned i = 0; i < number; ++i)
        for (unsigned axis = 0; axis < 2; ++axis) {
            EXPECT_EQ(mine[i].position[axis], other[i].position[axis]);
            EXPECT_EQ(mine[i].velocity[axis], other[i].velocity[axis]);
        }
    const double energy = energy_of(mine);
    for (unsigned i = 0; i < steps; ++i) {
        ours.step(engine::BinaryStep<exponent_of_step>());
        step(*theirs);
    }
    for (const auto& discs : {discs_of(ours), discs_of(*theirs)}) {
        EXPECT_NEAR(energy_of(discs), energy, energy / 20);
        EXPECT_GT(changed(discs), number / 2);
        expect_a_box_of_discs(discs);
    }
}

template <unsigned N, class Search>
unsigned long pairs_of_a_moment() {
    DiscWorld<N, Counted<Search>> counted;
    DiscWorld<N, Search> plain;
    build<N, Counted<Search>>(counted);
    build<N, Search>(plain);
    unsigned long before = 0;
    for (unsigned i = 0; i < steps; ++i) {
        before = counted.pair_memory().pairs;
        counted.step(engine::BinaryStep<exponent_of_step>());
        plain.step(engine::BinaryStep<exponent_of_step>());
    }
    EXPECT_EQ(engine::state_hash(counted), engine::state_hash(plain));
    return counted.pair_memory().pairs - before;
}

TEST(Pairs, AreAllOfThemOrThoseThatOverlapAlongTheFirstAxis) {
    EXPECT_EQ((pairs_of_a_moment<64, engine::BruteForce>()), 64 * 63 / 2);
    // For discs anywhere between the walls: two are within a diameter d of each other along an axis
    // of width w with the probability 2 d / w - (d / w)^2.
    const double way = 2 * disc_radius / (2 * half_edge(1024) - 2 * disc_radius);
    const double expected = 1024 * 1023 / 2 * (2 * way - way * way);
    EXPECT_NEAR((pairs_of_a_moment<1024, engine::SortAndSweep>()), expected, expected / 20);
}
TEST(Pairs, OfDiscsThatAreStillAreThoseOnTheirLattice) {
    // Along the first axis the discs of a column touch only each other.
    DiscWorld<16, Counted<engine::SortAndSweep>> world;
    build<16, Counted<engine::SortAndSweep>>(world);
    Counted<engine::SortAndSweep>::collide_all(world, engine::BinaryStep<exponent_of_step>());
    EXPECT_EQ(world.pair_memory().pairs, 4u * (4 * 3 / 2));
}

TEST(Times, AreThoseOfTheTimedStepsAlone) {
    // A world that sleeps while it is made and warmed up, and then a millisecond per step.
    unsigned taken = 0;
    const Start slow_to_start = [&] {
        taken = 0;
        return [&](unsigned steps) {
            std::this_thread::sleep_for(std::chrono::milliseconds(taken == 0 ? 50 : steps));
            taken += steps;
        };
    };
    unsigned rounds_of_worlds = 0;
    const auto times = time_steps({slow_to_start}, [&] { ++rounds_of_worlds; });
    ASSERT_EQ(times.size(), 1u);
    EXPECT_EQ(taken, warm_steps + timed_steps);
    EXPECT_EQ(rounds_of_worlds, rounds);
    EXPECT_EQ(times[0].runs, rounds);
    EXPECT_LT(times[0].rejected, times[0].runs);
    EXPECT_GE(times[0].per_step, 1e6);
    EXPECT_LT(times[0].per_step, 2e6);
}

}  // namespace
}  // namespace growth
