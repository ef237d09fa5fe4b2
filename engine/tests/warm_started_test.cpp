// SPDX-License-Identifier: MIT
// WarmStartedGaussSeidel: at rest, its rows carry the weight that hangs on them or lies on them, in
// closed form; a single row does what ProjectedGaussSeidel does; and a bounce is a bounce.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "runs.hpp"

using namespace engine;
using namespace engine::literals;
using namespace scenes;
using runs::to_double;

namespace {

constexpr double g = 9.81, dt = 1.0 / 256;

template <class ChosenSolver>
struct Chain : Uses {
    static constexpr unsigned particles = 16, anchored_rods = 1, rods = 15;
    static constexpr bool gravity = true;
    using Solver = ChosenSolver;
};
template <class ChosenSolver>
struct Pile : Uses {
    static constexpr unsigned particles = 20, planes = 1, contacts = 24;
    static constexpr bool gravity = true, radii = true, collisions = true;
    using Solver = ChosenSolver;
};

// Points of 1 kg, each 0.5 m below the last, the lowest of `heavy` kg.
template <class World>
void hang(World& world, unsigned n, double heavy) {
    using Scalar = typename World::Scalar;
    world.gravity = {0_d, -9.81_d};
    typename World::Body body;
    typename World::Handle last;
    for (unsigned i = 0; i < n; ++i) {
        body.position[1] -= Scalar(0.5_d);
        body.inverse_mass = Scalar(1_d);
        if (i + 1 == n) body.inverse_mass = runs::Rounded<Scalar>::of(1 / heavy);
        const auto next = world.add_particle(body);
        if (i == 0)
            world.add_anchored_rod(next, {0_d, 0_d}, 0.5_d);
        else
            world.add_rod(next, last, 0.5_d);
        last = next;
    }
}
template <class World>
void pile(World& world, unsigned n) {
    using Scalar = typename World::Scalar;
    world.gravity = {0_d, -9.81_d};
    world.set_restitution_threshold(0.5_d);
    world.add_plane({0_d, 1_d}, 0_d, 0_d);
    typename World::Body ball;
    ball.inverse_mass = Scalar(1_d);
    ball.radius = Scalar(0.25_d);
    ball.position[1] = Scalar(0.25_d);
    for (unsigned i = 0; i < n; ++i) {
        world.add_particle(ball);
        ball.position[1] += Scalar(0.5_d);
    }
}
template <class World>
double largest_overlap(const World& world) {
    double last = -0.25, largest = 0;
    for (const auto& ball : world.particles()) {
        const double y = to_double(ball.position[1]);
        largest = std::max(largest, 0.5 - (y - last));
        last = y;
    }
    return largest;
}

// For a row between a and b, i = 1/m: the impulse is change / (i_a + i_b), and at rest it is the
// tension of a step. Rod number k from above carries what hangs below it.
TEST(WarmStarted, RodsOfAChainAtRestBearTheWeightBelow) {
    for (const double heavy : {1., 10., 100.}) {
        World<double, Chain<WarmStartedGaussSeidel<10>>> world;
        hang(world, 8, heavy);
        for (int step = 0; step < 4000; ++step) world.step(BinaryStep<8>());
        for (unsigned k = 0; k < 8; ++k) {
            const auto& row = world.rows()[k];
            const double inverse = (k == 7 ? 1 / heavy : 1) + (k == 0 ? 0 : 1);
            const double weight = (7 - k + heavy) * g;
            EXPECT_NEAR(-row.change / inverse / dt, weight, 1e-6 * weight) << k << ", " << heavy;
        }
    }
}

TEST(WarmStarted, ContactsOfAPileAtRestBearTheWeightAbove) {
    World<double, Pile<WarmStartedGaussSeidel<10>>> world;
    pile(world, 20);
    for (int step = 0; step < 8000; ++step) world.step(BinaryStep<8>());
    ASSERT_EQ(world.rows().size(), 20);
    for (unsigned k = 0; k < 20; ++k) {
        const auto& row = world.rows()[k];
        const double weight = (20 - k) * g;
        EXPECT_NEAR(row.change / (k == 0 ? 1 : 2) / dt, weight, 1e-3 * weight) << k;
    }
}

// In Q16.16, which rounds: a pile of 20 with four iterations keeps its shape; without warm starting
// it collapses.
TEST(WarmStarted, HoldsAPileOfTwentyThatFourIterationsDoNot) {
    World<SaturatingFixed<16, 16>, Pile<WarmStartedGaussSeidel<4>>> warm;
    World<SaturatingFixed<16, 16>, Pile<ProjectedGaussSeidel<4>>> cold;
    pile(warm, 20), pile(cold, 20);
    double of_warm = 0, of_cold = 0;
    for (int step = 0; step < 8000; ++step) {
        warm.step(BinaryStep<8>());
        cold.step(BinaryStep<8>());
        of_warm = std::max(of_warm, largest_overlap(warm));
        of_cold = std::max(of_cold, largest_overlap(cold));
    }
    EXPECT_LT(of_warm, 0.002);
    EXPECT_GT(of_cold, 0.05);
}

template <class Scalar, class Solver>
double largest_excess(unsigned links, double heavy) {
    World<Scalar, Chain<Solver>> world;
    hang(world, links, heavy);
    double largest = 0;
    for (int step = 0; step < 2000; ++step) {
        world.step(BinaryStep<8>());
        double last = 0;
        for (const auto& point : world.particles()) {
            const double y = to_double(point.position[1]);
            largest = std::max(largest, std::abs(last - y - 0.5));
            last = y;
        }
    }
    return largest;
}
TEST(WarmStarted, AChainBearsAThousandTimesItsMass) {
    using Number = SaturatingFixed<16, 16>;
    for (const unsigned links : {4u, 8u, 16u}) {
        EXPECT_LT((largest_excess<Number, WarmStartedGaussSeidel<10>>(links, 1000)), 0.05) << links;
        EXPECT_LT((largest_excess<double, WarmStartedGaussSeidel<10>>(links, 1000)), 0.05) << links;
        EXPECT_GT((largest_excess<double, ProjectedGaussSeidel<10>>(links, 100)), 0.4) << links;
    }
}

// A single row is solved exactly: then it does not matter where the solver started.
struct Warm : SemiImplicit {
    using Solver = WarmStartedGaussSeidel<10>;
};
TEST(WarmStarted, ASingleRowIsSolvedAsWithoutIt) {
    EXPECT_LT(runs::largest_distance((runs::run<Pendulum, Warm, double, 8>()),
                                     (runs::run<Pendulum, SemiImplicit, double, 8>())),
              1e-11);
}

// Compared with the closed forms; only the overlap that stays is added.
TEST(WarmStarted, BouncesAreAsAccurateAsWithoutIt) {
    EXPECT_LT((runs::error<BouncingBall, Warm, double, 10>()),
              (runs::error<BouncingBall, SemiImplicit, double, 10>() + 1e-4));
    EXPECT_LT((runs::error<TwoBodyCollision, Warm, double, 10>()),
              (runs::error<TwoBodyCollision, SemiImplicit, double, 10>() + 1e-4));
}

}  // namespace
