// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/scenarios.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace haptic {
namespace {

// Every scenario runs on a plant whose servo is left alone, and leaves its state finite.
TEST(Scenarios, RunOnThePlant) {
    std::set<std::string> names;
    for (const Scenario& s : scenarios()) {
        EXPECT_TRUE(names.insert(s.name).second) << s.name;
        Plant plant(s.adapted(published_parameters()), s.script);
        plant.advance_to(std::min(s.duration, 3.0));
        EXPECT_TRUE(std::isfinite(plant.lever_angle())) << s.name;
        EXPECT_GT(s.duration, 0);
    }
}

TEST(Scenarios, AreWatchedWhileTheyRun) {
    for (const Scenario& s : scenarios()) {
        const Envelope& e = s.envelope;
        EXPECT_TRUE(e.fall || e.quiet || e.arm || e.rest) << s.name;
        if (e.quiet) {
            EXPECT_LT(e.quiet->from, s.duration) << s.name;
        }
        if (e.arm) {
            EXPECT_LT(e.arm->from, s.duration) << s.name;
        }
        if (e.rest) {
            EXPECT_LT(e.rest->from, s.duration) << s.name;
        }
        for (const Fault& fault : s.script.faults) EXPECT_LT(fault.end, s.duration) << s.name;
    }
}

TEST(Scenarios, AHeldLeverFollowsTheHand) {
    const Scenario s = scenario("push_and_hold");
    Plant plant(published_parameters(), s.script);
    // The servo follows the lever within a frame, as with an ideal firmware.
    for (double time = 0; time < s.duration; time += 0.02) {
        const ServoParameters& servo = plant.parameters().servo;
        const double width =
            servo.shortest_pulse +
            plant.lever_angle() / servo.travel * (servo.longest_pulse - servo.shortest_pulse);
        plant.servo_pulse(width, time);
    }
    EXPECT_NEAR(plant.lever_angle(), degrees(30), degrees(2));
}

TEST(Scenarios, AnUnknownNameListsTheKnown) {
    try {
        scenario("earthquake");
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("poke_while_held"), std::string::npos);
    }
}

}  // namespace
}  // namespace haptic
