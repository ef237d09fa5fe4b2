// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/live/session.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "bench/live/lever.hpp"
#include "bench/live/panel.hpp"
#include "bench/live/replay.hpp"
#include "this_build.hpp"

namespace live {
namespace {

using haptic::degrees;

haptic::Scenario nobody() {
    haptic::Scenario s{"nobody", "", 10, {}, 1, {}};
    s.script.dial.from(0);
    return s;
}

class Played : public testing::Test {
  protected:
    Played() : session(haptic::firmwares(build_folder() / "firmware").front(), nobody()) {
        run(0.4);
    }
    void run(double seconds) {
        const double end = session.time() + seconds;
        while (session.time() < end) session.run_until(session.time() + Replay::sample);
    }
    Session session;
};

TEST_F(Played, RestsOnItsStopAndKeepsItsRate) {
    run(1);
    const Status s = session.status();
    EXPECT_NEAR(s.servo, 0, degrees(1));
    EXPECT_NEAR(s.loop_rate.value(), 1024, 2);
    EXPECT_LT(s.lateness.value(), 1e-3);
    EXPECT_GT(s.cpu_share, 0.1);
    EXPECT_LT(s.cpu_share, 0.5);
    EXPECT_NEAR(s.frames_per_second, 20, 2);
    EXPECT_NEAR(s.arm.value(), 0.23, 0.002);
    EXPECT_NEAR(s.pulse, 1e-3, 1e-5);
}

TEST_F(Played, APushLiftsAFreeLeverWhichFallsAgain) {
    session.press(Key::push_up);
    run(0.2);
    EXPECT_GT(session.status().lever, degrees(5));
    run(2);
    EXPECT_LT(session.status().lever, degrees(2));
}

TEST_F(Played, AHandThatHoldsMovesByThreeDegreesAKey) {
    session.press(Key::grip);
    run(0.1);
    EXPECT_TRUE(session.status().held);
    for (int key = 0; key < 10; ++key) session.press(Key::push_up);
    run(1);
    // The weight pulls the hand's spring down by 1.1 N / 300 N/m: 1.1 degrees.
    EXPECT_NEAR(session.status().lever, degrees(29), degrees(3));
    session.press(Key::push_down);
    run(0.5);
    EXPECT_NEAR(session.status().lever, degrees(26), degrees(3));
    session.press(Key::grip);
    run(2);  // it bounces
    EXPECT_FALSE(session.status().held);
    EXPECT_LT(session.status().lever, degrees(2));
}

TEST_F(Played, TheDialMakesTheArmLonger) {
    for (int key = 0; key < 20; ++key) session.press(Key::dial_up);
    run(0.5);
    EXPECT_NEAR(session.status().arm.value(), 0.48, 0.005);
    for (int key = 0; key < 10; ++key) session.press(Key::dial_down);
    run(0.5);
    EXPECT_NEAR(session.status().arm.value(), 0.355, 0.005);
}

TEST_F(Played, UnpluggingCyclesThroughTheSensors) {
    for (const std::optional<int> expected :
         {std::optional<int>(0), std::optional<int>(1), std::optional<int>()}) {
        session.press(Key::unplug);
        EXPECT_EQ(session.status().unplugged, expected);
        if (expected) {
            EXPECT_EQ(session.status().reading[*expected], 0);
        }
    }
    EXPECT_GT(session.status().reading[0], 100);
}

TEST_F(Played, AStalledServoStaysWhereItIs) {
    session.press(Key::stall);
    session.press(Key::push_up);
    run(0.3);
    EXPECT_TRUE(session.status().stalled);
    EXPECT_NEAR(session.status().servo, 0, degrees(0.3));
    session.press(Key::stall);
    EXPECT_FALSE(session.status().stalled);
    session.press(Key::push_up);
    run(0.15);
    EXPECT_GT(session.status().servo, degrees(2));
}

TEST_F(Played, AFullFrameIsSentOnRequest) {
    run(1.2);
    EXPECT_EQ(session.status().bytes_per_second, 0);
    session.press(Key::full_frame);
    run(0.3);
    EXPECT_GT(session.status().bytes_per_second, 30);
}

TEST_F(Played, AResetStartsAgainAndTimeContinues) {
    session.press(Key::dial_up);
    const double before = session.time();
    session.press(Key::reset);
    EXPECT_NEAR(session.time(), before, 1e-3);
    EXPECT_FALSE(session.status().loop_rate.has_value());
    EXPECT_EQ(session.status().dial, 0);
    run(0.2);
    EXPECT_NEAR(session.time(), before + 0.2, 0.01);
    EXPECT_NEAR(session.status().loop_rate.value(), 1024, 5);
}

TEST_F(Played, ThePanelShowsTheScreenAndTheFigures) {
    run(0.5);
    const Picture picture = panel(session, WallClock{2, 0.5});
    std::wstring text;
    for (int row = 0; row < Picture::rows; ++row)
        for (int column = 0; column < Picture::columns; ++column)
            text += picture.at(row, column).glyph;
    for (const wchar_t* const shown :
         {L"q16_16", L"1024 Hz", L"23.0 cm", L"the lever is free", L"0.50 x real time: a slow",
          L"space grip", L"q quit", L"1000 \u00b5s"})
        EXPECT_NE(text.find(shown), std::wstring::npos)
            << std::string(shown, shown + wcslen(shown));
    // The weight, where the device's screen shows it.
    const auto screen = session.status().screen;
    for (int row = 0; row < 20; ++row)
        for (int column = 0; column < 20; ++column)
            EXPECT_EQ(
                picture.at(2 + row, 1 + 2 * column).ink == Ink::weight,
                screen[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] == 'o');
}

// The page's data compared with the session that they belong to.
TEST(Replay, IsWhatTheSessionDid) {
    Session session(haptic::firmwares(build_folder() / "firmware").front(), demonstration());
    Replay replay(session);
    std::vector<Status> seen;
    for (int k = 1; k <= 750; ++k) {
        session.run_until(k * Replay::sample);
        replay.watch(session);
        seen.push_back(session.status());
    }
    const auto page = nlohmann::json::parse(replay.json(session));
    const auto& signals = page["signals"];
    ASSERT_EQ(signals["lever"].size(), seen.size());
    for (std::size_t k = 0; k < seen.size(); k += 10) {
        EXPECT_NEAR(signals["lever"][k].get<double>(), seen[k].lever / degrees(1), 0.0051);
        EXPECT_NEAR(signals["servo"][k].get<double>(), seen[k].servo / degrees(1), 0.0051);
        EXPECT_NEAR(signals["hand"][k].get<double>(), seen[k].hand_force, 0.0051);
        EXPECT_NEAR(signals["arm"][k].get<double>(), seen[k].arm.value_or(0), 0.000051);
        EXPECT_EQ(signals["held"][k].get<int>() != 0, seen[k].held);
    }
    // The screen at the end, and the pins compared with what was measured at them.
    std::string cells;
    for (const std::string& line : seen.back().screen) cells += line;
    EXPECT_EQ(page["screens"].back()["cells"], cells);
    const auto& timing = session.loop().timing();
    const auto& step = page["pins"]["step"];
    EXPECT_NEAR(static_cast<double>(step.size()) / 2,
                static_cast<double>(timing.step_begins.size()), 1);
    long long now = 0;
    for (std::size_t k = 0; k < 100; ++k) {
        now += step[2 * k].get<long long>();
        EXPECT_NEAR(static_cast<double>(now), haptic::seconds_of(timing.step_begins[k]) * 1e6,
                    0.51);
        now += step[2 * k + 1].get<long long>();
    }
    EXPECT_NEAR(static_cast<double>(page["pins"]["servo"].size()) / 2, 150, 1);
}

}  // namespace
}  // namespace live
