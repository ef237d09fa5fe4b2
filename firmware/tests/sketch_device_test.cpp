// SPDX-License-Identifier: GPL-3.0-or-later
// The lever as an Arduino sketch, examples/lever/lever.ino, in the closed loop, with the
// requirements of the lever on the bare chip.
#include <gtest/gtest.h>

#include <algorithm>

#include "bench/experiments/haptic/haptic.hpp"
#include "this_build.hpp"

namespace {

using namespace haptic;

const Firmware& bare() {
    static const Firmware firmware = firmwares(build_folder() / "firmware").front();
    return firmware;
}
Firmware sketch() {
    Firmware firmware = bare();
    firmware.elf = firmware.elf.parent_path() / "lever_arduino.elf";
    return firmware;
}

class SketchInTheLoop : public testing::TestWithParam<const char*> {};

TEST_P(SketchInTheLoop, KeepsItsEnvelopeAndItsTime) {
    const auto r = run(sketch(), scenario(GetParam()), published_parameters());
    for (const std::string& violation : r.judgement.violations) ADD_FAILURE() << violation;
    EXPECT_NEAR(r.judgement.loop_rate, 1024, 1);
}
INSTANTIATE_TEST_SUITE_P(All, SketchInTheLoop,
                         testing::Values("release_and_fall", "poke_while_held", "fast_dial",
                                         "sensor_unplugged"),
                         [](const auto& info) { return std::string(info.param); });

// Pulses every 20 ms, a picture of pivot, rod and weight, and Arduino's clock as well.
TEST(Sketch, PulsesDrawsAndLeavesMillis) {
    DeviceLoop loop(simulator::Elf(sketch().elf), published_parameters(),
                    scenario("push_and_hold").script);
    loop.run_until(2);
    EXPECT_NEAR(static_cast<double>(loop.timing().pulses), 2 / 0.02, 1);
    const auto shown = [&](char character) {
        std::ptrdiff_t cells = 0;
        for (const std::string& line : loop.screen())
            cells += std::count(line.begin(), line.end(), character);
        return cells;
    };
    EXPECT_EQ(shown('#'), 1);
    EXPECT_EQ(shown('o'), 1);
    EXPECT_GT(shown('.'), 5);

    const simulator::Chip& chip = loop.chip();
    const auto at = static_cast<std::uint16_t>(chip.elf().object("timer0_millis").address);
    const unsigned milliseconds = chip.read(at) | chip.read(at + 1) << 8;
    EXPECT_NEAR(milliseconds, 2000, 2);
}

// Arduino's clock interrupt, 93 cycles long, does not move the pulse of a lever at rest.
TEST(Sketch, PulsesToTheMicrosecond) {
    DeviceLoop loop(simulator::Elf(sketch().elf), published_parameters(),
                    scenario("sensor_unplugged").script);
    loop.run_until(3);
    EXPECT_GT(loop.timing().pulses, 140u);
    EXPECT_NEAR(loop.timing().shortest_pulse, 1e-3, 1e-6);
    EXPECT_NEAR(loop.timing().longest_pulse, 1e-3, 1e-6);
    EXPECT_NEAR(loop.timing().longest_period, 0.02, 1e-6);
}

// Both have the same arithmetic: they compute the same for the same inputs at the same time.
TEST(Sketch, MovesTheArmAsTheBareMetalDoes) {
    const auto angle = [](const Firmware& firmware) {
        DeviceLoop loop(simulator::Elf(firmware.elf), published_parameters(),
                        scenario("push_and_hold").script);
        loop.run_until(3);
        return loop.plant().lever_angle();
    };
    EXPECT_NEAR(angle(sketch()), angle(bare()), degrees(1));
}

}  // namespace
