// SPDX-License-Identifier: GPL-3.0-or-later
// The judge on constructed runs, each at a limit and beyond it: a run may reach a limit.
#include "bench/experiments/haptic/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "bench/experiments/haptic/recording.hpp"

namespace haptic {
namespace {

constexpr Cycle ms = simulator::Chip::frequency / 1000;

// Steps of a millisecond from 0.5 s to 0.75 s, each of 0.2 ms; three of four cycles asleep, one in
// 32 rendering, five frames: exactly what is required. Times are exact in double.
Timing punctual() {
    Timing timing;
    for (Cycle k = 0; k < 250; ++k) timing.step_begins.push_back((500 + k) * ms);
    timing.step_lengths.assign(250, static_cast<std::uint32_t>(ms / 5));
    timing.frame_begins.assign(5, 500 * ms);
    timing.asleep = 250 * ms * 3 / 4;
    timing.rendering = 250 * ms / 32;
    timing.shortest_pulse = 1e-3;
    timing.longest_pulse = 1.667e-3;
    timing.longest_period = 0.02;
    return timing;
}
constexpr double end = 0.75, shortest_arm = 0.23;
const TimingLimits limits{ms, 1000, 1e-3, 0.25, 0.03125, 20};

Judgement judge(const Timing& timing, const TimingLimits& held_to = limits) {
    return Judge({}, held_to).judge(timing, end, shortest_arm);
}

TEST(JudgeTiming, MeasuresTheSteps) {
    const Judgement j = judge(punctual());
    EXPECT_EQ(j.violations, std::vector<std::string>{});
    EXPECT_DOUBLE_EQ(j.loop_rate, 1000);
    EXPECT_DOUBLE_EQ(j.step_mean, 0.2e-3);
    EXPECT_DOUBLE_EQ(j.step_most, 0.2e-3);
    EXPECT_DOUBLE_EQ(j.cpu_share, 0.25);
    EXPECT_DOUBLE_EQ(j.rendering_share, 0.03125);
    EXPECT_DOUBLE_EQ(j.frames_per_second, 20);
    EXPECT_EQ(j.worst_lateness, 0);
    EXPECT_EQ(j.late_steps, 0u);
    Timing uneven = punctual();
    uneven.step_lengths[70] = static_cast<std::uint32_t>(ms);
    EXPECT_DOUBLE_EQ(judge(uneven).step_mean, 0.2032e-3);
    EXPECT_DOUBLE_EQ(judge(uneven).step_most, 1e-3);
}

TEST(JudgeTiming, CountsFramesByLinesWhereLinesAreSent) {
    Timing timing = punctual();
    timing.lines_sent = 5 * 40;  // as many as five frames of twenty lines, each with a blank one
    timing.frame_begins.clear();
    EXPECT_DOUBLE_EQ(judge(timing).frames_per_second, 20);
}

TEST(JudgeTiming, AStepMayBeAsLateAsTheLimitAndNoCycleMore) {
    Timing timing = punctual();
    timing.step_begins[40] += ms;
    EXPECT_DOUBLE_EQ(judge(timing).worst_lateness, 1e-3);
    EXPECT_EQ(judge(timing).late_steps, 0u);
    EXPECT_TRUE(judge(timing).violations.empty());
    timing.step_begins[40] += 1;
    EXPECT_EQ(judge(timing).late_steps, 1u);
    ASSERT_EQ(judge(timing).violations.size(), 1u);
    EXPECT_EQ(judge(timing).violations[0], "1 steps late by more than 1 ms, the worst by 1.000 ms");
    // Lateness is relative to the earliest step, whichever that is.
    Timing early = punctual();
    early.step_begins[60] -= ms / 2;
    EXPECT_DOUBLE_EQ(judge(early).worst_lateness, 0.5e-3);
}

TEST(JudgeTiming, EachLimitIsReachedWithoutAndPassedWithAViolation) {
    const std::vector<std::pair<std::string, std::function<void(TimingLimits&)>>> tighter = {
        {"1000.0 steps a second", [](TimingLimits& l) { l.loop_rate = 1000.01; }},
        {"25.0% of the CPU", [](TimingLimits& l) { l.cpu_share = 0.2499; }},
        {"3.1% of the CPU for rendering", [](TimingLimits& l) { l.rendering_share = 0.0312; }},
        {"20.00 frames a second", [](TimingLimits& l) { l.frames_per_second = 20.01; }}};
    for (const auto& [violation, tighten] : tighter) {
        TimingLimits tight = limits;
        tighten(tight);
        EXPECT_EQ(judge(punctual(), tight).violations, std::vector<std::string>{violation});
    }
}

TEST(JudgeTiming, WithoutStepsIsAViolation) {
    Timing timing = punctual();
    timing.step_begins.resize(2);
    EXPECT_DOUBLE_EQ(judge(timing).loop_rate, 1000);  // two are enough
    timing.step_begins.resize(1);
    EXPECT_EQ(judge(timing).violations, std::vector<std::string>{"no steps"});
}

TEST(JudgeTiming, WithoutLimitsNothingIsLate) {
    Timing timing = punctual();
    timing.step_begins[40] += 90 * ms;
    const Judgement j = Judge({}, {}).judge(timing, end, shortest_arm);
    EXPECT_TRUE(j.violations.empty());
    EXPECT_TRUE(std::isnan(j.worst_lateness));
}

// A pulse may exceed the travel by half a step of 0.29 degrees, at 90 degrees per millisecond: 1.61
// us.
TEST(JudgePulses, HalfAStepBeyondTheTravelIsAllowed) {
    const auto violations = [](double shortest, double longest, double period) {
        Timing timing = punctual();
        timing.shortest_pulse = shortest;
        timing.longest_pulse = longest;
        timing.longest_period = period;
        return judge(timing).violations.size();
    };
    EXPECT_EQ(violations(0.9984e-3, 1.6686e-3, 0.0201), 0u);
    EXPECT_EQ(violations(0.9983e-3, 1.667e-3, 0.02), 1u);
    EXPECT_EQ(violations(1e-3, 1.6687e-3, 0.02), 1u);
    EXPECT_EQ(violations(1e-3, 1.667e-3, 0.02011), 1u);
}

// The text of a violation contains what was measured, in the units that it names.
TEST(JudgeTexts, SayWhatWasMeasured) {
    Timing timing = punctual();
    timing.shortest_pulse = 0.9e-3;
    timing.longest_pulse = 1.25e-3;
    timing.longest_period = 0.04;
    timing.step_begins[3] += 5 * ms / 2;
    EXPECT_EQ(judge(timing).violations,
              (std::vector<std::string>{"1 steps late by more than 1 ms, the worst by 2.500 ms",
                                        "pulses from 900.0 to 1250.0 us",
                                        "40.00 ms from one pulse to the next"}));
    Scenario scenario;
    scenario.envelope.quiet = Envelope::Quiet{0, degrees(1)};
    scenario.envelope.arm = Envelope::Settled{0, {0.5, 0.5}};
    scenario.envelope.rest = Envelope::Rest{0, degrees(5)};
    Judge judge(scenario, limits);
    judge.watch({0.1, 0, degrees(2)});
    judge.watch({0.2, 0, degrees(-1), false});
    EXPECT_EQ(
        judge.judge(punctual(), end, 0.2925).violations,
        (std::vector<std::string>{"the terminal showed something else than the device believed",
                                  "swung by 3.00 degrees", "the arm stands for 0.250 of the dial",
                                  "did not rest where it should"}));
}

// --- The envelope ---

// A run of a second in steps of a millisecond: the servo and the lever as functions of time.
using Motion = std::function<double(double)>;
Judgement judge(const Scenario& scenario, const Motion& servo, const Motion& lever,
                double arm = shortest_arm) {
    Judge judge(scenario, limits);
    for (int k = 1; k <= 1000; ++k) judge.watch({k * 1e-3, servo(k * 1e-3), lever(k * 1e-3)});
    return judge.judge(punctual(), end, arm);
}
double still(double) { return 0; }

Scenario let_go_at(double time) {
    Scenario scenario;
    scenario.script.hand_grip.from(1).step(time, 0);
    return scenario;
}

// From 40 degrees at 200 degrees a second from 0.25 s on: within a degree after 0.195 s.
double falling(double time) { return degrees(40 - std::clamp((time - 0.25) * 200, 0.0, 40.0)); }

TEST(JudgeFall, IsFromLettingGoToTheFirstTimeWithinADegree) {
    Scenario scenario = let_go_at(0.2495);
    scenario.envelope.fall = Span{0.19, 0.2};
    const Judgement j = judge(scenario, falling, still);
    EXPECT_NEAR(j.fall, 0.196, 1e-9);  // 0.250 to 0.446, where it is at 0.8 degrees
    EXPECT_TRUE(j.violations.empty());
    scenario.envelope.fall = Span{j.fall, j.fall};
    EXPECT_TRUE(judge(scenario, falling, still).violations.empty());
    scenario.envelope.fall = Span{0.1, j.fall - 1e-4};
    EXPECT_EQ(judge(scenario, falling, still).violations,
              std::vector<std::string>{"fell in 0.196 s"});
    scenario.envelope.fall = Span{j.fall + 1e-4, 1};
    EXPECT_EQ(judge(scenario, falling, still).violations.size(), 1u);
    EXPECT_EQ(judge(
                  scenario, [](double) { return degrees(1.01); }, still)
                  .violations,
              std::vector<std::string>{"did not fall"});
}

TEST(JudgeFall, AHandThatHoldsOrNeverHeldLetsNothingFall) {
    Scenario scenario;
    EXPECT_TRUE(std::isnan(judge(scenario, falling, still).fall));
    scenario.script.hand_grip.from(1);
    EXPECT_TRUE(std::isnan(judge(scenario, falling, still).fall));
}

// From 60 degrees within 0.3 s, then four bounces a second, each lower by a factor.
TEST(JudgeRest, ALeverMayBounceManyTimesButNotForEver) {
    const auto violations = [](double factor) {
        const Scenario bounce = scenario("bounce");
        Judge judge(bounce, limits);
        for (double now = 0; now < bounce.duration; now += 1e-3) {
            const double fallen = (now - 1) / 0.3;
            const double height = fallen < 1 ? 60 * (1 - std::max(fallen, 0.0))
                                             : 20 * std::pow(factor, (now - 1.3) * 4) *
                                                   std::abs(std::sin(std::numbers::pi * 4 * now));
            judge.watch({now, degrees(height), 0});
        }
        return judge.judge(punctual(), end, shortest_arm).violations;
    };
    EXPECT_EQ(violations(0.8), std::vector<std::string>{});
    EXPECT_EQ(violations(0.9), std::vector<std::string>{"did not rest where it should"});
    EXPECT_EQ(violations(1), std::vector<std::string>{"did not rest where it should"});
}

TEST(JudgeQuiet, TheSwingIsPeakToPeakFromThatTimeOn) {
    Scenario scenario;
    const Motion lever = [](double time) { return time < 0.4995 ? 7 : time < 0.7 ? 0.25 : -0.125; };
    scenario.envelope.quiet = Envelope::Quiet{0.5, 0.375};
    EXPECT_EQ(judge(scenario, still, lever).swing, 0.375);
    EXPECT_TRUE(judge(scenario, still, lever).violations.empty());
    scenario.envelope.quiet = Envelope::Quiet{0.5, 0.374};
    EXPECT_EQ(judge(scenario, still, lever).violations.size(), 1u);
    scenario.envelope.quiet = Envelope::Quiet{0.499, 0.375};
    EXPECT_EQ(judge(scenario, still, lever).swing, 7.125);
}

TEST(JudgeArm, StandsForItsShareOfTheDial) {
    Scenario scenario;
    scenario.envelope.arm = Envelope::Settled{0, {0.5, 0.75}};
    const auto violations = [&](double arm) {
        return judge(scenario, still, still, arm).violations.size();
    };
    EXPECT_EQ(violations(0.3551), 0u);  // 23 cm and half of 25 cm
    EXPECT_EQ(violations(0.4174), 0u);
    EXPECT_EQ(violations(0.3549), 1u);
    EXPECT_EQ(violations(0.4176), 1u);
}

TEST(JudgeRest, TheServoRestsWithinADegreeFromThatTimeOn) {
    Scenario scenario;
    scenario.envelope.rest = Envelope::Rest{0.5, degrees(10)};
    const auto rests = [&](double before, double after) {
        const auto servo = [=](double time) { return degrees(time < 0.4995 ? before : after); };
        return judge(scenario, servo, still).violations.empty();
    };
    EXPECT_TRUE(rests(50, 10.99));
    EXPECT_TRUE(rests(50, 9.01));
    EXPECT_FALSE(rests(10, 11.01));
    EXPECT_FALSE(rests(10, 8.99));
}

TEST(JudgeScreen, AWrongScreenAtAnyTimeCounts) {
    for (const int wrong : {0, 1, 2}) {
        Judge judge({}, limits);
        for (int k = 0; k < 3; ++k) judge.watch({k * 1e-3, 0, 0, k != wrong});
        EXPECT_EQ(judge.judge(punctual(), end, shortest_arm).violations.size(), 1u);
    }
}

// Every edge of every pin, at 62.5 ns a cycle; edges of one cycle share their time.
TEST(Recording, AValueChangeDumpHasEveryEdge) {
    std::vector<PinEdge> edges;
    std::string expected;
    for (int k = 0; k < 60; ++k) {
        const PinEdge edge{static_cast<Cycle>(3 * (k / 2 + 1)), 2 + k % 6, k % 4 < 2};
        edges.push_back(edge);
        if (k % 2 == 0) expected += '#' + std::to_string(1875 * (k / 2 + 1)) + '\n';
        expected += std::string(edge.level ? "1" : "0") + static_cast<char>('c' + k % 6) + '\n';
    }
    const std::string text = value_change_dump(edges);
    const std::string start = "$dumpvars\n0c\n0d\n0e\n0f\n0g\n0h\n$end\n";
    ASSERT_NE(text.find(start), std::string::npos);
    EXPECT_EQ(text.substr(text.find(start) + start.size()), expected);
    for (int pin = 2; pin <= 7; ++pin)
        EXPECT_NE(text.find(std::string("$var wire 1 ") + static_cast<char>('a' + pin) + " PD" +
                            std::to_string(pin) + '_'),
                  std::string::npos);
}

}  // namespace
}  // namespace haptic
