// SPDX-License-Identifier: MIT
// The error that a format's arithmetic adds to that of a method.
#include "runs.hpp"

using namespace scenes;
using engine::Fixed;

namespace {

template <class Scene, class Number>
double distance_to_double() {
    return runs::largest_distance(runs::run<Scene, SemiImplicit, Number, 8>(),
                                  runs::run<Scene, SemiImplicit, double, 8>());
}

// The bounds in m: what an error of one last bit per step amounts to over the scene's duration.
// Every scene fits Q8.16, which has the last bit of Q16.16.
template <class Scene>
void expect_near_double(double q16_16, double q8_24) {
    const double coarse = distance_to_double<Scene, Fixed<16, 16>>();
    const double narrow = distance_to_double<Scene, Fixed<8, 16>>();
    const double fine = distance_to_double<Scene, Fixed<8, 24>>();
    EXPECT_LT(coarse, q16_16) << Scene::name << " in Q16.16";
    EXPECT_LT(narrow, q16_16) << Scene::name << " in Q8.16";
    EXPECT_LT(fine, q8_24) << Scene::name << " in Q8.24";
}

}  // namespace

// A velocity that is off by half a last bit in every step is off by 2^-17 * 256 * 2 m/s at the end.
TEST(Format, ErrorOfTheArithmeticIsBounded) {
    expect_near_double<FreeFall>(5e-3, 2e-5);
    expect_near_double<BouncingBall>(2e-3, 8e-6);
    expect_near_double<SpringAndMass>(2e-3, 2e-5);
    expect_near_double<Pendulum>(2e-3, 8e-6);
    expect_near_double<DoublePendulum>(5e-3, 3e-5);
    expect_near_double<TwoBodyCollision>(5e-3, 3e-5);
    expect_near_double<NewtonsCradle>(5e-3, 1e-4);
    expect_near_double<ChainOfRods>(6e-3, 3e-5);
    expect_near_double<Stack>(5e-4, 2e-6);
    expect_near_double<ProjectileWithDrag>(5e-4, 2e-6);
    expect_near_double<Lever>(4e-3, 2e-5);
    expect_near_double<PublishedLever>(5e-4, 5e-6);
}

// The step that finds the rope taut depends on the last bit, so that runs differ by the motion of
// one step.
TEST(Format, RopeMayBeTautAStepLater) { expect_near_double<RopeSwing>(0.06, 0.06); }

// Q8.24 has 8 fraction bits more than Q16.16, and uses them.
TEST(Format, MoreFractionBitsAreMoreAccurate) {
    EXPECT_LT((50 * distance_to_double<Pendulum, Fixed<8, 24>>()),
              (distance_to_double<Pendulum, Fixed<16, 16>>()));
    EXPECT_LT((50 * distance_to_double<Pendulum, Fixed<32, 32>>()),
              (distance_to_double<Pendulum, Fixed<8, 24>>()));
}
