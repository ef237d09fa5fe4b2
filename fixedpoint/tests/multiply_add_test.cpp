// SPDX-License-Identifier: MIT
// multiply and multiply_add against exact integers.
#include <gtest/gtest.h>

#include <fixedpoint/kernel/dispatch.hpp>

#include "exact.hpp"
#include "formats.hpp"

namespace {

using namespace fixedpoint;
using exact::Int;

template <class Format>
class MultiplyAdd : public testing::Test {};
TYPED_TEST_SUITE(MultiplyAdd, Formats);

TYPED_TEST(MultiplyAdd, IsTheNearestNumberModuloTheRange) {
    using Raw = typename TypeParam::Raw;
    constexpr int F = TypeParam::F;
    const std::vector<Raw> numbers = exact::raws<Raw>();
    const Int one = exact::power(2, F);
    std::mt19937_64 random(5);
    for_each_pair<Raw>([&](Raw a, Raw b) {
        const Raw c = numbers[random() % numbers.size()];
        const Int product = Int(a) * b;
        ASSERT_EQ((kernel::multiply<Raw, F>(a, b)),
                  exact::wrapped<Raw>(exact::nearest(product, one)))
            << +a << " * " << +b;
        ASSERT_EQ((kernel::multiply_add<Raw, F>(a, b, c)),
                  exact::wrapped<Raw>(exact::nearest(product + c * one, one)))
            << +a << " * " << +b << " + " << +c;
    });
}

}  // namespace
