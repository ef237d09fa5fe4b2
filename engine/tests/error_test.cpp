// SPDX-License-Identifier: MIT
// Every error is reported, leaves the world as it was, and handles stay valid.
#include <engine.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>
#include <type_traits>

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
    // The last call must have been refused for that reason; the next may succeed.
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
    const Handle beyond{2};
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
    body = this->body;
    for (const TypeParam damping : {TypeParam(-0.5_d), TypeParam(1.25_d)}) {
        body.damping = damping;
        this->expect(Error::bad_damping, static_cast<bool>(world.add_particle(body)));
    }
    EXPECT_EQ(world.particles().size(), 2);
    EXPECT_EQ(world.rods().size() + world.ropes().size() + world.springs().size(), 0);
}

TYPED_TEST(WorldErrors, BadRestitutions) {
    auto& world = this->world;
    for (const TypeParam bad : {TypeParam(-1_d), TypeParam(-0.01_d), TypeParam(1.01_d)}) {
        this->expect(Error::bad_restitution, world.add_plane({0_d, 1_d}, 0_d, bad));
        this->expect(Error::bad_restitution, world.add_rope(this->a, this->b, 1_d, bad));
        this->expect(Error::bad_restitution,
                     world.add_anchored_rope(this->a, {0_d, 0_d}, 1_d, bad));
        this->expect(Error::bad_restitution, world.set_restitution(bad));
    }
    this->expect(Error::bad_restitution, world.set_restitution_threshold(-0.01_d));
    EXPECT_EQ(world.planes().size() + world.ropes().size() + world.anchored_ropes().size(), 0);
    EXPECT_EQ(world.restitution(), TypeParam());
    EXPECT_EQ(world.restitution_threshold(), TypeParam());
    EXPECT_TRUE(world.set_restitution(1_d));
    EXPECT_TRUE(world.set_restitution_threshold(2_d));
    EXPECT_EQ(world.restitution(), TypeParam(1_d));
    EXPECT_EQ(world.restitution_threshold(), TypeParam(2_d));
    EXPECT_TRUE(world.set_restitution(0_d));
    EXPECT_TRUE(world.set_restitution_threshold(0_d));
    EXPECT_TRUE(world.add_plane({0_d, 1_d}, 0_d, 1_d));
    EXPECT_TRUE(world.add_rope(this->a, this->b, 1_d, 1_d));
}

// To 2^-9 of the length: three digits suffice, two do not.
TYPED_TEST(WorldErrors, NormalsOfALengthOtherThanOne) {
    using Vector = typename TestFixture::World::Vector;
    const Vector bad[] = {{0_d, 5_d}, {0_d, 0.5_d},   {0.71_d, 0.71_d}, {0.6_d, 0.79_d},
                          {1_d, 1_d}, {-1.01_d, 0_d}, {0_d, 0.99_d},    {100_d, 100_d}};
    for (const Vector& normal : bad) {
        this->expect(Error::bad_normal, this->world.add_plane(normal, 0_d, 0_d));
    }
    const Vector good[] = {
        {0_d, -1_d}, {1_d, 0_d}, {0.6_d, -0.8_d}, {0.707_d, 0.707_d}, {0.7071068_d, 0.7071068_d}};
    for (const Vector& normal : good) {
        typename TestFixture::World world;
        EXPECT_TRUE(world.add_plane(normal, 0_d, 0_d)) << engine::describe(world.error());
    }
}

