// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <firmware/frame_clock.hpp>
#include <fixedpoint/fixed.hpp>
#include <vector>

namespace firmware {
namespace {

constexpr uint32_t ms = ticks_per_millisecond;

// Where a clock may be at the start: in its middle, and just before it wraps.
class ClockTest : public testing::TestWithParam<uint32_t> {
  protected:
    const uint32_t start = GetParam();
};
INSTANTIATE_TEST_SUITE_P(Starts, ClockTest,
                         testing::Values(0u, 12345u, 0x7ffffff0u, 0u - 3 * ms, 0u - 1));

// Runs the loop for a time. Step number i takes cost(i); each pass without a step takes one tick.
// Returns the time of the physics that has passed.
template <class Steps, class Cost>
uint64_t run(Steps& steps, uint32_t start, uint64_t duration, Cost cost) {
    uint64_t physics = 0, elapsed = 0;
    for (int step = 0; elapsed < duration;) {
        if (const uint32_t length = steps.due(static_cast<uint32_t>(start + elapsed))) {
            physics += length;
            elapsed += cost(step++);
            steps.done(static_cast<uint32_t>(start + elapsed));
        } else {
            ++elapsed;
        }
    }
    return physics;
}

TEST_P(ClockTest, FixedStepsAStepIsDueEachMillisecond) {
    FixedSteps<> steps(start);
    std::vector<uint32_t> due;
    for (uint32_t t = 0; t < 5 * ms; ++t)
        if (steps.due(start + t)) due.push_back(t);
    EXPECT_EQ(due, (std::vector<uint32_t>{ms, 2 * ms, 3 * ms, 4 * ms}));
    EXPECT_EQ(steps.worst_delay(), 0u);
}

TEST_P(ClockTest, FixedStepsKeepsUpWithTheClock) {
    FixedSteps<> steps(start);
    const uint64_t physics = run(steps, start, 1000 * ms, [](int) { return ms * 9 / 10; });
    EXPECT_EQ(physics, 999 * ms);
    EXPECT_EQ(steps.late(), 0u);
    EXPECT_EQ(steps.given_up(), 0u);
}

// One step in a hundred takes 6.5 ms: those after it are late and are made up for.
TEST_P(ClockTest, FixedStepsMakesUpForLateSteps) {
    FixedSteps<> steps(start);
    const uint64_t physics =
        run(steps, start, 1000 * ms, [](int i) { return i % 100 == 50 ? 13 * ms / 2 : ms / 4; });
    EXPECT_GE(physics, 998 * ms);
    EXPECT_EQ(steps.given_up(), 0u);
    // Starts 5.5 ms late, and 0.75 ms less with each of the next ones, until less than a step.
    EXPECT_EQ(steps.late(), 10 * 7u);
    EXPECT_EQ(steps.worst_delay(), 11 * ms / 2);
}

// A wait of 100 ms: ten steps are made up for, the rest is counted, and so is every late one.
TEST_P(ClockTest, FixedStepsGivesUpAndCountsWhatIsTooLate) {
    FixedSteps<ms, 10> steps(start);
    const uint64_t physics =
        run(steps, start, 200 * ms, [](int i) { return i == 0 ? 100 * ms : 1; });
    EXPECT_EQ(steps.given_up(), 89u);
    EXPECT_EQ(physics + steps.given_up() * ms, 199 * ms);
    EXPECT_EQ(steps.worst_delay(), 99 * ms);
}

// Steps that take longer than their length: the physics falls behind, and reports by how much.
TEST_P(ClockTest, FixedStepsOverloadIsReported) {
    FixedSteps<ms, 4> steps(start);
    const uint64_t physics = run(steps, start, 3000 * ms, [](int) { return 2 * ms; });
    EXPECT_NEAR(steps.given_up(), 1500, 10);
    EXPECT_NEAR(1.0 * physics / ms + steps.given_up(), 3000, 10);
    EXPECT_LE(steps.worst_delay(), 7 * ms);
}

TEST_P(ClockTest, FixedStepsRunForHoursThroughWraps) {
    FixedSteps<50000> steps(start);  // 25 ms
    uint64_t physics = 0;
    const uint64_t end = 6ull * 3600 * ticks_per_second;
    for (uint64_t t = 0; t <= end; t += 25000)
        physics += steps.due(static_cast<uint32_t>(start + t));
    EXPECT_EQ(physics, end);
    EXPECT_EQ(steps.late() + steps.given_up(), 0u);
}

// Waits until it is 10 ms behind; then makes steps of 5 ms plus the duration of the previous one.
TEST_P(ClockTest, PublishedStepsWaitsThenCatchesUp) {
    PublishedSteps steps(start);
    uint32_t now = 0;
    EXPECT_EQ(steps.due(start + 10 * ms - 1), 0u);
    now = 10 * ms;
    EXPECT_EQ(steps.due(start + now), 5 * ms);
    now += 4 * ms;
    steps.done(start + now);
    EXPECT_EQ(steps.due(start + now), 9 * ms);  // now at 14 ms, physics from 5 to 14
    now += 1;
    steps.done(start + now);
    EXPECT_EQ(steps.due(start + now), 5 * ms + 1);  // one tick behind is behind: up to 19 ms
    steps.done(start + now);
    EXPECT_EQ(steps.due(start + now), 0u);
    EXPECT_EQ(steps.due(start + 29 * ms), 0u);  // one tick short of 10 ms behind
    EXPECT_EQ(steps.due(start + 29 * ms + 1), 5 * ms);
}

TEST_P(ClockTest, PublishedStepsWaitsWhenNoLongerBehind) {
    PublishedSteps steps(start);
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(steps.due(start + 10 * ms), 5 * ms);
        steps.done(start + 10 * ms);
    }
    EXPECT_EQ(steps.due(start + 10 * ms), 0u);
}

TEST_P(ClockTest, PublishedStepsIsNeverSlowerThanTheClock) {
    PublishedSteps steps(start);
    const uint64_t physics = run(steps, start, 10000 * ms, [](int) { return 44 * ms / 10; });
    EXPECT_GE(physics, 9990 * ms);
    EXPECT_LE(physics, 10010 * ms);
}

TEST_P(ClockTest, FramesTwentyASecond) {
    Frames<> frames(start);
    std::vector<uint32_t> due;
    for (uint32_t t = 0; t < 151 * ms; t += 7)
        if (frames.due(start + t)) due.push_back(t);
    ASSERT_EQ(due.size(), 4u);
    for (uint32_t i = 0; i < 4; ++i) EXPECT_NEAR(due[i], i * 50 * ms, 7);
}

TEST_P(ClockTest, FramesAreNotMadeUpFor) {
    Frames<> frames(start);
    EXPECT_TRUE(frames.due(start));
    EXPECT_TRUE(frames.due(start + 260 * ms));
    EXPECT_FALSE(frames.due(start + 260 * ms));
    EXPECT_FALSE(frames.due(start + 310 * ms - 1));
    EXPECT_TRUE(frames.due(start + 310 * ms));
}

// A frame that is late by less than a frame keeps the beat; one that is late by exactly a frame or
// more starts a new one.
TEST_P(ClockTest, FramesKeepTheBeatIfLateByLessThanAFrame) {
    constexpr uint32_t frame = 50 * ms;
    for (const uint32_t late : {uint32_t{0}, uint32_t{1}, frame / 2, frame - 1, frame, frame + 1}) {
        Frames<> frames(start);
        EXPECT_TRUE(frames.due(start));
        EXPECT_TRUE(frames.due(start + frame + late));
        const uint32_t next = late < frame ? 2 * frame : 2 * frame + late;
        EXPECT_FALSE(frames.due(start + next - 1)) << late;
        EXPECT_TRUE(frames.due(start + next)) << late;
    }
}

// Late by exactly one step counts as late; as far behind as is made up for, nothing is given up.
TEST_P(ClockTest, FixedStepsCountAtTheTick) {
    const auto after = [&](uint32_t behind) {
        FixedSteps<ms, 10> steps(start);
        steps.due(start + ms + behind);
        return std::vector<uint32_t>{steps.late(), steps.given_up(), steps.worst_delay()};
    };
    EXPECT_EQ(after(ms - 1), (std::vector<uint32_t>{0, 0, ms - 1}));
    EXPECT_EQ(after(ms), (std::vector<uint32_t>{1, 0, ms}));
    EXPECT_EQ(after(10 * ms), (std::vector<uint32_t>{1, 0, 10 * ms}));
    EXPECT_EQ(after(11 * ms - 1), (std::vector<uint32_t>{1, 0, 11 * ms - 1}));
    EXPECT_EQ(after(11 * ms), (std::vector<uint32_t>{1, 1, 11 * ms}));
    FixedSteps<ms, 10> steps(start);
    EXPECT_EQ(steps.due(start + ms - 1), 0u);
    EXPECT_EQ(steps.due(start + ms), ms);
}

TEST(Seconds, AreRoundedToNearest) {
    using fixedpoint::Q16_16;
    EXPECT_EQ(seconds<Q16_16>(ms).raw(), 66);           // 65.536
    EXPECT_EQ(seconds<Q16_16>(9 * ms + 2).raw(), 590);  // 589.8895
    EXPECT_EQ(seconds<Q16_16>(50 * ms).raw(), 3277);    // 3276.8
    EXPECT_FLOAT_EQ(seconds<float>(9 * ms), 0.009f);
}

}  // namespace
}  // namespace firmware
