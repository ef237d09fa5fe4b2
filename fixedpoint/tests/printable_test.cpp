// SPDX-License-Identifier: MIT
// Numbers as Printables of Arduino's Print.
#define ARDUINO 10800
#include <fixedpoint.h>
#include <gtest/gtest.h>

#include <fixedpoint/arithmetic/saturating.hpp>
#include <type_traits>

namespace {

using namespace fixedpoint;
using namespace fixedpoint::literals;

TEST(Printable, PrintsTheShortestTextOrSoManyDecimals) {
    Print out;
    EXPECT_EQ(out.print(printable(-0.38_q16_16)), 5u);
    EXPECT_EQ(out.print(printable(2.5_q4_4, 3)), 5u);
    EXPECT_EQ(out.print(printable(2.5_q4_4, 0)), 1u);
    EXPECT_EQ(out.characters, "-0.382.5003");
}

TEST(Printable, PrintsAsEveryArithmeticDoes) {
    Print out;
    const auto largest = Fixed<16, 16, Saturating>::max();
    out.print(printable(largest));
    Print plain;
    print(plain, largest);
    EXPECT_EQ(out.characters, plain.characters);
}

TEST(Printable, TheVtableIsTheWrappers) {
    static_assert(std::is_polymorphic<decltype(printable(1_q16_16))>::value);
    static_assert(!std::is_polymorphic<Q16_16>::value && sizeof(Q16_16) == 4);
}

}  // namespace
