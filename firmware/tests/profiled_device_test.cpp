// SPDX-License-Identifier: GPL-3.0-or-later
// The profiling pins of the levers as they are flashed, in the closed loop.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "bench/experiments/haptic/haptic.hpp"
#include "this_build.hpp"

namespace {

using namespace haptic;

enum Pin : int { step = 2, render, collision, square_root, operation };

// How often each pin rose in a second, how long it was high in total, in s, and how often it rose
// outside a step.
struct Use {
    std::map<int, int> rises, outside_of_steps;
    std::map<int, double> high;
};
Use use_of(const char* program) {
    DeviceLoop loop(simulator::Elf(build_folder() / "firmware" / (program + std::string(".elf"))),
                    published_parameters(), scenario("push_and_hold").script);
    loop.run_until(0.5);
    std::vector<PinEdge> edges;
    loop.record_edges(edges);
    loop.run_until(1.5);
    Use use;
    std::map<int, Cycle> since;
    bool stepping = false;
    for (const PinEdge& edge : edges) {
        if (edge.pin == step) stepping = edge.level;
        if (edge.level) {
            ++use.rises[edge.pin];
            if (!stepping) ++use.outside_of_steps[edge.pin];
            since[edge.pin] = edge.at;
        } else if (since.count(edge.pin)) {
            use.high[edge.pin] += seconds_of(edge.at - since[edge.pin]);
        }
    }
    return use;
}

class ProfiledLever : public testing::TestWithParam<const char*> {};

TEST_P(ProfiledLever, RaisesEachPinWhereItsCategoryRuns) {
    Use use = use_of(GetParam());
    const int steps = use.rises[step];
    ASSERT_GT(steps, 50);
    EXPECT_GT(use.rises[render], 19);
    EXPECT_NEAR(use.rises[collision], 2 * steps, 2) << "contacts are found, then resolved";
    // The length of the one rod: by products in an arithmetic that rounds.
    const bool has_root = GetParam() == std::string("lever_published_profiled");
    EXPECT_NEAR(use.rises[square_root], has_root ? steps : 0, 2);
    EXPECT_GT(use.rises[operation], 20 * steps);
    EXPECT_LE(use.outside_of_steps[collision], 2);  // from a step under way at the start
    EXPECT_LE(use.outside_of_steps[square_root], 1);
    EXPECT_LT(use.high[square_root], use.high[collision]);
    EXPECT_LT(use.high[collision], use.high[step]);
}
INSTANTIATE_TEST_SUITE_P(All, ProfiledLever,
                         testing::Values("lever_profiled", "lever_published_profiled"),
                         [](const auto& info) { return std::string(info.param); });

// An inlined product is computed while its pin is high, neither before nor after: over 300 cycles
// in the published arithmetic.
TEST(ProfiledOperations, AreHighForAsLongAsTheyTake) {
    Use use = use_of("lever_published_profiled");
    EXPECT_GT(use.high[operation] / use.rises[operation], 18e-6);
    EXPECT_LT(use.high[operation] / use.rises[operation], 60e-6);
}

TEST(Lever, RaisesOnlyThePinsOfStepAndFrame) {
    Use use = use_of("lever");
    EXPECT_GT(use.rises[step], 1000);
    EXPECT_GT(use.rises[render], 19);
    for (const int pin : {collision, square_root, operation}) EXPECT_EQ(use.rises[pin], 0) << pin;
}

}  // namespace
