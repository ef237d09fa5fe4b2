// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/plant/script.hpp"

#include <gtest/gtest.h>

namespace haptic {
namespace {

TEST(Signal, IsConstantOutsideAndLinearBetween) {
    const Signal signal = Signal(1).ramp(2, 4, 5).step(6, -1);
    EXPECT_EQ(signal.at(-1), 1);
    EXPECT_EQ(signal.at(0), 1);
    EXPECT_EQ(signal.at(2), 1);
    EXPECT_EQ(signal.at(3), 3);
    EXPECT_EQ(signal.at(5.999), 5);
    EXPECT_EQ(signal.at(6), -1);
    EXPECT_EQ(signal.at(1e9), -1);
}

TEST(Signal, RefusesToGoBackInTime) {
    EXPECT_THROW(Signal(0).step(2, 1).step(1, 0), std::invalid_argument);
    EXPECT_THROW(Signal(0).ramp(2, 1, 1), std::invalid_argument);
}

}  // namespace
}  // namespace haptic
