// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/blocks/limit_cycles.hpp"

#include <gtest/gtest.h>

namespace {

using blocks::LimitCycle;

const std::vector<LimitCycle>& rows() {
    static const std::vector<LimitCycle> all = blocks::limit_cycles();
    return all;
}

TEST(LimitCycles, AreWithinTheirBounds) {
    for (const LimitCycle& row : rows()) {
        SCOPED_TRACE(row.filter + " " + row.format + " " + std::to_string(row.time_constant));
        const bool feedback = row.feedback == "yes";
        if (row.bound_ulp) EXPECT_LE(static_cast<double>(row.largest_ulp), *row.bound_ulp);
        if (row.filter != "one pole") continue;
        EXPECT_EQ(row.longest_period, 1u);
        // The largest distance that is rounded away is reached, from somewhere above it.
        if (!feedback) EXPECT_EQ(static_cast<double>(row.largest_ulp), *row.bound_ulp);
    }
}
// k = 1 - e^(-1/100) is 3/256 in Q8.8, and 42 k the last product below a half.
TEST(LimitCycles, OfAFirstOrderFilterWithoutFeedbackFollowFromItsCoefficient) {
    for (const LimitCycle& row : rows()) {
        if (row.filter == "one pole" && row.format == "q8_8" && row.time_constant == 100 &&
            row.feedback == "no")
            EXPECT_EQ(row.largest_ulp, 42u);
    }
}
// Constant outputs y stay where y (1 + a1 + a2) is below a half; nothing less can be expected.
TEST(LimitCycles, OfSecondOrderFiltersWithoutFeedbackGrowAsTheSquareOfThePeriod) {
    std::uint64_t last = 0;
    for (const LimitCycle& row : rows()) {
        if (row.filter != "biquad" || row.format != "q8_24" || row.feedback == "yes") continue;
        if (row.time_constant > 10) EXPECT_GT(row.largest_ulp, 50 * last);
        last = row.largest_ulp;
    }
    EXPECT_GT(last, 1000u);
}

}  // namespace
