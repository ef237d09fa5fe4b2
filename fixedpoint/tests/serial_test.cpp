// SPDX-License-Identifier: MIT
// Numbers to and from objects with the members of Arduino's Print and Stream.
#include <fixedpoint.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>

namespace {

using namespace fixedpoint;
using namespace fixedpoint::literals;

struct Serial {
    std::string characters;

    size_t write(const char* text, size_t length) {
        characters.append(text, length);
        return length;
    }
    int peek() const { return characters.empty() ? -1 : characters.front(); }
    int read() {
        const int next = peek();
        if (next >= 0) characters.erase(0, 1);
        return next;
    }
};

TEST(Serial, PrintsTheShortestTextOrSoManyDecimals) {
    Serial serial;
    EXPECT_EQ(print(serial, -0.38_q16_16), 5u);
    EXPECT_EQ(print(serial, 2.5_q4_4, 3), 5u);
    EXPECT_EQ(serial.characters, "-0.382.500");
    // With as many decimals as fraction bits a number is exact, so the buffer cannot overflow.
    serial.characters.clear();
    print(serial, Q8_8::ulp(), 255);
    EXPECT_EQ(serial.characters, "0.00390625");
}

TEST(Serial, ReadsUpToWhatIsNoPartOfANumber) {
    Serial serial{"-0.38,1e2 x"};
    EXPECT_EQ(read<Q16_16>(serial).number, -0.38_q16_16);
    EXPECT_EQ(serial.read(), ',');
    EXPECT_EQ(read<Q16_16>(serial).number, 100_q16_16);
    EXPECT_EQ(serial.read(), ' ');
    EXPECT_EQ(read<Q16_16>(serial).status, TextStatus::empty);
    EXPECT_EQ(serial.characters, "x");
}

TEST(Serial, ReadsTheExactTextOfAnyNumber) {
    Serial serial;
    const Q32_32 number = Q32_32::from_raw(std::numeric_limits<std::int64_t>::min() + 1);
    EXPECT_EQ(print(serial, number, 32), 44u);
    EXPECT_EQ(read<Q32_32>(serial).number, number);
    EXPECT_TRUE(serial.characters.empty());
}

TEST(Serial, ReportsWhatItCannotHold) {
    Serial large{"1e9"}, malformed{"1.2.3"}, endless{std::string(100, '1')};
    EXPECT_EQ(read<Q16_16>(large).status, TextStatus::out_of_range);
    EXPECT_EQ(read<Q16_16>(malformed).status, TextStatus::malformed);
    EXPECT_EQ(read<Q16_16>(endless).status, TextStatus::out_of_range);
    EXPECT_EQ(endless.characters.size(), 60u);
}

}  // namespace
