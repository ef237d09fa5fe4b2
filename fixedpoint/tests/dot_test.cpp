// SPDX-License-Identifier: MIT
// dot2 and dot3 against exact integers: one rounding, modulo 2^W.
#include <gtest/gtest.h>

#include <fixedpoint/kernel/dispatch.hpp>

#include "exact.hpp"
#include "formats.hpp"

namespace {

using namespace fixedpoint;

template <class Raw>
Raw defined_dot(const Raw* a, const Raw* b, int n, int F) {
    exact::Int sum = 0;
    for (int i = 0; i < n; ++i) sum += exact::Int(a[i]) * b[i];
    return exact::wrapped<Raw>(exact::nearest(sum, exact::power(2, static_cast<unsigned>(F))));
}

template <class Format>
class Dot : public testing::Test {};
TYPED_TEST_SUITE(Dot, Formats);

TYPED_TEST(Dot, IsTheNearestNumberModuloTheRange) {
    using Raw = typename TypeParam::Raw;
    constexpr int F = TypeParam::F;
    const std::vector<Raw> numbers = exact::raws<Raw>();
    std::mt19937_64 random(8);
    const auto any = [&] { return numbers[random() % numbers.size()]; };
    for_each_pair<Raw>([&](Raw x, Raw y) {
        const Raw a[3] = {x, any(), any()}, b[3] = {y, any(), any()};
        ASSERT_EQ((kernel::dot2<Raw, F>(a, b)), defined_dot(a, b, 2, F)) << +x << ' ' << +y;
        ASSERT_EQ((kernel::dot3<Raw, F>(a, b)), defined_dot(a, b, 3, F)) << +x << ' ' << +y;
    });
}

// Three products of the smallest number exceed what twice the width holds as a signed number.
TYPED_TEST(Dot, HoldsThreeSquaresOfTheSmallestNumber) {
    using Raw = typename TypeParam::Raw;
    constexpr int F = TypeParam::F;
    const Raw v[3] = {RawLimits<Raw>::min, RawLimits<Raw>::min, RawLimits<Raw>::min};
    EXPECT_EQ((kernel::dot3<Raw, F>(v, v)), defined_dot(v, v, 3, F));
}

// Halves of an ulp add up before they are rounded.
TEST(DotOfHalves, AreRoundedOnce) {
    const int32_t a[3] = {1 << 15, 1 << 15, 1 << 15}, b[3] = {1, 1, 1};
    EXPECT_EQ((kernel::dot2<int32_t, 16>(a, b)), 1);
    EXPECT_EQ((kernel::dot3<int32_t, 16>(a, b)), 2);
}

}  // namespace
