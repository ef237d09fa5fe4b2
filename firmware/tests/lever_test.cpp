// SPDX-License-Identifier: MIT
// The lever on the host: its physics compared with a real lever's, and the program on the host's
// board.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <firmware/hardware/host.hpp>
#include <firmware/lever_program.hpp>
#include <fstream>
#include <sstream>

#include "this_build.hpp"

namespace firmware {
namespace {

using Q = LeverScalar;
constexpr uint16_t lower_pulse = 2000, upper_pulse = 2000 + 1333;  // ticks: 60 of 90 degrees
constexpr uint16_t at_rest = 2 * 870;                              // a sensor's preload
constexpr engine::BinaryStep<10> step;

Readings sensed(int a, int b, int dial_sum = 0) {
    Readings readings;
    readings.sum[sensor_a] = static_cast<uint16_t>(a);
    readings.sum[sensor_b] = static_cast<uint16_t>(b);
    readings.sum[dial] = static_cast<uint16_t>(dial_sum);
    return readings;
}

double number(Q x) { return fixedpoint::to_float<double>(x); }

struct Undamped : LeverChoices<Q> {
    static constexpr bool selective_damping = false;
    static constexpr Q servo_delay() { return Q(); }
};
struct Damped : LeverChoices<Q> {
    static constexpr Q servo_delay() { return Q(); }
};
struct Corrected : Undamped {
    static constexpr bool frame_correction = true;
};

template <class Choices>
class AnyLever : public testing::Test {};
using AllChoices = testing::Types<LeverChoices<Q>, LeverChoices<float>,
                                  LeverChoices<fixedpoint::Q16_16>, Corrected>;
TYPED_TEST_SUITE(AnyLever, AllChoices);

// The pulses of that many steps with the same readings.
template <class Lever>
uint16_t steps(Lever& lever, int n, const Readings& readings) {
    uint16_t pulse = 0;
    for (int i = 0; i < n; ++i) pulse = lever.step(readings, step);
    return pulse;
}

TYPED_TEST(AnyLever, RestsOnItsLowerStop) {
    Lever<TypeParam> lever;
    for (int i = 0; i < 3000; ++i)
        ASSERT_NEAR(lever.step(sensed(at_rest, at_rest), step), lower_pulse, 4);
}

TYPED_TEST(AnyLever, IsPushedToItsUpperStopAndFallsBack) {
    Lever<TypeParam> lever;
    EXPECT_NEAR(steps(lever, 3000, sensed(2 * 930, 2 * 700)), upper_pulse, 10);
    EXPECT_NEAR(steps(lever, 5000, sensed(at_rest, at_rest)), lower_pulse, 4);
}

// A point mass on a rod of length L from 30 degrees above the horizontal to 30 degrees below it: by
// the energy, the integral of d angle / sqrt(2 g / L (sin 30 - sin angle)).
double fall_time(double length) {
    const double g = 9.81, top = std::asin(0.5);
    double time = 0;
    constexpr int n = 200000;  // midpoints of u, angle = top - u^2, which removes the pole
    const double end = std::sqrt(2 * top);
    for (int i = 0; i < n; ++i) {
        const double u = (i + 0.5) * end / n;
        time +=
            2 * u / std::sqrt(2 * g / length * (std::sin(top) - std::sin(top - u * u))) * end / n;
    }
    return time;
}

TEST(Lever, FallsAsAPointOnARodDoes) {
    for (const int dial_sum : {0, 1023, 2046}) {
        Lever<Undamped> lever;
        steps(lever, 3000, sensed(2 * 955, 2 * 100, dial_sum));
        int n = 0;
        while (lever.step(sensed(at_rest, at_rest, dial_sum), step) > lower_pulse && n < 4000) ++n;
        // The upper stop lets it bounce down with less than the last step's 4.6 mm/s.
        EXPECT_NEAR(n / 1024.0, fall_time(number(lever.length())), 0.006) << dial_sum;
    }
}

// Bounces with half the speed: to about a quarter of the height.
TEST(Lever, BouncesToAQuarterOfTheHeight) {
    Lever<Undamped> lever;
    steps(lever, 3000, sensed(2 * 955, 2 * 100));
    while (lever.step(sensed(at_rest, at_rest), step) > lower_pulse) {
    }
    uint16_t top = 0;
    for (int i = 0; i < 400; ++i) top = std::max(top, lever.step(sensed(at_rest, at_rest), step));
    // Height 0.25 of L: the sine rises from -0.5 to -0.25.
    const double angle = std::asin(-0.25) - std::asin(-0.5);
    EXPECT_NEAR(top - lower_pulse, angle * 1273.24, 12);
}

TEST(Lever, FollowsTheDialWithoutMovingTheServo) {
    Lever<LeverChoices<Q>> lever;
    steps(lever, 1000, sensed(at_rest, at_rest, 0));
    EXPECT_NEAR(number(lever.length()), 0.23, 1e-4);
    double last = number(lever.length());
    for (int i = 0; i < 600; ++i) {
        ASSERT_NEAR(lever.step(sensed(at_rest, at_rest, 2046), step), lower_pulse, 6);
        const double length = number(lever.length());
        ASSERT_GE(length, last);
        ASSERT_LE(length - last, 0.07);
        last = length;
    }
    EXPECT_NEAR(last, 0.48, 1e-3);
}

// Lifting the weight takes a force at the sensors proportional to the arm's length.
TEST(Lever, GivesTheArmItsMechanicalAdvantage) {
    const auto balance = [](int dial_sum) {
        // The smallest reading of sensor a that lifts the arm off its stop.
        for (int sum = at_rest; sum < 2 * 960; ++sum) {
            Lever<Undamped> lever;
            steps(lever, 700, sensed(at_rest, at_rest, dial_sum));
            if (steps(lever, 300, sensed(sum, at_rest, dial_sum)) > lower_pulse + 3)
                return (number(grams<Q, 1>(sum)) - number(grams<Q, 1>(at_rest))) * 9.80665e-3;
        }
        return 0.0;
    };
    // 0.1 kg g L cos 30 = force * 0.04 m
    const double weight = 0.1 * 9.81 * std::cos(std::asin(0.5)) / 0.04;
    EXPECT_NEAR(balance(0), weight * 0.23, 0.06 * weight * 0.23);
    EXPECT_NEAR(balance(2046), weight * 0.48, 0.06 * weight * 0.48);
}

TEST(Lever, DampsWhoPushesAgainstItsMotion) {
    const auto fall_under_push = [](auto& lever) {
        steps(lever, 3000, sensed(2 * 955, 2 * 100));
        int n = 0;
        while (lever.step(sensed(2 * 925, at_rest), step) > lower_pulse && n < 8000) ++n;
        return n;
    };
    Lever<Damped> damped;
    Lever<Undamped> undamped;
    EXPECT_GT(fall_under_push(damped), 1.02 * fall_under_push(undamped));
}

TEST(Lever, BeforeItsFirstReadingsIsShortAndMissesNoSensor) {
    Lever<LeverChoices<Q>> lever;
    EXPECT_TRUE(lever.sensors_connected());
    EXPECT_NEAR(number(lever.length()), 0.23, 1e-4);
}

TEST(Lever, IgnoresADisconnectedSensor) {
    for (const auto& [a, b] : {std::pair{0, int{at_rest}},
                               {int{at_rest}, 0},
                               {2046, int{at_rest}},
                               {int{at_rest}, 2046},
                               {0, 0},
                               {2046, 2046}}) {
        Lever<LeverChoices<Q>> lever;
        steps(lever, 10, sensed(at_rest, at_rest));
        for (int i = 0; i < 2000; ++i) {
            const uint16_t pulse = lever.step(sensed(a, b), step);
            ASSERT_NEAR(pulse, lower_pulse, 4) << a << ' ' << b;
        }
        EXPECT_FALSE(lever.sensors_connected());
        lever.step(sensed(at_rest, at_rest), step);
        EXPECT_TRUE(lever.sensors_connected());
        EXPECT_NEAR(steps(lever, 3000, sensed(2 * 955, 2 * 100)), upper_pulse, 10);
    }
    // One side free and the other pressed hard is a push.
    Lever<LeverChoices<Q>> lever;
    EXPECT_NEAR(steps(lever, 3000, sensed(2 * 950, 0)), upper_pulse, 10);
    EXPECT_TRUE(lever.sensors_connected());
}

// Whatever the converter reads, the commanded pulse stays within the board's travel.
TEST(Lever, SurvivesAnyReadings) {
    Lever<LeverChoices<Q>> lever;
    std::uint32_t random = 1;
    for (int i = 0; i < 200000; ++i) {
        const auto next = [&] { return (random = random * 1664525u + 1013904223u) >> 21; };
        const int pulse = lever.step(sensed(next() % 2047, next() % 2047, next() % 2047), step);
        ASSERT_GT(pulse, 400);
        ASSERT_LT(pulse, 5000);
        ASSERT_GT(number(lever.length()), 0.22);
        ASSERT_LT(number(lever.length()), 0.49);
    }
    EXPECT_NEAR(steps(lever, 5000, sensed(at_rest, at_rest)), lower_pulse, 4);
}

// The table, compared with the published one, reference/published/table_d_2.csv.
TEST(FrameCorrection, IsThePublishedTable) {
    std::ifstream file(source_folder() / "reference/published/table_d_2.csv");
    std::string line;
    std::getline(file, line);
    int rows = 0;
    for (; std::getline(file, line); ++rows) {
        const double acceleration = std::stod(line);
        const double correction = std::stod(line.substr(line.find(',') + 1));
        for (const double sign : {1.0, -1.0}) {
            const Q a = Q::from_raw(static_cast<int32_t>(sign * acceleration * 65536));
            EXPECT_NEAR(number(frame_correction::force(a)), sign * acceleration * correction, 3e-4);
        }
    }
    EXPECT_EQ(rows, 26);
    EXPECT_NEAR(number(frame_correction::force(Q::from_integer(1000))), 30 * 0.049497032, 3e-4);
}

struct Wiring : Configuration {
    static constexpr uint16_t servo_longest = 1667;
    static constexpr uint16_t servo_at_start = 1000;
    static constexpr uint8_t profiled = set_of(Category::step, Category::render);
};

TEST(LeverProgram, StepsOnTimeAndDrawsTwentyFramesASecond) {
    using Board = Host<Wiring>;
    using Program = LeverProgram<Board, LeverChoices<Q>>;
    auto& world = Board::world();
    Program::start();
    for (const Input sensor : {sensor_a, sensor_b}) world.inputs[sensor] = at_rest / 2;
    std::size_t sent = 0;
    int pauses = 0, quiet = 0;
    for (uint32_t tick = 0; tick < ticks_per_second; tick += 200) {
        world.ticks = tick;
        Program::pass();
        world.drain();
        ASSERT_EQ(world.pins, 0);
        if (world.transmitted.size() != sent) quiet = 0;
        if (++quiet == 100) ++pauses;
        sent = world.transmitted.size();
    }
    EXPECT_EQ(Program::steps.given_up(), 0u);
    EXPECT_EQ(Program::steps.late(), 0u);
    EXPECT_NE(world.transmitted.find('#'), std::string::npos);
    EXPECT_EQ(world.pulse, lower_pulse);

    // Nothing moves, so nothing is sent, until a byte requests a full frame.
    const std::size_t before = world.transmitted.size();
    for (uint32_t tick = 0; tick < ticks_per_second / 5; tick += 200) {
        world.ticks += 200;
        Program::pass();
        world.drain();
    }
    EXPECT_EQ(world.transmitted.size(), before);
    world.received = "r";
    for (uint32_t tick = 0; tick < ticks_per_second / 5; tick += 200) {
        world.ticks += 200;
        Program::pass();
        world.drain();
    }
    EXPECT_EQ(world.transmitted.substr(before, 4), "\x1b[2J");
    EXPECT_GT(world.transmitted.size(), before + 30);
}

}  // namespace
}  // namespace firmware
