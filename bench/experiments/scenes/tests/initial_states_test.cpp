// SPDX-License-Identifier: GPL-3.0-or-later
// Errors from several starts: the spread of known numbers; starts that differ and are the same in
// every run; and errors that follow from the order of the method.
#include "bench/experiments/scenes/initial_states.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace scene_bench {
namespace {

TEST(SpreadOfErrors, IsSmallestMedianAndLargest) {
    EXPECT_FALSE(spread({}));
    const auto one = spread({3});
    EXPECT_EQ(one->smallest, 3);
    EXPECT_EQ(one->median, 3);
    EXPECT_EQ(one->largest, 3);
    const auto odd = spread({9, 1, 4});
    EXPECT_EQ(odd->smallest, 1);
    EXPECT_EQ(odd->median, 4);
    EXPECT_EQ(odd->largest, 9);
    EXPECT_EQ(spread({8, 2, 4, 100})->median, 6);
}

const StateSubject& subject(const std::string& scene, const std::string& scalar,
                            const std::string& method) {
    for (const SceneStates& of : scene_states())
        for (const StateSubject& one : of.subjects)
            if (of.scene == scene && one.scalar == scalar && one.method == method) return one;
    throw std::logic_error("no such run");
}

TEST(InitialStates, DifferBySeedAndAreTheSameForIt) {
    for (const SceneStates& of : scene_states()) {
        const StateSubject& one = subject(of.scene, "q32_32", "semi_implicit_euler");
        std::set<double> errors;
        unsigned held = 0;
        for (unsigned seed = 1; seed <= initial_states; ++seed) {
            const auto error = one.error(seed, 6);
            EXPECT_EQ(error, one.error(seed, 6)) << of.scene << ' ' << seed;
            if (!error) continue;
            ++held;
            errors.insert(*error);
        }
        EXPECT_EQ(held, initial_states) << of.scene;
        // In free fall the method has the same error from every start.
        EXPECT_GT(errors.size(), initial_states / 2) << of.scene;
    }
}

// From every start with a step 16 times as short: the error of a first-order method falls to a
// 16th, that of a second-order method to a 256th.
TEST(InitialStates, ErrorsFallByTheOrderOfTheMethod) {
    for (const char* scene : {"pendulum", "spring_and_mass"}) {
        for (unsigned seed = 1; seed <= initial_states; ++seed) {
            const auto ratio = [&](const char* method) {
                const StateSubject& one = subject(scene, "q32_32", method);
                return one.error(seed, 6).value() / one.error(seed, 10).value();
            };
            EXPECT_NEAR(ratio("semi_implicit_euler"), 16, 4) << scene << ' ' << seed;
            EXPECT_NEAR(ratio("velocity_verlet"), 256, 64) << scene << ' ' << seed;
        }
    }
}

// The scenes' best split, and compensated integration where rounding is the whole error.
TEST(InitialStates, SplitsAndCompensatedIntegrationRunToo) {
    const auto error = [](const char* scalar, const char* arithmetic, unsigned seed) {
        for (const SceneStates& of : scene_states())
            for (const StateSubject& one : of.subjects)
                if (of.scene == "free_fall" && one.scalar == scalar &&
                    one.arithmetic == arithmetic && one.method == "velocity_verlet")
                    return one.error(seed, 10).value();
        throw std::logic_error("no such run");
    };
    for (unsigned seed = 1; seed <= initial_states; ++seed) {
        EXPECT_LT(error("q6_26", "nearest", seed), error("q8_24", "nearest", seed)) << seed;
        EXPECT_LT(10 * error("q16_16", "compensated", seed), error("q16_16", "nearest", seed))
            << seed;
        EXPECT_LT(error("q8_8", "compensated", seed), 0x1p-6) << seed;
    }
}

}  // namespace
}  // namespace scene_bench
