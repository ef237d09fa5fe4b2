// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/operands/search.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <span>

namespace operands {
namespace {

using Operands = std::span<const std::int64_t>;
constexpr auto multiply = reference::Operation::multiply;

// The number of bits in which the operands agree with a pair that no start hits.
double agreement(Operands x) {
    const auto matching = [](std::int64_t a, std::uint32_t b) {
        return 32 - std::popcount(std::uint32_t(a) ^ b);
    };
    return matching(x[0], 0x9e3779b9) + matching(x[1], 0x3c6ef372);
}

TEST(Search, ClimbsToTheTopOfASmoothHill) {
    const Worst worst = search_worst(multiply, reference::q16_16, 20000, 1, agreement);
    EXPECT_EQ(worst.value, 64);
    EXPECT_EQ(std::uint32_t(worst.operands[0]), 0x9e3779b9);
    EXPECT_EQ(std::uint32_t(worst.operands[1]), 0x3c6ef372);
}

TEST(Search, RestartsLeaveALocalMaximum) {
    // A broad hill at 0 and a higher, narrow one at MIN.
    const auto objective = [](Operands x) {
        return x[0] < -30000 ? 1000.0 - double(x[0] + 32768) : -double(std::abs(x[0]));
    };
    const Worst worst =
        search_worst(reference::Operation::negate, reference::q8_8, 50000, 1, objective);
    EXPECT_EQ(worst.operands[0], -32768);
}

TEST(Search, KeepsItsBudgetAndRepeats) {
    int calls = 0;
    const auto counted = [&](Operands x) {
        ++calls;
        return agreement(x);
    };
    const Worst first = search_worst(multiply, reference::q16_16, 500, 3, counted);
    EXPECT_EQ(calls, 500);
    EXPECT_EQ(agreement(first.operands), first.value);
    EXPECT_EQ(search_worst(multiply, reference::q16_16, 500, 3, counted).operands, first.operands);
    EXPECT_NE(search_worst(multiply, reference::q16_16, 500, 4, counted).operands, first.operands);
}

}  // namespace
}  // namespace operands
