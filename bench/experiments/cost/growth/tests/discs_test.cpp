// SPDX-License-Identifier: GPL-3.0-or-later
// The engine and Box2D are timed with the same discs: both start in the same state, conserve the
// energy, and keep the discs apart and in the box.
#include "bench/experiments/cost/growth/discs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <engine/hash.hpp>
#include <memory>
#include <vector>

#include "bench/experiments/cost/growth/box2d_discs.hpp"
#include "bench/experiments/cost/growth/counted.hpp"
#include "bench/experiments/cost/growth/fit.hpp"
#include "bench/experiments/cost/growth/stopwatch.hpp"

namespace growth {
namespace {

constexpr unsigned number = 64, steps = 128;
constexpr float steps_way = 4 * 1.42f / (1 << exponent_of_step);  // m, of the fastest at the start

using engine::CachedSortAndSweep, engine::SortAndSweep;
// Too large for the stack.
template <class Search>
std::unique_ptr<DiscWorld<Search>> made(unsigned n) {
    auto world = std::make_unique<DiscWorld<Search>>();
    build<Search>(*world, n);
    return world;
}

std::vector<Disc> discs_of(const DiscWorld<CachedSortAndSweep>& world) {
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
    const auto ours = made<CachedSortAndSweep>(number);
    const auto theirs = box2d_discs(number);
    const auto mine = discs_of(*ours), other = discs_of(*theirs);
    ASSERT_EQ(mine.size(), number);
    ASSERT_EQ(other.size(), number);
    for (unsigned i = 0; i < number; ++i)
        for (unsigned axis = 0; axis < 2; ++axis) {
            EXPECT_EQ(mine[i].position[axis], other[i].position[axis]);
            EXPECT_EQ(mine[i].velocity[axis], other[i].velocity[axis]);
        }
    const double energy = energy_of(mine);
    for (unsigned i = 0; i < steps; ++i) {
        ours->step(engine::BinaryStep<exponent_of_step>());
        step(*theirs);
    }
    for (const auto& discs : {discs_of(*ours), discs_of(*theirs)}) {
        EXPECT_NEAR(energy_of(discs), energy, energy / 20);
        EXPECT_GT(changed(discs), number / 2);
        expect_a_box_of_discs(discs);
    }
}

template <class Search>
unsigned long pairs_of_a_moment(unsigned n) {
    const auto counted = made<Counted<Search>>(n);
    const auto plain = made<Search>(n);
    unsigned long before = 0;
    for (unsigned i = 0; i < steps; ++i) {
        before = counted->pair_memory().pairs;
        counted->step(engine::BinaryStep<exponent_of_step>());
        plain->step(engine::BinaryStep<exponent_of_step>());
    }
    EXPECT_EQ(engine::state_hash(*counted), engine::state_hash(*plain));
    return counted->pair_memory().pairs - before;
}

TEST(Pairs, AreAllOfThemOrThoseThatOverlapAlongTheFirstAxis) {
    EXPECT_EQ(pairs_of_a_moment<engine::BruteForce>(64), 64 * 63 / 2);
    // For uniformly distributed discs: two are within a diameter d of each other along an axis of
    // width w with probability 2 d / w - (d / w)^2.
    const double way = 2 * disc_radius / (2 * half_edge(1024) - 2 * disc_radius);
    const double expected = 1024 * 1023 / 2. * (2 * way - way * way);
    EXPECT_NEAR(pairs_of_a_moment<SortAndSweep>(1024), expected, expected / 20);
}
TEST(Pairs, OfDiscsThatAreStillAreThoseOnTheirLattice) {
    // Along the first axis the discs of a column touch only each other.
    const auto world = made<Counted<SortAndSweep>>(16);
    Counted<SortAndSweep>::collide_all(*world, engine::BinaryStep<exponent_of_step>());
    EXPECT_EQ(world->pair_memory().pairs, 4u * (4 * 3 / 2));
}
TEST(Pairs, AreTheSameWhereTheyAreFoundInCopies) {
    for (const unsigned n : {16, 1024}) {
        const auto cached = made<Counted<CachedSortAndSweep>>(n);
        const auto plain = made<Counted<SortAndSweep>>(n);
        for (unsigned i = 0; i < 512; ++i) {
            cached->step(engine::BinaryStep<exponent_of_step>());
            plain->step(engine::BinaryStep<exponent_of_step>());
            ASSERT_EQ(engine::state_hash(*cached), engine::state_hash(*plain)) << n << " " << i;
            ASSERT_EQ(cached->pair_memory().pairs, plain->pair_memory().pairs) << n << " " << i;
        }
    }
}
TEST(Pairs, GrowAsTheStripsThatDiscsShare) {
    // The number of discs that a disc overlaps along one axis grows with the root of N. The walls
    // are tested, too: without them, the pairs of a few discs would count as much as all the rest.
    std::vector<Sample> samples;
    for (const unsigned n : {16, 36, 64, 144, 256, 576, 1024, 2304, 4096, 9216, 16384}) {
        const auto world = made<Counted<CachedSortAndSweep>>(n);
        const auto pairs_of = [&](unsigned taken) {
            const auto before = world->pair_memory().pairs;
            for (unsigned i = 0; i < taken; ++i)
                world->step(engine::BinaryStep<exponent_of_step>());
            return static_cast<double>(world->pair_memory().pairs - before) / taken;
        };
        pairs_of(warm_steps);
        samples.push_back({1.0 * n, n * std::sqrt(n), 4.0 * n + pairs_of(timed_steps(n))});
    }
    EXPECT_LE(fitted(samples).worst, 0.05);
}

TEST(Times, AreThoseOfTheTimedStepsAlone) {
    // A world that keeps the processor busy while it is made and warmed up, and then for a
    // millisecond per step.
    const auto busy = [](double milliseconds) {
        const std::clock_t begin = std::clock();
        while (1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC < milliseconds) {
        }
    };
    constexpr unsigned timed = 20;
    unsigned taken = 0;
    const Start slow_to_start = [&] {
        taken = 0;
        return [&](unsigned steps) {
            busy(taken == 0 ? 50 : steps);
            taken += steps;
        };
    };
    constexpr unsigned rounds = 5;
    unsigned rounds_of_worlds = 0;
    const auto times = time_steps({{slow_to_start, timed}}, rounds, [&] { ++rounds_of_worlds; });
    ASSERT_EQ(times.size(), 1u);
    EXPECT_EQ(taken, warm_steps + timed);
    EXPECT_EQ(rounds_of_worlds, rounds);
    EXPECT_EQ(times[0].runs, rounds);
    EXPECT_LT(times[0].rejected, times[0].runs);
    EXPECT_GE(times[0].per_step, 0.99e6);
    EXPECT_LT(times[0].per_step, 2e6);
}

}  // namespace
}  // namespace growth
