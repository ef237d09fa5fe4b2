// SPDX-License-Identifier: MIT
// In SaturatingFixed, a result that leaves the range stays at its end, on the side where it left
// it: in Q8.8, +-128, wherever the plain format wraps around to the other side.
#include <engine.h>
#include <gtest/gtest.h>

using namespace engine::literals;
using engine::BinaryStep;

namespace {

using Number = engine::SaturatingFixed<8, 8>;
using Plain = engine::Fixed<8, 8>;
constexpr int16_t most = 32767, least = -32768;

template <class Scalar, class Uses>
struct OneBody {
    using World = engine::World<Scalar, Uses>;
    World world;
    typename World::Handle body;

    OneBody(Scalar x, Scalar velocity, Scalar inverse_mass) {
        typename World::Body description;
        description.position[0] = x;
        description.velocity[0] = velocity;
        description.inverse_mass = inverse_mass;
        body = world.add_particle(description);
    }
    int16_t x() const { return world[body].position[0].raw(); }
    int16_t velocity() const { return world[body].velocity[0].raw(); }
};

struct Falling : engine::Uses {
    static constexpr unsigned particles = 1;
    static constexpr bool gravity = true;
};

TEST(Saturating, AnEndlessFallStaysAtTheEndOfTheRange) {
    OneBody<Number, Falling> saturating(-100_d, 0_d, 1_d);
    OneBody<Plain, Falling> plain(-100_d, 0_d, 1_d);
    saturating.world.gravity[0] = -100_d;
    plain.world.gravity[0] = -100_d;
    bool plain_came_back = false;
    int16_t before = saturating.x();
    for (int step = 0; step < 1000; ++step) {
        saturating.world.step(BinaryStep<6>());
        plain.world.step(BinaryStep<6>());
        ASSERT_LE(saturating.x(), before);
        before = saturating.x();
        plain_came_back |= plain.x() > 0;
    }
    EXPECT_EQ(saturating.x(), least);
    EXPECT_EQ(saturating.velocity(), least);
    EXPECT_TRUE(plain_came_back);
}

struct Pulled : engine::Uses {
    static constexpr unsigned particles = 1, anchored_springs = 1;
};

// 100 N/m by 100 m, and then by an inverse mass of 100: 10^4 and 10^6 in a range of 128.
TEST(Saturating, ForcesAndAccelerationsBeyondTheRangePullTheRightWay) {
    OneBody<Number, Pulled> right(100_d, 0_d, 100_d), left(-100_d, 0_d, 100_d);
    right.world.add_anchored_spring(right.body, {0_d, 0_d}, 100_d, 0_d, 0_d);
    left.world.add_anchored_spring(left.body, {0_d, 0_d}, 100_d, 0_d, 0_d);
    right.world.step(BinaryStep<4>());
    left.world.step(BinaryStep<4>());
    EXPECT_NEAR(right.velocity(), least / 16., 1);
    EXPECT_NEAR(left.velocity(), most / 16., 1);
}

struct Rolling : engine::Uses {
    static constexpr unsigned particles = 1, planes = 1, contacts = 1;
    using Solver = engine::ProjectedGaussSeidel<10>;
};

// The velocity changes by twice its value: 240 in a range of 128.
TEST(Saturating, ABounceReversesTheVelocity) {
    OneBody<Number, Rolling> body(1_d, -120_d, 1_d);
    body.world.add_plane({1_d, 0_d}, 0_d, 1_d);
    body.world.step(BinaryStep<4>());
    for (int step = 0; step < 2; ++step) body.world.step(BinaryStep<4>());
    EXPECT_GT(body.velocity(), 0);
}

struct Pair : engine::Uses {
    static constexpr unsigned particles = 2, contacts = 1;
    static constexpr bool radii = true, collisions = true;
};

template <class Scalar>
bool touch(Scalar a, Scalar b, Scalar radius) {
    engine::World<Scalar, Pair> world;
    typename decltype(world)::Body body;
    body.inverse_mass = 1_d;
    body.radius = radius;
    body.position[0] = a;
    world.add_particle(body);
    body.position[0] = b;
    world.add_particle(body);
    world.step(BinaryStep<4>());
    return world.rows().size() > 0;
}

// 255.5 m apart, which is -0.5 m in a range of 256; two radii of 100 m are -56 m there.
TEST(Saturating, DistantBodiesDoNotTouchAndLargeOnesDo) {
    EXPECT_FALSE(touch<Number>(127.75_d, -127.75_d, 1_d));
    EXPECT_TRUE(touch<Plain>(127.75_d, -127.75_d, 1_d));
    EXPECT_TRUE(touch<Number>(0_d, 50_d, 100_d));
    EXPECT_FALSE(touch<Plain>(0_d, 50_d, 100_d));
}

}  // namespace
