// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/device_loop.hpp"

#include <gtest/gtest.h>

#include "bench/experiments/haptic/haptic.hpp"
#include "this_build.hpp"

namespace haptic {
namespace {

const Firmware& ours() {
    static const Firmware firmware = firmwares(build_folder() / "firmware").front();
    return firmware;
}

Run run_shortly(const Scenario& scenario) { return run(ours(), scenario, published_parameters()); }

// `fixbench haptic` checks that every scenario stays in its envelope.

// The judge can fail a run: a servo that is blocked permanently neither falls nor rests.
TEST(Judge, FailsALeverThatDoesNotFall) {
    Scenario s = scenario("bounce");
    s.script.faults.push_back({Fault::Kind::stalled, 0, 0.5, 100});
    const auto r = run_shortly(s);
    EXPECT_GE(r.judgement.violations.size(), 2u);
}

TEST(Judge, FailsAClockThatIsTooStrict) {
    Firmware strict = ours();
    strict.limits->lateness = 1e-5;
    strict.limits->cpu_share = 0.1;
    Scenario s = scenario("push_and_hold");
    s.duration = 1;
    s.envelope = {};
    const auto r = run(strict, s, published_parameters());
    EXPECT_GE(r.judgement.violations.size(), 2u);
    EXPECT_GT(r.judgement.late_steps, 10u);
}

// The result does not depend on where the coupling stops to observe.
TEST(DeviceLoop, DoesNotDependOnHowOftenItIsObserved) {
    const Scenario s = scenario("bounce");
    const auto end_of = [&](double interval) {
        DeviceLoop loop(simulator::Elf(ours().elf), published_parameters(), s.script);
        for (double now = interval; now < 1.5; now += interval) loop.run_until(now);
        loop.run_until(1.5);
        return std::tuple(loop.plant().lever_angle(), loop.plant().servo_angle(),
                          loop.chip().cycle(), loop.timing().step_begins.size());
    };
    EXPECT_EQ(end_of(0.1), end_of(0.0007));
}

TEST(DeviceLoop, SendsAFullFrameOnRequest) {
    const Scenario s = scenario("sensor_shorted");
    DeviceLoop loop(simulator::Elf(ours().elf), published_parameters(), s.script);
    loop.run_until(0.5);
    const auto before = loop.timing().bytes_sent;
    loop.run_until(0.7);
    EXPECT_EQ(loop.timing().bytes_sent, before);
    loop.send(' ');
    loop.run_until(0.9);
    EXPECT_GT(loop.timing().bytes_sent, before + 30);
    EXPECT_TRUE(loop.screen_is_right());
}

TEST(Recording, IsAValueChangeDumpInUnitsOf100Picoseconds) {
    const std::string text = value_change_dump({{16, 7, true}, {32, 7, false}, {32, 2, true}});
    EXPECT_NE(text.find("$timescale 100 ps $end"), std::string::npos);
    EXPECT_NE(text.find("#10000\n1h\n#20000\n0h\n1c\n"), std::string::npos);
}

}  // namespace
}  // namespace haptic