TYPED_TEST(WorldErrors, LengthsBetweenSteps) {
    auto& world = this->world;
    const auto a = this->a, b = this->b;
    world.add_spring(a, b, 1_d, 0_d, 1_d);
    world.add_anchored_spring(a, {0_d, 0_d}, 1_d, 0_d, 1_d);
    world.add_rod(a, b, 1_d);
    world.add_anchored_rod(a, {0_d, 0_d}, 1_d);
    world.add_rope(a, b, 1_d, 0_d);
    world.add_anchored_rope(a, {0_d, 0_d}, 1_d, 0_d);
    const auto& rod = world.rods()[0];
    this->expect(Error::bad_length, world.set_length(rod, 0_d));
    this->expect(Error::bad_length, world.set_length(rod, -1_d));
    this->expect(Error::bad_length, world.set_length(world.anchored_rods()[0], 0_d));
    this->expect(Error::bad_length, world.set_length(world.ropes()[0], 0_d));
    this->expect(Error::bad_length, world.set_length(world.anchored_ropes()[0], 0_d));
    this->expect(Error::bad_length, world.set_length(world.springs()[0], -1_d));
    auto copy = rod;
    this->expect(Error::no_such_link, world.set_length(copy, 2_d));
    EXPECT_EQ(rod.length, TypeParam(1_d));
    EXPECT_TRUE(world.set_length(rod, 2_d));
    EXPECT_TRUE(world.set_length(world.anchored_rods()[0], 3_d));
    EXPECT_TRUE(world.set_length(world.ropes()[0], 4_d));
    EXPECT_TRUE(world.set_length(world.anchored_ropes()[0], 5_d));
    EXPECT_TRUE(world.set_length(world.springs()[0], 0_d));
    EXPECT_TRUE(world.set_length(world.anchored_springs()[0], 6_d));
    EXPECT_EQ(rod.length, TypeParam(2_d));
    EXPECT_EQ(world.anchored_rods()[0].length, TypeParam(3_d));
    EXPECT_EQ(world.ropes()[0].length, TypeParam(4_d));
    EXPECT_EQ(world.anchored_ropes()[0].length, TypeParam(5_d));
    EXPECT_EQ(world.springs()[0].rest_length, TypeParam());
    EXPECT_EQ(world.anchored_springs()[0].rest_length, TypeParam(6_d));
}

TYPED_TEST(WorldErrors, TimeStepsThatAreNotPositive) {
    auto& world = this->world;
    world.gravity = {1_d, 0_d};
    for (const TypeParam dt : {TypeParam(), TypeParam(-0.5_d)}) {
        world.step(dt);
        this->expect(Error::bad_time_step, false);
        EXPECT_EQ(world[this->a].velocity[0], TypeParam());
    }
    world.step(0.5_d);
    EXPECT_EQ(world.error(), Error::none);
    EXPECT_EQ(world[this->a].velocity[0], TypeParam(0.5_d));
}

// A handle that no add_particle made names no particle; those of other types of worlds do not
// compile.
TYPED_TEST(WorldErrors, HandlesOfNothing) {
    auto& world = this->world;
    const typename TestFixture::Handle made{};
    EXPECT_FALSE(made);
    this->expect(Error::no_such_particle, world.add_rod(made, this->a, 1_d));
    EXPECT_EQ(&world[made], &world[this->a]);
    this->expect(Error::no_such_particle, false);
    EXPECT_EQ(&const_cast<const typename TestFixture::World&>(world)[this->nobody],
              &world[this->a]);
    this->expect(Error::no_such_particle, false);
    using Other = engine::World<long double, Everything>;
    EXPECT_FALSE(
        (std::is_convertible<typename Other::Handle, typename TestFixture::Handle>::value));
}

