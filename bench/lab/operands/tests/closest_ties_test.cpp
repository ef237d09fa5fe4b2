// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/operands/closest_ties.hpp"

#include <gtest/gtest.h>

#include "reference/function.hpp"

namespace operands {
namespace {

using reference::Operation;

__extension__ typedef __float128 Real;

// In ulp of Q16.16.
Real distance_from_a_tie(Operation operation, const std::vector<std::int64_t>& raws) {
    const Real a = Real(raws[0]) / 65536;
    const Real result =
        65536 * (operation == Operation::sin     ? sinf128(a)
                 : operation == Operation::cos   ? cosf128(a)
                 : operation == Operation::exp   ? expf128(a)
                 : operation == Operation::log   ? logf128(a)
                 : operation == Operation::atan2 ? atan2f128(a, Real(raws[1]) / 65536)
                                                 : atanf128(a));
    const Real half = result - Real(static_cast<std::int64_t>(result));
    const Real distance = (half < 0 ? -half : half) - Real(0.5);
    return distance < 0 ? -distance : distance;
}

TEST(ClosestTies, AreCloserThanAnyRandomOperandMayBe) {
    using enum Operation;
    for (const Operation operation : {sin, cos, atan, exp, log, atan2}) {
        const auto cases =
            closest_ties({operation, reference::q16_16, reference::Arithmetic::correctly_rounded});
        ASSERT_GE(cases.size(), 60u);
        for (const BoundaryCase& each : cases)
            EXPECT_LT(distance_from_a_tie(operation, each.operands),
                      operation == exp ? Real(0x1p-15) : Real(0x1p-25))
                << each.operands[0];
    }
}

TEST(ClosestTies, BelongOnlyToCorrectRounding) {
    EXPECT_TRUE(
        closest_ties({Operation::sin, reference::q16_16, reference::Arithmetic::nearest}).empty());
    EXPECT_TRUE(closest_ties({Operation::reciprocal_sqrt, reference::q16_16,
                              reference::Arithmetic::correctly_rounded})
                    .empty());
}

}  // namespace
}  // namespace operands
