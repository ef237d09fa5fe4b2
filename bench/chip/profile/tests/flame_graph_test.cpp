// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/profile/flame_graph.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <string>

namespace profile {
namespace {

// Position and width of the bar of a name.
struct Bar {
    double x, y, width;
};
Bar bar(const std::string& svg, const std::string& name) {
    const std::regex pattern("<title>" + name +
                             ": [^<]*</title><rect x=\"([0-9.]+)\" y=\"([0-9.]+)\" "
                             "width=\"([0-9.]+)\"");
    std::smatch found;
    if (!std::regex_search(svg, found, pattern)) throw std::runtime_error("no bar of " + name);
    return {std::stod(found[1]), std::stod(found[2]), std::stod(found[3])};
}

Profile example() {
    Profile profile;
    profile.elapsed = 1000;
    profile.stacks = {{{"main"}, 100}, {{"main", "step<int>"}, 300}, {{"main", "wide"}, 600}};
    return profile;
}

TEST(FlameGraph, WidthsAreInclusiveCycles) {
    const std::string svg = flame_graph(example(), "x & y");
    const Bar all = bar(svg, "awake"), main = bar(svg, "main"), wide = bar(svg, "wide"),
              step = bar(svg, "step&lt;int&gt;");
    EXPECT_DOUBLE_EQ(main.width, all.width);
    EXPECT_NEAR(wide.width, 0.6 * all.width, 0.01);
    EXPECT_NEAR(step.width, 0.3 * all.width, 0.01);
    EXPECT_LT(main.y, all.y) << "callees stand upon their callers";
    EXPECT_LT(wide.y, main.y);
    EXPECT_DOUBLE_EQ(wide.x, main.x);
    EXPECT_NEAR(step.x, wide.x + wide.width, 0.02);
    EXPECT_NE(svg.find("x &amp; y"), std::string::npos);
    EXPECT_NE(svg.find("step&lt;int&gt;: 300 cycles (30.00%), 300 of its own"), std::string::npos);
}

TEST(FlameGraph, LeavesOutTheTimeAsleep) {
    Profile profile = example();
    profile.elapsed = 4000;
    profile.stacks.push_back({{"main", "(asleep)"}, 3000});
    const std::string svg = flame_graph(profile, "x");
    EXPECT_NE(svg.find("awake for 1000 cycles, 25.00% of the time"), std::string::npos);
    EXPECT_EQ(svg.find("(asleep)"), std::string::npos);
    EXPECT_NEAR(bar(svg, "wide").width, 0.6 * bar(svg, "awake").width, 0.01);
}

TEST(FlameGraph, AnEmptyProfileIsStillADocument) {
    const std::string svg = flame_graph(Profile{}, "empty");
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace profile
