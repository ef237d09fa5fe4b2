// SPDX-License-Identifier: MIT
// What a terminal shows of the drawing, however little the port takes at a time.
#include <gtest/gtest.h>

#include <firmware/debug.hpp>
#include <firmware/hardware/host.hpp>
#include <firmware/renderer.hpp>
#include <random>

#include "rasteriser.hpp"
#include "terminal_emulator.hpp"

namespace firmware {
namespace {

struct Small : Screen {
    static constexpr uint8_t columns = 13;
    static constexpr uint8_t rows = 11;
    static constexpr uint8_t bits = 4;
};
struct TwoColours : Screen {
    static constexpr uint8_t bits = 1;
};
struct Lines : Screen {
    static constexpr Protocol protocol = Protocol::lines;
};
struct Talkative : Configuration {
    static constexpr uint8_t debugged = set_of(Topic::loop, Topic::physics);
    static constexpr uint8_t transmit_capacity = 16;  // the least, less than a row
};

template <class Screen>
class RendererTest : public testing::Test {
  protected:
    using Board = Host<Talkative>;

    void SetUp() override { Board::start(); }

    rasteriser::Picture draw_something() {
        auto expected = rasteriser::blank(Screen::columns, Screen::rows);
        auto& grid = renderer.begin();
        for (int shape = random() % 5; shape >= 0; --shape) {
            const int16_t x0 = coordinate(), y0 = coordinate(), x1 = coordinate(),
                          y1 = coordinate();
            const uint8_t colour = random() % (1 << Screen::bits);
            const char character = Screen::character(colour);
            if (random() % 2) {
                grid.line(x0, y0, x1, y1, colour);
                draw(expected, rasteriser::Line{x0, y0, x1, y1}, character);
            } else {
                grid.circle(x0, y0, x1, colour);
                draw(expected, rasteriser::Circle{x0, y0, x1}, character);
            }
        }
        renderer.finish();
        return expected;
    }
    int16_t coordinate() { return static_cast<int>(random() % 30) - 5; }

    // Lets the renderer send the frame; the line takes up to `most` bytes between two calls.
    void show(int most = 64) {
        for (int calls = 0; !renderer.idle(); ++calls) {
            ASSERT_LT(calls, 100000);
            renderer.transmit();
            const std::string part = Board::world().waiting.substr(0, random() % (most + 1));
            Board::world().waiting.erase(0, part.size());
            terminal.take(part);
            sent += part.size();
        }
        sent += Board::world().waiting.size();
        terminal.take(Board::world().waiting);
        Board::world().waiting.clear();
    }

    std::mt19937 random{1};
    Renderer<Board, Screen> renderer;
    TerminalEmulator terminal{Screen::columns, Screen::rows + 8};
    std::size_t sent = 0;
};

template <class Screen>
class ChangesTest : public RendererTest<Screen> {};
using Screens = testing::Types<Screen, Small, TwoColours>;
TYPED_TEST_SUITE(ChangesTest, Screens, );

TYPED_TEST(ChangesTest, TheTerminalShowsWhatWasDrawn) {
    for (int frame = 0; frame < 2000; ++frame) {
        const auto expected = this->draw_something();
        this->show(frame % 3 == 0 ? 3 : 64);
        ASSERT_EQ(this->terminal.top(TypeParam::rows), expected) << frame;
    }
}

TYPED_TEST(ChangesTest, WhatDidNotChangeIsNotSent) {
    this->draw_something();
    this->show();
    this->sent = 0;
    this->renderer.finish();  // the same frame again
    this->show();
    EXPECT_EQ(this->sent, 0u);
    this->renderer.begin().point(3, 4, 1);
    this->renderer.finish();
    this->show();
    this->renderer.begin().point(4, 4, 1);
    this->renderer.finish();
    this->sent = 0;
    this->show();
    // Two neighbours, one cleared and one set, after one movement: ESC [ l l ; c H, two cells.
    EXPECT_EQ(this->sent, std::string("\x1b[16;4H .").size() - (TypeParam::rows < 14 ? 1 : 0));
}

TYPED_TEST(ChangesTest, RefreshSendsAllToANewTerminal) {
    const auto expected = this->draw_something();
    this->show();
    this->terminal = TerminalEmulator(TypeParam::columns, TypeParam::rows + 8);
    this->renderer.refresh();
    this->renderer.finish();
    this->show();
    EXPECT_EQ(this->terminal.top(TypeParam::rows), expected);
}

// Between the renderer's rows, debug text moves the cursor.
TYPED_TEST(ChangesTest, DebugTextInBetweenDoesNoHarm) {
    using Text = Debug<Host<Talkative>, TypeParam::rows + 1>;
    for (int frame = 0; frame < 200; ++frame) {
        const auto expected = this->draw_something();
        for (int calls = 0; !this->renderer.idle(); ++calls) {
            ASSERT_LT(calls, 10000);
            Text::template print<Topic::loop>(FIRMWARE_TEXT("n "), frame);
            Host<Talkative>::world().drain();
            this->renderer.transmit();
            Host<Talkative>::world().drain();
        }
        this->terminal.take(Host<Talkative>::world().transmitted);
        Host<Talkative>::world().transmitted.clear();
        ASSERT_EQ(this->terminal.top(TypeParam::rows), expected) << frame;
        ASSERT_EQ(this->terminal.screen()[TypeParam::rows].substr(0, 5),
                  ("n " + std::to_string(frame) + "   ").substr(0, 5));
    }
}

using LinesTest = RendererTest<Lines>;

TEST_F(LinesTest, EachFrameIsSentWhole) {
    for (int frame = 0; frame < 200; ++frame) {
        const auto expected = draw_something();
        sent = 0;
        show(frame % 3 == 0 ? 3 : 64);
        EXPECT_EQ(sent, 20u * 2 + 20 * 22);
        // The last line break has scrolled the screen.
        const auto lines = terminal.screen();
        ASSERT_EQ(rasteriser::Picture(lines.end() - 21, lines.end() - 1), expected) << frame;
    }
}

}  // namespace
}  // namespace firmware
