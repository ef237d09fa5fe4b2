// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/blocks/limit_cycles.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using blocks::LimitCycle;

const std::vector<LimitCycle>& rows() {
    static const std::vector<LimitCycle> all = blocks::limit_cycles();
    return all;
}

TEST(LimitCycles, AreWithinTheirBounds) {
    ASSERT_FALSE(rows().empty());
    for (const LimitCycle& row : rows()) {
        SCOPED_TRACE(row.filter + " " + row.format + " " + std::to_string(row.time_constant));
        if (row.bound_ulp) EXPECT_LE(static_cast<double>(row.largest_ulp), *row.bound_ulp);
        if (row.filter != "one pole") continue;
        EXPECT_EQ(row.longest_period, 1u);
        // The largest distance that is rounded away is reached, from somewhere above it.
        if (!row.feedback) EXPECT_EQ(static_cast<double>(row.largest_ulp), *row.bound_ulp);
    }
}
// k = 1 - e^(-1/100) is 3/256 in Q8.8, and 42 k the last product below a half.
TEST(LimitCycles, OfAFirstOrderFilterWithoutFeedbackFollowFromItsCoefficient) {
    const auto row = std::find_if(rows().begin(), rows().end(), [](const LimitCycle& each) {
        return each.filter == "one pole" && each.format == "q8_8" && each.time_constant == 100 &&
               !each.feedback;
    });
    ASSERT_NE(row, rows().end());
    EXPECT_EQ(row->largest_ulp, 42u);
}
// Constant outputs y stay where y (1 + a1 + a2) is below a half; nothing less can be expected.
TEST(LimitCycles, OfSecondOrderFiltersWithoutFeedbackGrowAsTheSquareOfThePeriod) {
    std::uint64_t last = 0;
    for (const LimitCycle& row : rows()) {
        if (row.filter != "biquad" || row.format != "q8_24" || row.feedback) continue;
        if (row.time_constant > 10) EXPECT_GT(row.largest_ulp, 50 * last);
        last = row.largest_ulp;
    }
    EXPECT_GT(last, 1000u);
}

}  // namespace
