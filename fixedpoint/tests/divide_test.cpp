// SPDX-License-Identifier: MIT
// divide, and the division that widens only where it must, against exact integers.
#include <gtest/gtest.h>

#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/portable/divide_widening.hpp>

#include "exact.hpp"
#include "formats.hpp"

namespace {

using namespace fixedpoint;

template <class Raw>
Raw defined_quotient(Raw a, Raw b, int F) {
    using exact::Int;
    if (b == 0) return a == 0 ? Raw(0) : a > 0 ? RawLimits<Raw>::max : RawLimits<Raw>::min;
    const Int numerator = Int(a) << F;
    return exact::clamped<Raw>(b > 0 ? exact::nearest(numerator, b)
                                     : exact::nearest(-numerator, -Int(b)));
}

template <class Format>
class Divide : public testing::Test {};
TYPED_TEST_SUITE(Divide, Formats);

TYPED_TEST(Divide, IsTheNearestNumberClamped) {
    using Raw = typename TypeParam::Raw;
    constexpr int F = TypeParam::F;
    for_each_pair<Raw>([](Raw a, Raw b) {
        const Raw expected = defined_quotient(a, b, F);
        ASSERT_EQ((kernel::divide<Raw, F>(a, b)), expected) << +a << " / " << +b;
        ASSERT_EQ((portable::divide_widening<Raw, F>(a, b)), expected) << +a << " / " << +b;
    });
}

// Quotients halfway between two numbers, of either sign, and their neighbours.
TYPED_TEST(Divide, TiesGoUpward) {
    using Raw = typename TypeParam::Raw;
    constexpr int F = TypeParam::F;
    if constexpr (F > 0 && F < RawLimits<Raw>::width - 2) {
        const Raw divisor = static_cast<Raw>(Raw(1) << (F + 1));
        for (int offset = -2; offset <= 2; ++offset) {
            for (int half = -9; half <= 9; half += 2) {
                const Raw a = static_cast<Raw>(half + offset);
                const Raw expected = defined_quotient(a, divisor, F);
                ASSERT_EQ((kernel::divide<Raw, F>(a, divisor)), expected) << +a;
                ASSERT_EQ((portable::divide_widening<Raw, F>(a, divisor)), expected) << +a;
            }
        }
    }
}

static_assert(kernel::divide<int32_t, 16>(3 << 16, 7 << 16) == 28087,
              "A division of constants is a constant.");
static_assert(kernel::divide<int32_t, 16>(-1, 2 << 16) == 0, "Half an ulp is a tie: upward.");

}  // namespace
