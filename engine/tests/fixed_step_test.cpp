// SPDX-License-Identifier: MIT
// What only fixed-point worlds do: share by masses whose inverses overflow, stiff springs whose
// terms overflow, residuals, hashes. Compared with doubles and exact integers.
#include <engine.h>
#include <gtest/gtest.h>

#include <cmath>
#include <engine/hash.hpp>

using namespace engine::literals;
using engine::BinaryStep;
using engine::Fixed;

namespace {

using Q8_8 = Fixed<8, 8>;
double value(Q8_8 x) { return x.raw() / 256.0; }

struct Pair : engine::Uses {
    static constexpr unsigned particles = 2, rods = 1;
};

// Two on a rod that is 2 m too long: who moves, and by how much.
void expect_shares(Q8_8 inverse_a, Q8_8 inverse_b, double share_a, double share_b) {
    engine::World<Q8_8, Pair> world;
    decltype(world)::Body body;
    body.inverse_mass = inverse_a;
    body.position = {4_d, 0_d};
    const auto a = world.add_particle(body);
    body.inverse_mass = inverse_b;
    body.position = {0_d, 0_d};
    const auto b = world.add_particle(body);
    world.add_rod(a, b, 2_d);
    if (share_a + share_b > 0) {
        EXPECT_NEAR(value(engine::mass_share(world, a.index, b.index)), share_a, 1.01 / 256);
    }
    world.step(BinaryStep<6>());
    EXPECT_NEAR(4 - value(world[a].position[0]), 2 * share_a, 2.01 / 256) << value(inverse_a);
    EXPECT_NEAR(value(world[b].position[0]), 2 * share_b, 2.01 / 256) << value(inverse_b);
}

TEST(MassShare, IsInProportionToInverseMassInEveryRange) {
    expect_shares(1_d, 1_d, 0.5, 0.5);
    expect_shares(3_d, 1_d, 0.75, 0.25);
    expect_shares(1_d, 3_d, 0.25, 0.75);
    expect_shares(1_d, 0_d, 1, 0);
    expect_shares(0_d, 1_d, 0, 1);
    expect_shares(0_d, 0_d, 0, 0);
    // The sum of the inverse masses leaves the format at 128.
    expect_shares(64_d, 63_d, 64 / 127.0, 63 / 127.0);
    expect_shares(100_d, 100_d, 0.5, 0.5);
    expect_shares(120_d, 40_d, 0.75, 0.25);
    expect_shares(40_d, 120_d, 0.25, 0.75);
    expect_shares(127_d, 1_d, 127 / 128.0, 1 / 128.0);
    expect_shares(1_d, 127_d, 1 / 128.0, 127 / 128.0);
    expect_shares(127.5_d, 0.5_d, 127.5 / 128, 0.5 / 128);
}

struct Stiff : engine::Uses {
    static constexpr unsigned particles = 2, anchored_springs = 1, springs = 1;
    using Integrator = engine::ImplicitSprings;
};

double saturated(double x) { return std::min(x, 127.99609375); }

// u' = (u - s x) / d with s = i h k and d = 1 + h i (h k + c), each term at the end of its range if
// it does not fit.
void expect_implicit(double inverse, double k, double c, double x, double u) {
    const double h = 1 / 16.0;
    const double s = saturated(inverse * (k * h));
    const double slowing = c == 0 ? s : saturated(inverse * saturated(k * h + c));
    const double d = saturated(1 + slowing * h);
    const double after = u / d - s / d * x;
    engine::World<Q8_8, Stiff> world;
    decltype(world)::Body body;
    const auto number = [](double y) { return Q8_8::from_raw(int16_t(std::lround(256 * y))); };
    body.inverse_mass = number(inverse);
    body.position = {number(1 + x), 0_d};
    body.velocity = {number(u), 0_d};
    const auto a = world.add_particle(body);
    world.add_anchored_spring(a, {0_d, 0_d}, number(k), number(c), 1_d);
    world.step(BinaryStep<4>());
    EXPECT_NEAR(value(world[a].velocity[0]), after, 0.02 * (1 + std::abs(x) + std::abs(u) / 8))
        << "1/m " << inverse << ", k " << k << ", c " << c << ", x " << x << ", u " << u;
}

TEST(ImplicitSprings, FollowTheClosedFormWhereTermsOverflow) {
    for (const double inverse : {0.5, 1.0, 8.0, 100.0})
        for (const double k : {0.0, 1.0, 16.0, 120.0})
            for (const double c : {0.0, 0.25, 2.0, 124.0})
                for (const double x : {0.0, 0.5, -0.5})
                    for (const double u : {0.0, 2.0, -3.0}) expect_implicit(inverse, k, c, x, u);
}

// Inverse masses of 100 each: their sum saturates, and the pair shares equally.
TEST(ImplicitSprings, OfLightPairsPullBothEnds) {
    engine::World<Q8_8, Stiff> world;
    decltype(world)::Body body;
    body.inverse_mass = 100_d;
    body.position = {2_d, 0_d};
    const auto a = world.add_particle(body);
    body.position = {0_d, 0_d};
    const auto b = world.add_particle(body);
    world.add_spring(a, b, 2_d, 0_d, 1_d);
    world.step(BinaryStep<4>());
    const double s = 127.996 * 2 / 16, pulled = -s / (1 + s / 16);
    EXPECT_NEAR(value(world[a].velocity[0]), pulled / 2, 0.05);
    EXPECT_NEAR(value(world[b].velocity[0]), -pulled / 2, 0.05);
}

struct Slow : engine::Uses {
    static constexpr unsigned char dimensions = 3;
    static constexpr unsigned particles = 1;
    static constexpr bool gravity = true, compensated_integration = true;
};

// After every step, positions and velocities are the floors of the exact sums.
TEST(CompensatedIntegration, LosesNothing) {
    engine::World<Q8_8, Slow> world;
    const int v[3] = {3, -5, 1000}, g[3] = {1, -7, 130};
    decltype(world)::Body body;
    for (unsigned char i = 0; i < 3; ++i) {
        body.velocity[i] = Q8_8::from_raw(int16_t(v[i]));
        world.gravity[i] = Q8_8::from_raw(int16_t(g[i]));
    }
    body.inverse_mass = 1_d;
    const auto a = world.add_particle(body);
    int64_t position[3] = {};  // times 2^7, for velocities that are floors themselves
    for (int step = 1; step <= 300; ++step) {
        world.step(BinaryStep<7>());
        for (unsigned char i = 0; i < 3; ++i) {
            const int velocity = v[i] + int(std::floor(step * g[i] / 128.0));
            position[i] += velocity;
            ASSERT_EQ(world[a].velocity[i].raw(), velocity) << step;
            ASSERT_EQ(world[a].position[i].raw(), int(std::floor(double(position[i]) / 128)))
                << step;
        }
    }
}

// The residual of a step too small for the format is all of the rate; the sum of both saturates.
TEST(CompensatedIntegration, CarriesByteByByte) {
    using Number = Fixed<4, 4>;
    for (int count = 0; count < 12; ++count) {
        for (int a = -128; a < 128; ++a) {
            for (int residual = 0; residual < (1 << std::min(count, 7)); ++residual) {
                Number left = Number::from_raw(int8_t(residual));
                const Number carried =
                    engine::carried_shift(Number::from_raw(int8_t(a)), count, left);
                const int sum = std::min(a + residual, 127);
                const int whole = int(std::floor(std::ldexp(sum, -count)));
                ASSERT_EQ(int(carried.raw()), whole) << a << " >> " << count;
                const int rest = count < 7 ? sum - whole * (1 << count) : 0;
                ASSERT_EQ(int(left.raw()), rest) << a << " >> " << count;
            }
        }
    }
}

// FNV-1a of bytes, from the tables of its authors.
TEST(Hash, IsFnv1a) {
    EXPECT_EQ(engine::hash_into(2166136261u, 'a'), 0xe40c292cu);
    const char foobar[] = {'f', 'o', 'o', 'b', 'a', 'r'};
    EXPECT_EQ(engine::hash_into(2166136261u, foobar), 0xbf9cf968u);
}

TEST(Hash, DependsOnPositionsVelocitiesAndTheirOrder) {
    engine::World<Q8_8, Pair> world;
    EXPECT_EQ(engine::state_hash(world), 2166136261u);
    world.add_particle({});
    const auto one = engine::state_hash(world);
    EXPECT_EQ(one, engine::hash_into(2166136261u, int64_t(0)));
    world[{0}].position[0] = 1_d;
    const auto moved = engine::state_hash(world);
    world[{0}].position[0] = 0_d;
    world[{0}].velocity[0] = 1_d;
    EXPECT_NE(moved, one);
    EXPECT_NE(engine::state_hash(world), one);
    EXPECT_NE(engine::state_hash(world), moved);
    EXPECT_EQ(engine::state_hash(world), engine::hash_into(2166136261u, int64_t(0x100) << 32));
}

// Both sides of a saturating sum and product.
TEST(Scalar, SaturatesAtBothEnds) {
    const Q8_8 large = 100_d, small = -100_d;
    EXPECT_EQ(engine::saturating_sum(large, large).raw(), 32767);
    EXPECT_EQ(engine::saturating_sum(small, small).raw(), -32768);
    EXPECT_EQ(engine::saturating_sum(large, small).raw(), 0);
    EXPECT_EQ(engine::saturating_product(large, large).raw(), 32767);
    EXPECT_EQ(engine::saturating_product(large, small).raw(), -32768);
    EXPECT_EQ(value(engine::saturating_product(Q8_8(2_d), Q8_8(-3_d))), -6);
    EXPECT_EQ(engine::saturating_sum(2.0, 3.0), 5);
    EXPECT_EQ(engine::saturating_product(2.0, 3.0), 6);
    EXPECT_EQ(engine::multiply_add(2.0, 3.0, 4.0), 10);
    EXPECT_EQ(engine::absolute(-2.0), 2);
    EXPECT_EQ(engine::absolute(2.0), 2);
}

// With both namespaces open, multiply_add of Fixed numbers is the library's.
TEST(Scalar, MultiplyAddIsOneName) {
    using namespace engine;
    using namespace fixedpoint;
    const Q8_8 third = Q8_8::from_raw(85), four = 4_d;
    EXPECT_EQ(multiply_add(third, third, four).raw(), 1024 + 28);
    EXPECT_EQ(engine::multiply_add(third, third, four).raw(), 1024 + 28);
    EXPECT_EQ(multiply_add(2.0, 3.0, 4.0), 10);
}

}  // namespace
