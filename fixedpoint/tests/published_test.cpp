// SPDX-License-Identifier: MIT
// The published arithmetic against plain definitions in 128-bit integers, and the defects corrected
// in it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <fixedpoint/published/atan2.hpp>
#include <fixedpoint/published/divide.hpp>
#include <fixedpoint/published/from_decimal.hpp>
#include <fixedpoint/published/multiply.hpp>
#include <fixedpoint/published/sqrt.hpp>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace {

namespace published = fixedpoint::published;
__extension__ using Wide = __int128;

// The low bits of the quotient truncated toward zero: C's own division of wide integers.
template <class Raw>
Raw truncated(Wide numerator, Wide denominator) {
    return static_cast<Raw>(numerator / denominator);
}

template <class Raw>
std::vector<Raw> operands(int count) {
    using Limits = std::numeric_limits<Raw>;
    std::vector<Raw> values{0,
                            1,
                            -1,
                            2,
                            -2,
                            3,
                            Limits::max(),
                            Limits::min(),
                            static_cast<Raw>(Limits::max() - 1),
                            static_cast<Raw>(Limits::min() + 1)};
    std::mt19937_64 random(32);
    for (int i = 0; i < count; ++i) {
        // Operands of every magnitude.
        values.push_back(static_cast<Raw>(static_cast<std::int64_t>(random()) >> (random() % 64)));
    }
    return values;
}

template <class Raw, int F>
void check_multiply_and_divide(const std::vector<Raw>& values) {
    const Wide one = Wide(1) << F;
    for (const Raw a : values) {
        for (const Raw b : values) {
            ASSERT_EQ((published::multiply<Raw, F>(a, b)), truncated<Raw>(Wide(a) * b, one))
                << +a << " * " << +b;
            if (b != 0) {
                ASSERT_EQ((published::divide<Raw, F>(a, b)), truncated<Raw>(Wide(a) * one, b))
                    << +a << " / " << +b;
            }
        }
    }
}

TEST(Published, MultiplyAndDivideTruncateTowardZeroModuloTheWidth) {
    std::vector<std::int8_t> all;
    for (int a = -128; a < 128; ++a) all.push_back(static_cast<std::int8_t>(a));
    check_multiply_and_divide<std::int8_t, 4>(all);
    check_multiply_and_divide<std::int16_t, 8>(operands<std::int16_t>(300));
    check_multiply_and_divide<std::int32_t, 16>(operands<std::int32_t>(300));
    check_multiply_and_divide<std::int64_t, 32>(operands<std::int64_t>(300));
    check_multiply_and_divide<std::int64_t, 0>(operands<std::int64_t>(100));
    check_multiply_and_divide<std::int32_t, 24>(operands<std::int32_t>(100));
}

TEST(Published, DivisionByZeroHasAResult) {
    EXPECT_EQ((published::divide<std::int32_t, 16>(5, 0)), INT32_MAX);
    EXPECT_EQ((published::divide<std::int32_t, 16>(-5, 0)), INT32_MIN);
    EXPECT_EQ((published::divide<std::int32_t, 16>(0, 0)), 0);
    EXPECT_EQ((published::divide<std::int64_t, 32>(5, 0)), INT64_MAX);
}

template <class Raw, int F>
void check_sqrt(const std::vector<Raw>& values) {
    for (const Raw a : values) {
        const Wide root = published::sqrt<Raw, F>(a);
        if (a < 0) {
            ASSERT_EQ(root, 0);
        } else {
            const Wide radicand = Wide(a) << F;
            ASSERT_TRUE(root * root <= radicand && radicand < (root + 1) * (root + 1)) << +a;
        }
    }
}

TEST(Published, SquareRootIsTheFloorAndOfANegativeZero) {
    std::vector<std::int16_t> all;
    for (int a = -32768; a < 32768; ++a) all.push_back(static_cast<std::int16_t>(a));
    check_sqrt<std::int16_t, 8>(all);
    check_sqrt<std::int8_t, 4>(operands<std::int8_t>(300));
    check_sqrt<std::int32_t, 16>(operands<std::int32_t>(100000));
    check_sqrt<std::int64_t, 32>(operands<std::int64_t>(10000));
}

template <class Raw, int F>
void check_atan2(const std::vector<Raw>& values, double ulps) {
    const double turn = 2 * std::numbers::pi;
    for (const Raw y : values) {
        for (const Raw x : values) {
            const double angle =
                std::ldexp(static_cast<double>(published::atan2<Raw, F>(y, x)), -F);
            ASSERT_GE(angle, 0);
            ASSERT_LT(angle, turn);
            double expected = std::atan2(static_cast<double>(y), static_cast<double>(x));
            if (expected < 0) expected += turn;
            ASSERT_NEAR(angle, expected, std::ldexp(ulps, -F)) << +y << ", " << +x;
        }
    }
}

// Truncations of the ratio and of the result, the rounding of three shares of pi and the chord of
// an interval (1/8 200^-2 0.65 = 2 10^-6, which only Q32.32 sees) add up to less than four ulp.
TEST(Published, Atan2IsInZeroToTwoPiEverywhere) {
    std::vector<std::int8_t> all;
    for (int a = -128; a < 128; ++a) all.push_back(static_cast<std::int8_t>(a));
    check_atan2<std::int8_t, 4>(all, 4);
    check_atan2<std::int16_t, 8>(operands<std::int16_t>(400), 4);
    check_atan2<std::int32_t, 16>(operands<std::int32_t>(400), 4);
    check_atan2<std::int64_t, 32>(operands<std::int64_t>(400), std::ldexp(2.1e-6, 32));
    EXPECT_EQ((published::atan2<std::int32_t, 16>(0, 0)), 0);
}

TEST(Published, AtanOutsideOfItsDomainGivesTheNearerEnd) {
    EXPECT_EQ((published::atan<std::int32_t, 16>(-1)), 0);
    EXPECT_EQ((published::atan<std::int32_t, 16>(INT32_MAX)),
              (published::atan<std::int32_t, 16>(65536)));
}

TEST(Published, DecimalsTruncateTowardZero) {
    EXPECT_EQ((published::from_decimal<std::int32_t, 16>(38, 2)), 24903);  // 0.38 * 65536 = 24903.7
    EXPECT_EQ((published::from_decimal<std::int32_t, 16>(-38, 2)), -24903);
    EXPECT_EQ((published::from_decimal<std::int32_t, 16>(314159, 5)),
              205887);  // 5 decimals
    EXPECT_EQ((published::from_decimal<std::int16_t, 8>(-15, 1)), -384);
    EXPECT_EQ((published::from_decimal<std::int64_t, 32>(INT32_MIN, 0)), INT64_MIN);
    EXPECT_EQ((published::from_decimal<std::int32_t, 16>(INT32_MAX, 20)), 0);
}

static_assert(published::multiply<std::int32_t, 16>(3 << 15, 5 << 15) == 15 << 14);
static_assert(published::sqrt<std::int32_t, 16>(4 << 16) == 2 << 16);

}  // namespace
