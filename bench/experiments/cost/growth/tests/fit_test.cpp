// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/cost/growth/fit.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace growth {
namespace {

std::vector<Sample> samples(double a, double b, double c) {
    std::vector<Sample> list;
    for (double n = 2; n <= 1024; n *= 2) list.push_back({n, n * n, a + b * n + c * n * n});
    return list;
}

TEST(Fit, finds_the_polynomial_that_the_samples_lie_on) {
    const Fit fit = fitted(samples(300, 25, 0.5));
    EXPECT_NEAR(fit.a, 300, 1e-6);
    EXPECT_NEAR(fit.b, 25, 1e-6);
    EXPECT_NEAR(fit.c, 0.5, 1e-9);
    EXPECT_LT(fit.worst, 1e-9);
    EXPECT_NEAR(fit({10, 8, 0}), 554, 1e-5);
}
TEST(Fit, says_how_far_off_a_sample_is) {
    auto list = samples(300, 25, 0.5);
    list[4].value *= 1.5;
    EXPECT_GT(fitted(list).worst, 0.05);
}
TEST(Fit, needs_four_samples) {
    auto list = samples(1, 1, 1);
    list.resize(3);
    EXPECT_THROW(fitted(list), std::runtime_error);
}

std::vector<Cost> points(double a, double b, double c) {
    std::vector<Cost> costs;
    for (const Sample& sample : samples(a, b, c))
        costs.push_back({"brute_force", static_cast<unsigned>(sample.particles), sample.value});
    return costs;
}
TEST(Crossing, is_where_the_second_stays_cheaper) {
    const auto quadratic = points(0, 10, 1), linear = points(100, 20, 0);
    // 10 N + N^2 against 100 + 20 N: 96 and 260 at 8 ... 416 and 420 at 16, 1344 and 740 at 32.
    EXPECT_EQ(crossing(quadratic, linear), 32u);
    EXPECT_EQ(crossing(linear, quadratic), std::nullopt);
    // If costs are equal, neither is more expensive.
    EXPECT_EQ(crossing(linear, linear), 2u);
}

}  // namespace
}  // namespace growth