TYPED_TEST(WorldErrors, BadHandles) {
    auto& world = this->world;
    const auto a = this->a;
    for (const auto bad : {this->nobody, this->refused, this->beyond}) {
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

// The shortest length is the one whose reciprocal is the last number of the format.
TEST(WorldError, ALengthWithoutReciprocalIsRefused) {
    using Number = engine::Fixed<5, 27>;
    engine::World<Number, Everything> world;
    world.add_particle({});
    const auto a = world.add_particle({}), b = world.add_particle({});
    const Number sixteenth = Number::from_raw(1 << 23);
    EXPECT_FALSE(world.add_rod(a, b, sixteenth));
    EXPECT_EQ(world.error(), Error::bad_length);
    world.clear_error();
    EXPECT_TRUE(world.add_rod(a, b, sixteenth + Number::from_raw(1)));
    EXPECT_FALSE(world.set_length(world.rods()[0], sixteenth));
    EXPECT_EQ(world.error(), Error::bad_length);
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

namespace {
template <class Scalar>
struct FloatingErrors : WorldErrors<Scalar> {};
using FloatingScalars = testing::Types<float, double>;
TYPED_TEST_SUITE(FloatingErrors, FloatingScalars);
}  // namespace

TYPED_TEST(FloatingErrors, NumbersThatAreNotFinite) {
    auto& world = this->world;
    const auto a = this->a, b = this->b;
    using Limits = std::numeric_limits<TypeParam>;
    using Vector = typename TestFixture::World::Vector;
    for (const TypeParam bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
        for (const unsigned char axis : {0, 1}) {
            Vector vector(0_d, 0_d);
            vector[axis] = bad;
            auto body = this->body;
            body.position = vector;
            this->expect(Error::not_finite, static_cast<bool>(world.add_particle(body)));
            body = this->body;
            body.velocity = vector;
            this->expect(Error::not_finite, static_cast<bool>(world.add_particle(body)));
            this->expect(Error::not_finite, world.add_plane(vector, 0_d, 0_d));
            this->expect(Error::not_finite, world.add_anchored_rod(a, vector, 1_d));
            this->expect(Error::not_finite, world.add_anchored_rope(a, vector, 1_d, 0_d));
            this->expect(Error::not_finite, world.add_anchored_spring(a, vector, 1_d, 0_d, 0_d));
        }
        auto body = this->body;
        body.inverse_mass = bad;
        this->expect(Error::bad_mass, static_cast<bool>(world.add_particle(body)));
        body = this->body;
        body.radius = bad;
        this->expect(Error::bad_radius, static_cast<bool>(world.add_particle(body)));
        body = this->body;
        body.damping = bad;
        this->expect(Error::bad_damping, static_cast<bool>(world.add_particle(body)));
        this->expect(Error::bad_length, world.add_rod(a, b, bad));
        this->expect(Error::bad_length, world.add_anchored_rod(a, {0_d, 0_d}, bad));
        this->expect(Error::bad_length, world.add_rope(a, b, bad, 0_d));
        this->expect(Error::bad_restitution, world.add_rope(a, b, 1_d, bad));
        this->expect(Error::bad_stiffness, world.add_spring(a, b, bad, 0_d, 0_d));
        this->expect(Error::bad_stiffness, world.add_spring(a, b, 0_d, bad, 0_d));
        this->expect(Error::bad_length, world.add_spring(a, b, 0_d, 0_d, bad));
        this->expect(Error::bad_stiffness, world.add_drag(a, bad, 0_d));
        this->expect(Error::bad_stiffness, world.add_drag(a, 0_d, bad));
        this->expect(Error::not_finite, world.add_plane({0_d, 1_d}, bad, 0_d));
        this->expect(Error::bad_restitution, world.add_plane({0_d, 1_d}, 0_d, bad));
        this->expect(Error::bad_restitution, world.set_restitution(bad));
        this->expect(Error::bad_restitution, world.set_restitution_threshold(bad));
        if (world.rods().size() == 0) world.add_rod(a, b, 1_d);
        this->expect(Error::bad_length, world.set_length(world.rods()[0], bad));
        world.step(bad);
        this->expect(Error::bad_time_step, false);
    }
}

namespace {
struct PointOnly : engine::Uses {
    static constexpr unsigned particles = 1;
};
}  // namespace

// A radius and a damping that the scene does not use are ignored.
TEST(WorldError, UnusedNumbersAreNotChecked) {
    engine::World<double, PointOnly> world;
    engine::World<double, PointOnly>::Body body;
    body.radius = body.damping = -1;
    EXPECT_TRUE(world.add_particle(body));
    EXPECT_EQ(world.error(), Error::none);
}

TEST(WorldError, RodWithoutDirectionIsReportedAndTheStepContinues) {
    engine::World<double, Everything> world;
    engine::World<double, Everything>::Body body;
    body.inverse_mass = 1;
    body.velocity = {4_d, 0_d};
    const auto a = world.add_particle(body);
    world.add_anchored_rod(a, {0_d, 0_d}, 1_d);
    world.step(engine::BinaryStep<2>());
    EXPECT_EQ(world.error(), Error::no_direction);
    EXPECT_EQ(world[a].position[0], 1);
}

TEST(WorldError, EachHasItsOwnDescription) {
    std::set<std::string> words;
    const int count = static_cast<int>(Error::no_such_link) + 1;
    for (int i = 0; i < count; ++i) words.insert(engine::describe(static_cast<Error>(i)));
    EXPECT_EQ(words.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(words.count("unknown error"), 0u);
}
