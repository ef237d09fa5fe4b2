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

struct Midpoint : Implicit {
    static constexpr const char* name = "implicit_midpoint";
    using Integrator = engine::ImplicitMidpoint;
};

// The largest error in m over 4 s, in steps of 2^-K s, of 1 kg on a spring that is released 1 m
// beyond its length. Truth: the frequency omega in 1/s, and the damping zeta. The spring has the
// stiffness k.
template <class Method, int K>
double spring_error(double omega, double zeta, double k) {
    engine::World<double, SpringAndMass::Uses<Method>> world;
    SpringAndMass::Parameters<double> with;
    with.x = 33;
    with.y = 0;
    with.rest_length = 32;
    with.stiffness = k;
    with.damping = 2 * zeta * omega;
    SpringAndMass::build(world, with);
    const double damped = omega * std::sqrt(1 - zeta * zeta);
    double largest = 0;
    for (int step = 1; step <= 4 << K; ++step) {
        world.step(engine::BinaryStep<K>());
        const double t = std::ldexp(step, -K);
        const double x = std::exp(-zeta * omega * t) *
                         (std::cos(damped * t) + zeta * omega / damped * std::sin(damped * t));
        largest =
            std::max(largest, std::abs(std::as_const(world).particles()[0].position[0] - 32 - x));
    }
    return largest;
}
template <class Method, int K>
double damped_error() {
    return spring_error<Method, K>(5, 0.1, 25);
}

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

// Damping makes Verlet a method of first order, and the midpoint rule not.
TEST(Convergence, MidpointIsOfSecondOrderWithDamping) {
    expect_order<SpringAndMass, Midpoint>(2);
    const auto halved = [](auto method) {
        using Method = decltype(method);
        return damped_error<Method, 9>() / damped_error<Method, 10>();
    };
    EXPECT_NEAR(halved(Verlet()), 2, 0.2);
    EXPECT_NEAR(halved(Midpoint()), 4, 0.2);
}

// Verlet follows an undamped spring of frequency omega without an error if it has the stiffness m
// (2 sin(omega h / 2) / h)^2 in place of m omega^2: whatever the step, no method gains more.
TEST(Convergence, VerletIsExactWithTheStiffnessOfItsStep) {
    EXPECT_LT((spring_error<Verlet, 2>(5, 0, std::pow(8 * std::sin(5.0 / 8), 2))), 1e-12);
    EXPECT_LT((spring_error<Verlet, 2>(16, 0, std::pow(8 * std::sin(16.0 / 8), 2))), 1e-12);
    EXPECT_GT((spring_error<Verlet, 2>(5, 0, 25)), 0.5);
}

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
