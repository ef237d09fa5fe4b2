// SPDX-License-Identifier: MIT
// reciprocal_sqrt against the integer residual of its result: r is nearest to sqrt(2^(3F) / a)
// where (r - 1/2)^2 a <= 2^(3F) < (r + 1/2)^2 a.
#include <gtest/gtest.h>

#include <cmath>
#include <fixedpoint/portable/reciprocal_sqrt.hpp>
#include <limits>

#include "exact.hpp"

namespace {

template <class Format>
class ReciprocalSqrt : public testing::Test {};
using Formats =
    testing::Types<exact::Format<int8_t, 0>, exact::Format<int8_t, 3>, exact::Format<int8_t, 4>,
                   exact::Format<int8_t, 7>, exact::Format<int16_t, 0>, exact::Format<int16_t, 8>,
                   exact::Format<int16_t, 15>, exact::Format<int32_t, 0>,
                   exact::Format<int32_t, 16>, exact::Format<int32_t, 24>,
                   exact::Format<int32_t, 31>, exact::Format<int64_t, 0>,
                   exact::Format<int64_t, 32>, exact::Format<int64_t, 63>>;
TYPED_TEST_SUITE(ReciprocalSqrt, Formats);

TYPED_TEST(ReciprocalSqrt, RoundsToNearest) {
    using Raw = typename TypeParam::Raw;
    constexpr int F = TypeParam::F;
    const exact::Int numerator = exact::power(2, 3 * F + 2);
    for (const Raw a : exact::raws<Raw>()) {
        const Raw result = fixedpoint::portable::nearest_reciprocal_sqrt<Raw, F>(a);
        if (a <= 0) {
            ASSERT_EQ(result, a < 0 ? 0 : std::numeric_limits<Raw>::max()) << +a;
            continue;
        }
        const exact::Int twice = 2 * exact::Int(result);
        if (result > 0) {
            ASSERT_LE((twice - 1) * (twice - 1) * a, numerator) << +a;
        }
        if (result < std::numeric_limits<Raw>::max()) {
            ASSERT_GT((twice + 1) * (twice + 1) * a, numerator) << +a;
        }
    }
}

TEST(ReciprocalSqrtQ16_16, StaysWithinItsBound) {
    const auto error = [](int32_t a) {
        const long double result = fixedpoint::portable::reciprocal_sqrt<int32_t, 16>(a);
        return std::fabs(result - 16777216.0L / std::sqrt(static_cast<long double>(a)));
    };
    for (int32_t a = 1; a < 1 << 20; ++a) ASSERT_LE(error(a), 0.6441L) << a;
    for (const int32_t a : exact::raws<int32_t>()) {
        if (a > 0) {
            ASSERT_LE(error(a), 0.6441L) << a;
        }
    }
}

TEST(ReciprocalSqrtQ16_16, DefinesZeroAndBelow) {
    EXPECT_EQ((fixedpoint::portable::reciprocal_sqrt<int32_t, 16>(0)), 0x7fffffff);
    EXPECT_EQ((fixedpoint::portable::reciprocal_sqrt<int32_t, 16>(-1)), 0);
    EXPECT_EQ((fixedpoint::portable::reciprocal_sqrt<int32_t, 16>(-0x7fffffff - 1)), 0);
}

TEST(ReciprocalSqrtQ16_16, IsExactAtPowersOfFour) {
    for (int i = 0; i < 16; ++i) {
        EXPECT_EQ((fixedpoint::portable::reciprocal_sqrt<int32_t, 16>(int32_t(1) << 2 * i)),
                  int32_t(1) << (24 - i));
    }
    static_assert(fixedpoint::portable::reciprocal_sqrt<int32_t, 16>(65536) == 65536,
                  "1 / sqrt(1)");
}

// r is within 0.63 ulp where (r - 0.63)^2 a <= 2^96 <= (r + 0.63)^2 a.
TEST(ReciprocalSqrtQ32_32, StaysWithinItsBound) {
    const exact::Int numerator = exact::power(2, 96) * 10000;
    for (const int64_t a : exact::raws<int64_t>()) {
        const int64_t result = fixedpoint::portable::reciprocal_sqrt<int64_t, 32>(a);
        if (a <= 0) {
            ASSERT_EQ(result, a < 0 ? 0 : std::numeric_limits<int64_t>::max()) << a;
            continue;
        }
        const exact::Int below = 100 * exact::Int(result) - 63, above = below + 126;
        ASSERT_LE(below * below * a, numerator) << a;
        ASSERT_GE(above * above * a, numerator) << a;
    }
}

}  // namespace
