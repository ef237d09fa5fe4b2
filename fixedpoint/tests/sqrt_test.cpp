// SPDX-License-Identifier: MIT
// sqrt against the integer residual of its root: r is nearest to sqrt(n) where
// (r - 1/2)^2 < n < (r + 1/2)^2.
#include <gtest/gtest.h>

#include <fixedpoint/kernel/dispatch.hpp>
#include <limits>

#include "exact.hpp"

namespace {

template <class Format>
class Sqrt : public testing::Test {};
using Formats =
    testing::Types<exact::Format<int8_t, 0>, exact::Format<int8_t, 1>, exact::Format<int8_t, 4>,
                   exact::Format<int8_t, 7>, exact::Format<int8_t, 8>, exact::Format<int16_t, 0>,
                   exact::Format<int16_t, 5>, exact::Format<int16_t, 8>, exact::Format<int16_t, 15>,
                   exact::Format<int16_t, 16>, exact::Format<int32_t, 0>, exact::Format<int32_t, 1>,
                   exact::Format<int32_t, 16>, exact::Format<int32_t, 24>,
                   exact::Format<int32_t, 31>, exact::Format<int32_t, 32>,
                   exact::Format<int64_t, 0>, exact::Format<int64_t, 1>, exact::Format<int64_t, 32>,
                   exact::Format<int64_t, 47>, exact::Format<int64_t, 63>,
                   exact::Format<int64_t, 64>>;
TYPED_TEST_SUITE(Sqrt, Formats);

template <class Int, class Raw>
void expect_nearest(Raw a, int fraction_bits, Raw root) {
    const Int r = root, n = Int(a) << fraction_bits;
    ASSERT_GE(root, 0) << +a;
    if (root < std::numeric_limits<Raw>::max()) {
        ASSERT_LT(4 * n, (2 * r + 1) * (2 * r + 1)) << +a;
    }
    if (root > 0) {
        ASSERT_GT(4 * n, (2 * r - 1) * (2 * r - 1)) << +a;
    }
}

TYPED_TEST(Sqrt, RoundsToNearest) {
    using Raw = typename TypeParam::Raw;
    constexpr int F = TypeParam::F;
    for (const Raw a : exact::raws<Raw>()) {
        const Raw root = fixedpoint::kernel::sqrt<Raw, F>(a);
        ASSERT_EQ((fixedpoint::kernel::sqrt_small<Raw, F>(a)), root) << +a;
        if (a < 0) {
            ASSERT_EQ(root, 0) << +a;
        } else if (sizeof(Raw) <= 4) {
            expect_nearest<__int128>(a, F, root);
        } else {
            expect_nearest<exact::Int>(a, F, root);
        }
    }
}

// The raw numbers beside (r + 1/2)^2 / 2^16, where rounding is decided.
TEST(SqrtQ16_16, RoundsToNearestBesideHalves) {
    std::mt19937_64 random(16);
    for (int i = 0; i < 300000; ++i) {
        const uint64_t root = (random() % 11863284) >> (random() % 24);
        const auto half = static_cast<int32_t>((root * root + root) >> 16);
        for (const int32_t a : {half, half + 1}) {
            expect_nearest<__int128>(a, 16, fixedpoint::kernel::sqrt<int32_t, 16>(a));
        }
    }
}

TEST(SqrtQ16_16, IsConstant) {
    static_assert(fixedpoint::kernel::sqrt<int32_t, 16>(2 * 65536) == 92682, "sqrt(2)");
    static_assert(fixedpoint::kernel::sqrt<int32_t, 16>(-1) == 0, "below zero");
}

}  // namespace
