// SPDX-License-Identifier: MIT
// Recorded numbers compute as the wrapped number does, and record every range by name and line.
#include <fixedpoint.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fixedpoint/host/recorded.hpp>

namespace fixedpoint {
namespace {

using namespace literals;

class RecordedTest : public testing::Test {
  protected:
    RecordedTest() { recording() = Recording(); }
    static const Range& line(int number) { return recording().lines.at({__FILE__, number}); }
};

// Every multiple of 1/64 in -20..20 against the definition of a format's range and rounding.
TEST_F(RecordedTest, OverflowAndUnderflowAreThoseOfTheFormat) {
    for (int integer_bits = 1; integer_bits <= 6; ++integer_bits)
        for (int fraction_bits = 0; fraction_bits <= 5; ++fraction_bits)
            for (int i = -20 * 64; i <= 20 * 64; ++i) {
                const double x = i / 64.0, limit = std::ldexp(1.0, integer_bits - 1);
                Range range;
                range.add(x);
                ASSERT_EQ(range.overflows(integer_bits), x < -limit || x >= limit)
                    << x << " in " << integer_bits;
                ASSERT_EQ(range.underflows(fraction_bits),
                          x != 0 && std::floor(std::ldexp(x, fraction_bits) + 0.5) == 0)
                    << x << " in " << fraction_bits;
                ASSERT_EQ(range.overflows(range.integer_bits()), 0u) << x;
                if (range.integer_bits() > 1) {
                    ASSERT_EQ(range.overflows(range.integer_bits() - 1), 1u) << x;
                }
            }
}

TEST_F(RecordedTest, RangesHoldTheirExtremes) {
    Range range;
    EXPECT_EQ(range.integer_bits(), 1);
    for (const double x : {0.0, -3.0, 0.25, 2.5, -0.125}) range.add(x);
    EXPECT_EQ(range.count(), 5u);
    EXPECT_EQ(range.least(), -3);
    EXPECT_EQ(range.greatest(), 2.5);
    EXPECT_EQ(range.smallest(), 0.125);
    EXPECT_EQ(range.integer_bits(), 3);
    range.add(INFINITY);
    range.add(NAN);
    EXPECT_EQ(range.overflows(64), 2u);
}

template <class Number>
Number generic(Number a, Number b) {
    Number sum = a + b;
    sum *= -b - a;
    return watch(sqrt(watch(sum / b, "ratio")), "root");
}

TEST_F(RecordedTest, LinesAndNamesAreTold) {
    constexpr int first = __LINE__ - 6;
    const auto root = generic(Recorded<double>(2), Recorded<double>(-6));
    EXPECT_EQ(root.value(), std::sqrt((2.0 - 6) * (6.0 - 2) / -6));
    EXPECT_EQ(line(first).least(), -4);
    EXPECT_EQ(line(first).count(), 1u);
    EXPECT_EQ(line(first + 1).count(), 3u);  // a sign, a difference, a product
    EXPECT_EQ(line(first + 1).least(), -16);
    EXPECT_EQ(line(first + 1).greatest(), 6);
    EXPECT_EQ(line(first + 2).count(), 2u);
    EXPECT_EQ(recording().variables.at("ratio").greatest(), 16.0 / 6);
    EXPECT_EQ(recording().variables.at("root").greatest(), root.value());
    const std::map<std::string, std::uint64_t> operations = {
        {"add", 1}, {"divide", 1}, {"multiply", 1}, {"negate", 1}, {"sqrt", 1}, {"subtract", 1}};
    EXPECT_EQ(recording().operations, operations);
}

// The wrapped result is that of the format; the recorded one is exact.
TEST_F(RecordedTest, AFormatIsToldOfWhatItLoses) {
    const Recorded<Q8_8> large(100_q8_8), small(0.05_q8_8);
    EXPECT_EQ((large + large).value(), 100_q8_8 + 100_q8_8);  // wrapped
    const int sum = __LINE__ - 1;
    EXPECT_EQ(line(sum).greatest(), 200);
    EXPECT_EQ(line(sum).overflows(8), 1u);
    EXPECT_EQ((small * small).value(), 0.05_q8_8 * 0.05_q8_8);
    const int product = __LINE__ - 1;
    EXPECT_EQ(line(product).greatest(), std::pow(13 / 256.0, 2));
    EXPECT_EQ(multiply_add(small, large, large).value(),
              multiply_add(0.05_q8_8, 100_q8_8, 100_q8_8));
    EXPECT_EQ(atan2(small, large).value(), atan2(0.05_q8_8, 100_q8_8));
    EXPECT_EQ(max(small, -large).value(), 0.05_q8_8);
    EXPECT_EQ(clamp(large, -small, small).value(), 0.05_q8_8);
    EXPECT_TRUE(small < large && large >= small && small != large);
}

TEST_F(RecordedTest, WatchIsTheNumberItself) {
    constexpr Q16_16 one = watch(1_q16_16, "one");
    EXPECT_EQ(one, 1_q16_16);
    EXPECT_TRUE(recording().variables.empty());
}

}  // namespace
}  // namespace fixedpoint
