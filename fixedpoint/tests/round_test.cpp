// SPDX-License-Identifier: MIT
// Rounding to integers against exact ones: every number of 8 and 16 bits, boundaries of the others.
#include <gtest/gtest.h>

#include <fixedpoint/portable/round.hpp>

#include "exact.hpp"

namespace {

using namespace fixedpoint::portable;
using exact::Format;
using exact::Int;

template <class F>
class Rounding : public testing::Test {};
using Formats =
    testing::Types<Format<int8_t, 0>, Format<int8_t, 1>, Format<int8_t, 4>, Format<int8_t, 7>,
                   Format<int16_t, 0>, Format<int16_t, 8>, Format<int16_t, 15>, Format<int32_t, 0>,
                   Format<int32_t, 16>, Format<int32_t, 31>, Format<int64_t, 0>,
                   Format<int64_t, 32>, Format<int64_t, 63>>;
TYPED_TEST_SUITE(Rounding, Formats);

TYPED_TEST(Rounding, IsThatOfTheExactNumber) {
    using Raw = typename TypeParam::Raw;
    constexpr int F = TypeParam::F;
    const Int one = Int(1) << F;
    for (const Raw a : exact::raws<Raw>()) {
        const Int below = exact::floor_of(a, one);
        const Int above = -exact::floor_of(-Int(a), one);
        const Int nearest = exact::nearest(a, one);
        ASSERT_EQ((integer_floor<Raw, F>(a)), below) << +a;
        ASSERT_EQ((integer_ceil<Raw, F>(a)), above) << +a;
        ASSERT_EQ((integer_round<Raw, F>(a)), nearest) << +a;
        ASSERT_EQ((fraction<Raw, F>(a)), a - below * one) << +a;
        ASSERT_EQ((floor<Raw, F>(a)), below * one) << +a;
        ASSERT_EQ((ceil<Raw, F>(a)), exact::clamped<Raw>(above * one)) << +a;
        ASSERT_EQ((round<Raw, F>(a)), exact::clamped<Raw>(nearest * one)) << +a;
        ASSERT_EQ((trunc<Raw, F>(a)), (a < 0 ? above : below) * one) << +a;
    }
}

static_assert(ceil<int16_t, 8>(0x7f01) == 0x7fff, "128 is beyond Q8.8: the largest number");
static_assert(round<int16_t, 8>(-0x180) == -0x100, "-1.5 rounds upward");

}  // namespace
