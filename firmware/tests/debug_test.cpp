// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <firmware/debug.hpp>
#include <firmware/hardware/host.hpp>
#include <firmware/profiling.hpp>
#include <fixedpoint/math.hpp>

namespace firmware {
namespace {

struct Talkative : Configuration {
    static constexpr uint8_t debugged = set_of(Topic::loop, Topic::servo);
    static constexpr uint8_t profiled = set_of(Category::render, Category::operation);
    static constexpr uint8_t transmit_capacity = 32;
};
using Board = Host<Talkative>;
using Text = Debug<Board, 21>;

std::string transmitted() {
    Board::world().drain();
    return std::exchange(Board::world().transmitted, "");
}

TEST(Debug, EachTopicHasALine) {
    Board::start();
    Text::print<Topic::loop>(FIRMWARE_TEXT("steps "), int32_t{-12345});
    EXPECT_EQ(transmitted(), "\x1b[21;1Hsteps -12345\x1b[K");
    Text::print<Topic::servo>(FIRMWARE_TEXT("on"));
    EXPECT_EQ(transmitted(), "\x1b[23;1Hon\x1b[K");
}

TEST(Debug, NumbersAreRounded) {
    Board::start();
    const auto third = fixedpoint::Q16_16::from_raw(-0x10000 * 8 / 3);
    Text::print<Topic::loop>(FIRMWARE_TEXT(""), third, 3);
    EXPECT_EQ(transmitted(), "\x1b[21;1H-2.667\x1b[K");
}

TEST(Debug, ATopicThatIsOffSaysNothing) {
    Board::start();
    Text::print<Topic::physics>(FIRMWARE_TEXT("steps "), int32_t{1});
    Text::print<Topic::sensors>(FIRMWARE_TEXT("steps"));
    EXPECT_EQ(transmitted(), "");
}

TEST(Debug, ATextThatDoesNotFitIsDroppedWholeAndCounted) {
    Board::start();
    const uint8_t before = Text::dropped();
    Text::print<Topic::loop>(FIRMWARE_TEXT("123456789 123456789 123"));  // 7 + 23 + 3
    EXPECT_EQ(transmitted(), "");
    EXPECT_EQ(Text::dropped(), before + 1);
    Text::print<Topic::loop>(FIRMWARE_TEXT("123456789 123456789 12"));
    EXPECT_EQ(transmitted().size(), 32u);
    EXPECT_EQ(Text::dropped(), before + 1);
    for (int i = 0; i < 300; ++i)
        Text::print<Topic::loop>(FIRMWARE_TEXT("123456789 123456789 123"));
    EXPECT_EQ(Text::dropped(), 255);
}

TEST(Profiling, AScopeRaisesItsPin) {
    Board::start();
    {
        const Profiled<Board, Category::render> profiled;
        EXPECT_EQ(Board::world().pins, set_of(Category::render));
        const Profiled<Board, Category::step> off;
        EXPECT_EQ(Board::world().pins, set_of(Category::render));
    }
    EXPECT_EQ(Board::world().pins, 0);
}

// Multiplies, and records which pins are high meanwhile.
struct Watched : fixedpoint::Nearest {
    static inline uint8_t pins = 0;
    template <class Raw, int F>
    static Raw multiply(Raw a, Raw b) {
        pins = Board::world().pins;
        return fixedpoint::Nearest::multiply<Raw, F>(a, b);
    }
};

TEST(Profiling, TheArithmeticRaisesThePinOfItsOperators) {
    Board::start();
    using Number = fixedpoint::Fixed<16, 16, ProfiledArithmetic<Board, Watched>>;
    const auto product = Number::from_integer(6) * Number::from_integer(7);
    EXPECT_EQ(product, Number::from_integer(42));
    EXPECT_EQ(Watched::pins, set_of(Category::operation));
    EXPECT_EQ(Board::world().pins, 0);
    EXPECT_EQ(sqrt(Number::from_integer(16)) / Number::from_integer(2), Number::from_integer(2));
}

}  // namespace
}  // namespace firmware
