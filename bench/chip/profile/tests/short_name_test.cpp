// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/profile/short_name.hpp"

#include <gtest/gtest.h>

namespace profile {
namespace {

TEST(ShortName, IsClassAndName) {
    EXPECT_EQ(
        short_name("firmware::Lever<firmware::Choices<Fixed<16, 16> > >::weight(unsigned int)"),
        "Lever::weight");
    EXPECT_EQ(short_name("long fixedpoint::portable::scale_down<10, long>(long)"), "scale_down");
    EXPECT_EQ(short_name("firmware::terminal::put_number(char*, unsigned char)"), "put_number");
    EXPECT_EQ(short_name("engine::Vector<Q, 2>::Vector<Q, Q>(Q, Q)"), "Vector::Vector");
    EXPECT_EQ(short_name("(anonymous namespace)::Board::ticks()"), "Board::ticks");
    EXPECT_EQ(short_name("void Lever<1>::stop(int (*)(int)) [clone .constprop.157]"),
              "Lever::stop");
}
TEST(ShortName, OfOperators) {
    EXPECT_EQ(short_name("fixedpoint::operator*(fixedpoint::Fixed<16, 16>, int)"), "operator*");
    EXPECT_EQ(short_name("bool ns::Less<int>::operator()(int, int)"), "Less::operator()");
    EXPECT_EQ(short_name("ns::operator<<(int)"), "operator<<");
}
TEST(ShortName, LeavesOtherNamesAlone) {
    for (const char* name : {"main", "fixedpoint_multiply_q16_16", "__prologue_saves__", "(asleep)",
                             "(start-up)", "ADC_vect"})
        EXPECT_EQ(short_name(name), name);
}

}  // namespace
}  // namespace profile
