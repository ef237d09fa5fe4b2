// SPDX-License-Identifier: MIT
// Every error is reported, leaves the world as it was, and handles stay valid.
#include <engine.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

using namespace engine::literals;
using engine::Error;

namespace {

struct Everything : engine::Uses {
    static constexpr unsigned particles = 3, springs = 1, anchored_springs = 1, drags = 1, rods = 1,
                              anchored_rods = 1, ropes = 1, anchored_ropes = 1, planes = 1,
                              contacts = 1;
    static constexpr bool radii = true, collisions = true, gravity = true, damping = true;
    using Solver = engine::WorstFirst<4>;
};

template <class Scalar>
struct WorldErrors : testing::Test {
    using World = engine::World<Scalar, Everything>;
    using Handle = typename World::Handle;

    WorldErrors() {
        body.inverse_mass = 1_d;
        a = world.add_particle(body);
        body.position = {2_d, 0_d};
        b = world.add_particle(body);
    }
    // What the last call did must be refused for that reason; the next may succeed.
    void expect(Error error, bool done) {
        EXPECT_FALSE(done);
        EXPECT_STREQ(engine::describe(world.error()), engine::describe(error));
        world.clear_error();
    }

    World world;
    typename World::Body body;
    Handle a, b;
    const Handle nobody{World::capacity};
    const Handle refused{static_cast<typename World::Index>(-1)};
};
using Scalars = testing::Types<engine::Fixed<16, 16>, engine::Fixed<8, 24>, float, double>;
TYPED_TEST_SUITE(WorldErrors, Scalars);

}  // namespace

TYPED_TEST(WorldErrors, BadNumbers) {
    auto& world = this->world;
    const auto a = this->a, b = this->b;
    auto body = this->body;
    body.inverse_mass = -1_d;
    this->expect(Error::bad_mass, static_cast<bool>(world.add_particle(body)));
    body = this->body;
    body.radius = -0.5_d;
    this->expect(Error::bad_radius, static_cast<bool>(world.add_particle(body)));
    this->expect(Error::bad_length, world.add_rod(a, b, 0_d));
    this->expect(Error::bad_length, world.add_rod(a, b, -1_d));
    this->expect(Error::bad_length, world.add_anchored_rod(a, {0_d, 0_d}, 0_d));
    this->expect(Error::bad_length, world.add_rope(a, b, 0_d, 0_d));
    this->expect(Error::bad_length, world.add_anchored_rope(a, {0_d, 0_d}, 0_d, 0_d));
    this->expect(Error::bad_length, world.add_spring(a, b, 1_d, 0_d, -1_d));
    this->expect(Error::bad_stiffness, world.add_spring(a, b, -1_d, 0_d, 1_d));
    this->expect(Error::bad_stiffness, world.add_anchored_spring(a, {0_d, 0_d}, 1_d, -1_d, 1_d));
    this->expect(Error::bad_stiffness, world.add_drag(a, -1_d, 0_d));
    this->expect(Error::bad_stiffness, world.add_drag(a, 0_d, -1_d));
    this->expect(Error::bad_normal, world.add_plane({0_d, 0_d}, 0_d, 0_d));
    EXPECT_EQ(world.particles().size(), 2);
    EXPECT_EQ(world.rods().size() + world.ropes().size() + world.springs().size(), 0);
}

TYPED_TEST(WorldErrors, BadHandles) {
    auto& world = this->world;
    const auto a = this->a;
    for (const auto bad : {this->nobody, this->refused}) {
        this->expect(Error::no_such_particle, world.add_rod(a, bad, 1_d));
        this->expect(Error::no_such_particle, world.add_rod(bad, a, 1_d));
        this->expect(Error::no_such_particle, world.add_anchored_rod(bad, {0_d, 0_d}, 1_d));
        this->expect(Error::no_such_particle, world.add_spring(a, bad, 1_d, 0_d, 1_d));
        this->expect(Error::no_such_particle, world.add_rope(bad, a, 1_d, 0_d));
        this->expect(Error::no_such_particle, world.add_anchored_rope(bad, {0_d, 0_d}, 1_d, 0_d));
        this->expect(Error::no_such_particle, world.add_drag(bad, 1_d, 0_d));
    }
    this->expect(Error::same_particle, world.add_rod(a, a, 1_d));
    this->expect(Error::same_particle, world.add_rope(a, a, 1_d, 0_d));
    this->expect(Error::same_particle, world.add_spring(a, a, 1_d, 0_d, 1_d));
}

TYPED_TEST(WorldErrors, FullPools) {
    auto& world = this->world;
    const auto a = this->a, b = this->b;
    EXPECT_TRUE(static_cast<bool>(world.add_particle(this->body)));
    this->expect(Error::pool_full, static_cast<bool>(world.add_particle(this->body)));
    const auto twice = [&](auto add) {
        EXPECT_TRUE(add());
        this->expect(Error::pool_full, add());
    };
    twice([&] { return world.add_rod(a, b, 1_d); });
    twice([&] { return world.add_anchored_rod(a, {0_d, 0_d}, 1_d); });
    twice([&] { return world.add_rope(a, b, 1_d, 0_d); });
    twice([&] { return world.add_anchored_rope(a, {0_d, 0_d}, 1_d, 0_d); });
    twice([&] { return world.add_spring(a, b, 1_d, 0_d, 1_d); });
    twice([&] { return world.add_anchored_spring(a, {0_d, 0_d}, 1_d, 0_d, 1_d); });
    twice([&] { return world.add_drag(a, 1_d, 0_d); });
    twice([&] { return world.add_plane({0_d, 1_d}, 0_d, 0_d); });
}

TYPED_TEST(WorldErrors, HandlesStayValid) {
    this->world.add_particle(this->body);
    this->world.add_particle(this->body);  // refused
    EXPECT_EQ(this->world[this->a].position[0], TypeParam());
    EXPECT_EQ(this->world[this->b].position, this->body.position);
    this->world.step(engine::BinaryStep<6>());
    EXPECT_EQ(this->world[this->b].position[0], this->body.position[0]);
}

TYPED_TEST(WorldErrors, TheFirstErrorIsKept) {
    this->world.add_rod(this->a, this->a, 1_d);
    this->world.add_rod(this->a, this->b, 0_d);
    EXPECT_EQ(this->world.error(), Error::same_particle);
    this->world.clear_error();
    EXPECT_EQ(this->world.error(), Error::none);
}

namespace {
// Room for one contact.
struct Crowd : engine::Uses {
    static constexpr unsigned particles = 3, contacts = 1;
    static constexpr bool radii = true, collisions = true;
};
}  // namespace

TEST(WorldError, MoreContactsThanStatedAreReported) {
    engine::World<double, Crowd> world;
    engine::World<double, Crowd>::Body body;
    body.inverse_mass = 1;
    body.radius = 1;
    world.add_particle(body);
    body.position = {1.5, 0.0};
    world.add_particle(body);
    world.step(engine::BinaryStep<6>());
    EXPECT_EQ(world.error(), Error::none);
    body.position = {0.0, 0.5};
    world.add_particle(body);
    world.step(engine::BinaryStep<6>());
    EXPECT_EQ(world.error(), Error::contacts_full);
}

TEST(WorldError, EachHasItsOwnWords) {
    std::set<std::string> words;
    const int count = static_cast<int>(Error::contacts_full) + 1;
    for (int i = 0; i < count; ++i) words.insert(engine::describe(static_cast<Error>(i)));
    EXPECT_EQ(words.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(words.count("unknown error"), 0u);
}
