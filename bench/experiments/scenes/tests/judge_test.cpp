// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/scenes/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace scene_bench {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

Trajectory along_x(std::initializer_list<double> places) {
    Trajectory trajectory;
    for (const double x : places) trajectory.push_back({{{x, 0, 0}, {}}});
    return trajectory;
}

TEST(LargestDistance, IsTheLargestAfterTheStart) {
    EXPECT_EQ(largest_distance(along_x({9, 1, 2}), along_x({0, 1.5, 2.25})), 0.5);
    const Trajectory near = {{{{0, 0, 0}, {}}}, {{{3, 4, 0}, {}}, {{0, 0, 1}, {}}}};
    const Trajectory far = {{{{0, 0, 0}, {}}}, {{{0, 0, 0}, {}}, {{0, 0, 8}, {}}}};
    EXPECT_EQ(largest_distance(near, far), 7);
}

TEST(LargestDistance, OfNumbersThatAreNotFiniteIsNone) {
    EXPECT_TRUE(std::isnan(largest_distance(along_x({0, none, 1}), along_x({0, 0, 0}))));
    EXPECT_TRUE(std::isnan(largest_distance(along_x({0}), along_x({0}))));
    EXPECT_TRUE(std::isnan(largest_distance({}, along_x({0, 1}))));
}

TEST(Extent, IsTheDiagonal) {
    const Trajectory trajectory = {{{{0, 0, 0}, {}}, {{3, 0, 0}, {}}}, {{{0, -4, 0}, {}}}};
    EXPECT_EQ(extent(trajectory), 5);
}

TEST(EnergyDrift, IsAgainstTheTruthsLargestKineticEnergy) {
    // 1 kg under 9.81 m/s^2: the truth falls one metre to 2 m/s, 2 J; the run has that speed
    // without the fall, 9.81 J too much.
    const Trajectory truth = {{{{0, 20, 0}, {}}}, {{{0, 19, 0}, {0, -2, 0}}}};
    Trajectory run = truth;
    EXPECT_EQ(energy_drift("free_fall", run, truth), 0);
    run[1][0].position[1] = 20;
    EXPECT_NEAR(energy_drift("free_fall", run, truth), 9.81 / 2, 1e-12);
    // Without a truth: against the start, which has 0.5 J.
    run[0][0].velocity = {1, 0, 0};
    run[1][0].velocity = {2, 0, 0};
    EXPECT_NEAR(energy_drift("free_fall", run, {}), 3, 1e-12);
}

class Verdict : public testing::Test {
  protected:
    std::string of(const Trajectory& trajectory, double error, double error_method,
                   double needed_range) {
        run_.trajectory = trajectory;
        return verdict({scene_, run_, error, error_method, 10, 128, needed_range});
    }
    static double rod_error(const State& state) { return state[0].position[0]; }

    Scene scene_{.name = "test", .rod_error = [](const State&) { return 0.0; }};
    scene_bench::Run run_;
};

TEST_F(Verdict, HeldWithinTheSizeOfTheScene) {
    EXPECT_EQ(of(along_x({0, 0}), 9.9, 0, 200), "held");
    EXPECT_EQ(of(along_x({0, 0}), none, none, 0), "held");  // no truth to compare with
}
TEST_F(Verdict, BeyondTheSize) {
    EXPECT_EQ(of(along_x({0, 0}), 10.1, 0, 127),
              "failed: error beyond the size of the scene (10 m)");
}
TEST_F(Verdict, Overflow) {
    EXPECT_EQ(of(along_x({0, 0}), 10.1, 0, 200),
              "failed: overflow: numbers up to 200 where the format ends at 128");
}
TEST_F(Verdict, TheMethodItself) {
    EXPECT_EQ(of(along_x({0, 0}), 300, 250, 200),
              "failed: the method itself errs by 2.5e+02 m at this step");
}
TEST_F(Verdict, TheEnginesOwnError) {
    run_.failure = "more contacts in a step than the scene states";
    EXPECT_EQ(of(along_x({0, 0}), 0, 0, 0),
              "failed: more contacts in a step than the scene states");
}
// Each threshold may be reached; a number at the format's end does not fit.
TEST_F(Verdict, AtItsThresholds) {
    EXPECT_EQ(of(along_x({0, 0}), 10, 0, 200), "held");
    EXPECT_EQ(of(along_x({0, 0}), 10.1, 10, 127),
              "failed: error beyond the size of the scene (10 m)");
    EXPECT_EQ(of(along_x({0, 0}), 10.1, 0, 128),
              "failed: overflow: numbers up to 128 where the format ends at 128");
    EXPECT_EQ(of(along_x({0, 0}), 10.1, none, std::nextafter(128.0, 0)),
              "failed: error beyond the size of the scene (10 m)");
    scene_.rod_error = rod_error;
    EXPECT_EQ(of(along_x({0, 0.1}), 0, 0, 0), "held");
    EXPECT_EQ(of(along_x({0, std::nextafter(0.1, 1)}), 0, 0, 0),
              "failed: a rod is 10% off its length");
    // The worst rod counts, whenever it occurred, and is reported separately from its cause.
    EXPECT_EQ(of(along_x({0, 0.5, 0.2, 0}), 0, 0, 0), "failed: a rod is 50% off its length");
    EXPECT_EQ(of(along_x({0, 0.5}), 0, 11, 0).substr(0, 19), "failed: the method ");
    EXPECT_EQ(of(along_x({0, 0.5}), 0, 0, 128).substr(0, 16), "failed: overflow");
}

TEST_F(Verdict, ALostRodButNotAtTheStart) {
    scene_.rod_error = rod_error;
    EXPECT_EQ(of(along_x({0.5, 0.09}), 0, 0, 0), "held");
    EXPECT_EQ(of(along_x({0, 0.25}), 0, 0, 0), "failed: a rod is 25% off its length");
    EXPECT_EQ(of(along_x({0, none}), 0, 0, 0).substr(0, 6), "failed");
}

}  // namespace
}  // namespace scene_bench
