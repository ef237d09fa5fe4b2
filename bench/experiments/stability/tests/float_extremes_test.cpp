// SPDX-License-Identifier: GPL-3.0-or-later
// The device's float at its extremes: the classes of operands, and the differences from the host's.
#include "bench/experiments/stability/float_extremes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace stability {
namespace {

TEST(FloatClasses, AreByTheFirstThatApplies) {
    constexpr float infinity = std::numeric_limits<float>::infinity(), none = NAN;
    EXPECT_EQ(class_of(1, none, none), "nan operand");
    EXPECT_EQ(class_of(-infinity, 0x1p-149f, infinity), "infinite operand");
    EXPECT_EQ(class_of(0x1p-127f, 1, 1), "subnormal operand");
    EXPECT_EQ(class_of(0x1p-126f, 1, 1), "normal");
    EXPECT_EQ(class_of(0, 0, none), "result is nan");
    EXPECT_EQ(class_of(1, 0, infinity), "result is infinite");
    EXPECT_EQ(class_of(0x1p-75f, 0x1p-74f, 0x1p-149f), "result is subnormal");
    EXPECT_EQ(class_of(0, 1, -0.0f), "result is zero");
}

// avr-libc rounds some subnormal quotients wrongly: (1 + 2^-23) 2^-126 / 2^24 is above half of the
// smallest subnormal, which is the nearest float. Everything else follows IEEE 754.
TEST(DeviceFloat, DiffersFromIeeeInSubnormalQuotientsAlone) {
    std::set<std::string> operations;
    for (const FloatRow& row : compare_floats()) {
        operations.insert(row.operation);
        EXPECT_GT(row.pairs, 0u);
        if (row.operation == "divide" && row.operands == "result is subnormal") {
            EXPECT_GT(row.differ, 0u);
            EXPECT_LT(row.differ, row.pairs / 10);
            EXPECT_EQ(row.host + ' ' + row.device, "0x1p-149 0x0p+0");
        } else {
            EXPECT_EQ(row.differ, 0u)
                << row.operation << ", " << row.operands << ": " << row.first_mismatch << ": "
                << row.host << ", " << row.device;
        }
    }
    EXPECT_EQ(operations.size(), 7u);
}

}  // namespace
}  // namespace stability
