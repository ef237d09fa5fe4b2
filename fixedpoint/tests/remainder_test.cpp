// SPDX-License-Identifier: MIT
// remainder against exact integers.
#include <gtest/gtest.h>

#include <fixedpoint/portable/remainder.hpp>

#include "exact.hpp"
#include "formats.hpp"

namespace {

using namespace fixedpoint;
using exact::Int;

template <class Format>
class Remainder : public testing::Test {};
TYPED_TEST_SUITE(Remainder, Formats);

TYPED_TEST(Remainder, IsExactWithTheSignOfTheDividend) {
    using Raw = typename TypeParam::Raw;
    for_each_pair<Raw>([](Raw a, Raw b) {
        // cpp_int divides toward zero.
        const Int rest = b == 0 ? Int(a) : Int(a) - Int(b) * (Int(a) / Int(b));
        ASSERT_EQ((portable::remainder<Raw, TypeParam::F>(a, b)), static_cast<Raw>(rest))
            << +a << " % " << +b;
    });
}

}  // namespace
