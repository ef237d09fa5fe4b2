// SPDX-License-Identifier: MIT
// The order of each method in each scene: the error relative to the true motion when the time step
// is halved.
#include "runs.hpp"

using namespace scenes;
using runs::error;

namespace {

// First and second order are far apart: a factor of 2 or 4, at steps of 2^-10 and 2^-11 s.
template <class Scene, class Method>
void expect_order(int order) {
    const double coarse = error<Scene, Method, double, 10>();
    const double fine = error<Scene, Method, double, 11>();
    const double factor = order == 1 ? 2 : 4;
    EXPECT_NEAR(coarse / fine, factor, 0.15 * factor) << Scene::name << ", " << Method::name;
    EXPECT_LT(coarse, 0.05) << Scene::name << ", " << Method::name;
}

// Verlet, but with iterations until rods agree with each other to the last bit.
struct VerletSolved : Verlet {
    using Solver = engine::ProjectedGaussSeidel<255>;
};
struct SemiImplicitSolved : SemiImplicit {
    using Solver = engine::ProjectedGaussSeidel<255>;
};

}  // namespace

TEST(Convergence, VerletFallsExactly) {
    EXPECT_LT((error<FreeFall, Verlet, double, 6>()), 1e-12);
    EXPECT_LT((error<FreeFall, Verlet, double, 10>()), 1e-11);
}

TEST(Convergence, VerletIsOfSecondOrder) {
    expect_order<SpringAndMass, Verlet>(2);
    expect_order<Pendulum, Verlet>(2);
    expect_order<Lever, Verlet>(2);
    expect_order<PublishedLever, Verlet>(2);
    expect_order<Stack, Verlet>(2);
    expect_order<DoublePendulum, VerletSolved>(2);
    expect_order<ChainOfRods, VerletSolved>(2);
}

// Ten iterations leave a part of what gravity adds in a step along rods that share a particle: an
// error of velocity proportional to the step.
TEST(Convergence, VerletIsOfFirstOrderWithFewIterations) {
    expect_order<ChainOfRods, Verlet>(1);
    EXPECT_GT((error<DoublePendulum, Verlet, double, 11>()),
              2 * (error<DoublePendulum, VerletSolved, double, 11>()));
}

// Drag depends on the velocity, and half of a step uses the velocity of half a step ago.
TEST(Convergence, VerletIsOfFirstOrderWithDrag) { expect_order<ProjectileWithDrag, Verlet>(1); }

TEST(Convergence, SemiImplicitEulerIsOfFirstOrder) {
    expect_order<FreeFall, SemiImplicit>(1);
    expect_order<SpringAndMass, SemiImplicit>(1);
    expect_order<Pendulum, SemiImplicit>(1);
    expect_order<Lever, SemiImplicit>(1);
    expect_order<PublishedLever, SemiImplicit>(1);
    expect_order<DoublePendulum, SemiImplicit>(1);
    expect_order<ChainOfRods, SemiImplicit>(1);
    expect_order<ChainOfRods, SemiImplicitSolved>(1);
    expect_order<ProjectileWithDrag, SemiImplicit>(1);
    expect_order<Stack, SemiImplicit>(1);
    expect_order<BouncingBall, SemiImplicit>(1);
}

TEST(Convergence, ImplicitSpringsAreOfFirstOrder) { expect_order<SpringAndMass, Implicit>(1); }

TEST(Convergence, ExplicitEulerIsOfFirstOrderWithoutRods) {
    expect_order<FreeFall, Published>(1);
    expect_order<SpringAndMass, Published>(1);
    expect_order<ProjectileWithDrag, Published>(1);
}

// The published contact resolution stops below a closing velocity of 0.01 m/s, which smaller steps
// do not reduce.
TEST(Convergence, PublishedRodsStopConverging) {
    EXPECT_GT((error<Pendulum, Published, double, 12>()),
              (error<Pendulum, Published, double, 10>()));
}

// If an event falls inside a step, the error is of first order, but jumps with the event's position
// in its step: judged over a factor of 64.
TEST(Convergence, EventsAreOfFirstOrder) {
    const auto falls = [](double coarse, double fine) {
        EXPECT_GT(coarse / fine, 64 / 4.0);
        EXPECT_LT(fine, 5e-3);
    };
    falls(error<RopeSwing, SemiImplicit, double, 6>(),
          error<RopeSwing, SemiImplicit, double, 12>());
    falls(error<RopeSwing, Verlet, double, 6>(), error<RopeSwing, Verlet, double, 12>());
    falls(error<TwoBodyCollision, Verlet, double, 6>(),
          error<TwoBodyCollision, Verlet, double, 12>());
    falls(error<NewtonsCradle, SemiImplicit, double, 6>(),
          error<NewtonsCradle, SemiImplicit, double, 12>());
    falls(error<NewtonsCradle, Verlet, double, 6>(), error<NewtonsCradle, Verlet, double, 12>());
}

// Head-on, and against a plane, the bounce is placed where it would be after its exact time.
TEST(Convergence, VerletBouncesToSecondOrder) {
    EXPECT_GT((error<BouncingBall, Verlet, double, 7>()),
              200 * (error<BouncingBall, Verlet, double, 12>()));
}

// The error that remains in double is that of the method alone.
TEST(Convergence, FiftyDigitsHaveTheErrorOfDouble) {
    const double wide = error<Pendulum, Verlet, reference::FiftyDigits, 8>();
    EXPECT_NEAR(wide, (error<Pendulum, Verlet, double, 8>()), 1e-6 * wide);
}
