// SPDX-License-Identifier: GPL-3.0-or-later
// The best split of each scene is the one with the most fraction bits that holds every number of
// the run in double, and no result of the run in that split overflows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bench/experiments/scenes/chip_run.hpp"

namespace scene_bench {
namespace {

constexpr int chip_exponents[] = {6, 8, 10};

class Split : public testing::TestWithParam<Scene> {
  protected:
    // The split runs with one method.
    const HostSubject& subject() const {
        const auto is_split = [&](const HostSubject& one) { return one.scalar == scene.split; };
        return *std::find_if(scene.subjects.begin(), scene.subjects.end(), is_split);
    }
    const Scene& scene = GetParam();
};

TEST_P(Split, HasTheFewestIntegerBitsThatHoldTheRunInDouble) {
    double largest = 0;
    for (const int exponent : chip_exponents)
        largest = std::max(
            largest,
            scene.find("double", subject().method)->run(exponent, Hashes::no).largest_number);
    const Layout layout = layout_of(scene.split);
    EXPECT_EQ(layout.bytes, 4);
    EXPECT_LT(largest, layout.range()) << scene.split;
    EXPECT_GE(largest, layout.range() / 2) << scene.split;
}

TEST_P(Split, HoldsEveryResultOfItsRun) {
    for (const int exponent : chip_exponents)
        EXPECT_EQ(subject().run(exponent, Hashes::no).failure, "") << "2^-" << exponent << " s";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Split, testing::ValuesIn(all_scenes()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace scene_bench
