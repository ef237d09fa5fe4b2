// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/cost/growth/fit.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace growth {
namespace {

std::vector<Cost> points(double a, double b, double c) {
    std::vector<Cost> costs;
    for (unsigned n = 2; n <= 1024; n *= 2)
        costs.push_back({"brute_force", n, a + b * n + c * n * n});
    return costs;
}

TEST(Fit, finds_the_polynomial_that_the_points_lie_on) {
    const Fit fit = fitted(points(300, 25, 0.5), squares);
    EXPECT_NEAR(fit.a, 300, 1e-6);
    EXPECT_NEAR(fit.b, 25, 1e-6);
    EXPECT_NEAR(fit.c, 0.5, 1e-9);
    EXPECT_LT(fit.worst, 1e-9);
}
TEST(Fit, has_the_terms_of_its_name) {
    EXPECT_DOUBLE_EQ(squares.value(9), 81);
    EXPECT_DOUBLE_EQ(strips.value(9), 27);
    EXPECT_DOUBLE_EQ(trees.value(8), 24);
}
TEST(Fit, says_how_far_off_a_point_is) {
    auto costs = points(300, 25, 0.5);
    costs[4].per_step *= 1.5;
    EXPECT_GT(fitted(costs, squares).worst, 0.05);
}
TEST(Fit, needs_four_points) {
    auto costs = points(1, 1, 1);
    costs.resize(3);
    EXPECT_THROW(fitted(costs, squares), std::runtime_error);
}
TEST(Crossing, is_where_the_second_stays_the_cheaper) {
    const auto quadratic = points(0, 10, 1), linear = points(100, 20, 0);
    // 10 N + N^2 against 100 + 20 N: 96 and 260 at 8 ... 416 and 420 at 16, 1344 and 740 at 32.
    EXPECT_EQ(crossing(quadratic, linear), 32u);
    EXPECT_EQ(crossing(linear, quadratic), std::nullopt);
    // Of equal costs none is the dearer one.
    EXPECT_EQ(crossing(linear, linear), 2u);
}

}  // namespace
}  // namespace growth
