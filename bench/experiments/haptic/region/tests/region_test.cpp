// SPDX-License-Identifier: GPL-3.0-or-later
// The host's loop compared with the chip, and the linear theory with closed forms and the loop
// itself.
#include <gtest/gtest.h>

#include <cmath>
#include <fixedpoint/arithmetic/published.hpp>
#include <numbers>
#include <stdexcept>

#include "bench/experiments/haptic/device_loop.hpp"
#include "bench/experiments/haptic/host_loop.hpp"
#include "bench/experiments/haptic/region/devices.hpp"
#include "bench/experiments/haptic/region/identification.hpp"
#include "bench/experiments/haptic/region/linear_loop.hpp"
#include "this_build.hpp"

namespace haptic::region {
namespace {

constexpr double step_takes = 0.36e-3;
const Law one_kilohertz{std::ldexp(1, -10), 0.02, 0, false};

const std::filesystem::path damped =
    build_folder() / "bench/experiments/haptic/region/held_q16_16_10_damped.elf";

struct Unled : firmware::LeverChoices<float> {
    static constexpr bool selective_damping = false;
    static constexpr float servo_delay() { return 0; }
};
struct Led : firmware::LeverChoices<float> {
    static constexpr bool selective_damping = false;
};

struct PublishedUndamped
    : firmware::PublishedLeverChoices<fixedpoint::Fixed<16, 16, fixedpoint::Published>> {
    static constexpr bool selective_damping = false;
};

// A lever that cannot move, a servo that is where it is told to be, a sensor without lag: what
// remains is the virtual arm on the foam's spring, through a sample that is held for a frame.
Parameters rigid() {
    Parameters p = published_parameters();
    p.hand.stiffness = 1e9;
    p.hand.damping = 1e6;
    p.foam.damping = 0;
    p.foam.hardening = 0;
    p.electrical.sensor_lag = 1e-7;
    p.servo.inertia = 1e-7;  // time constants far below a millisecond
    p.servo.stall_torque = 1e3;
    p.servo.no_load_speed = 1e3 / 0.4;
    p.servo.full_drive_error = 1e3 / 4e5;
    return p;
}

// One frame T of I x'' = -k (x + tau x')_held is [1 - a/2, T - a tau/2; -a/T, 1 - a tau/T] with a =
// k T^2 / I. Its determinant, 1 + a/2 - a tau/T, leaves the unit circle where tau < T/2; by Jury's
// criterion an eigenvalue leaves it through -1 where tau > 2 I / (k T).
TEST(LinearLoop, HasTheClosedFormsWindowOfTheServosLead) {
    const Parameters p = rigid();
    const double period = Schedule::frame, arm = 0.35;
    const double stiffness = 2 * p.foam.stiffness * p.lever.sensor_radius * p.lever.sensor_radius;
    const double inertia = 0.1 * arm * arm;
    // Not in the closed form: the readings' age, which the lead must compensate, too, and the pulse
    // that is commanded before it takes effect, here by a part of a step.
    const double age = Schedule::mean_reading_age();
    const double least = period / 2 + age, most = 2 * inertia / (stiffness * period);
    ASSERT_GT(most, 1.5 * least);
    const auto stable = [&](double lead) {
        const Law law{std::ldexp(1, -16), lead, 0, false};
        return LinearLoop(p, law, {arm, 0, 0}).verdict().stable();
    };
    EXPECT_FALSE(stable(0));
    EXPECT_FALSE(stable(0.95 * least));
    EXPECT_TRUE(stable(1.05 * least));
    EXPECT_TRUE(stable(0.9 * most));
    EXPECT_FALSE(stable(1.1 * most));
}

// Without lead the modulus is sqrt(1 + a/2), and the frequency that of the rotation.
TEST(LinearLoop, GrowsWithoutLeadAsTheDeterminantSays) {
    const Parameters p = rigid();
    const double period = Schedule::frame, arm = 0.45;
    const double stiffness = 2 * p.foam.stiffness * p.lever.sensor_radius * p.lever.sensor_radius;
    const double a = stiffness * period * period / (0.1 * arm * arm);
    // The readings' age is a delay like any other: the determinant gains a age / T.
    const double determinant = 1 + a / 2 + a * Schedule::mean_reading_age() / period;
    const Law law{std::ldexp(1, -16), 0, 0, false};
    const auto verdict = LinearLoop(p, law, {arm, 0, 0}).verdict();
    EXPECT_NEAR(verdict.radius, std::sqrt(determinant), 0.003);
    const double frequency =
        std::acos((1 - a / 4) / std::sqrt(1 + a / 2)) / (2 * std::numbers::pi * period);
    EXPECT_NEAR(verdict.frequency, frequency, 0.05 * frequency);
}

// The verdict agrees with what the model does when it runs freely.
TEST(LinearLoop, DoesWhatItsEigenvaluesSay) {
    for (const double lead : {0.0, 0.02})
        for (const double arm : {0.1, 0.23, 0.48}) {
            Law law = one_kilohertz;
            law.servo_delay = lead;
            const LinearLoop loop(published_parameters(), law, {arm, step_takes});
            State state{};
            state[LinearLoop::lever] = state[LinearLoop::arm] = 1;
            // Rescaled each frame, so that it neither overflows nor vanishes. Its ripple does not
            // matter over this many frames.
            double growth = 0;
            for (int frame = 0; frame < 1300; ++frame) {
                state = loop.after_frame(state);
                double size = 0;
                for (const double each : state) size = std::hypot(size, each);
                for (double& each : state) each /= size;
                if (frame >= 300) growth += std::log(size);
            }
            EXPECT_NEAR(std::exp(growth / 1000), loop.verdict().radius, 0.005)
                << lead << ' ' << arm;
        }
}

TEST(LinearLoop, IsSteadiedByTheDampingAndTheArm) {
    const Parameters p = published_parameters();
    Law law = one_kilohertz;
    law.servo_delay = 0;
    const double bare = LinearLoop(p, law, {0.23, step_takes}).verdict().radius;
    EXPECT_GT(bare, LinearLoop(p, law, {0.48, step_takes}).verdict().radius);
    law.damping = std::ldexp(1, -5);
    EXPECT_GT(bare, LinearLoop(p, law, {0.23, step_takes}).verdict().radius);
}

// A plant without the effects that the theory leaves out, and the firmware in float: where the
// theory predicts growth well beyond 1 the lever swings, where it predicts decay it is at rest.
TEST(LinearLoop, AgreesWithTheFirmwareOnAPlantWithoutStepsAndDeadBand) {
    Parameters p = published_parameters();
    p.servo.resolution = 1e-9;
    p.servo.deadband = 0;
    p.electrical.noise = 0;
    p.lever.friction = 0;
    Law law = one_kilohertz;
    const auto led = LinearLoop(p, law, {0.25, step_takes}).verdict();
    law.servo_delay = 0;
    const auto unled = LinearLoop(p, law, {0.25, step_takes}).verdict();
    EXPECT_LT(led.radius, 0.98);
    EXPECT_GT(unled.radius, 1.05);
    HostLoop<Led> stable(p, Holding(0.25).script, step_takes);
    EXPECT_LT(watch_held(stable).size, degrees(0.5));
    HostLoop<Unled> swings(p, Holding(0.25).script, step_takes);
    const Swing swing = watch_held(swings);
    EXPECT_GT(swing.size, degrees(1.5));
    EXPECT_GE(swing.frequency, 1);
    EXPECT_LE(swing.frequency, unled.frequency + 1);  // the drive's limits make it slower
}

TEST(Swing, HasItsSizeAndFrequency) {
    std::vector<double> angles;
    for (int i = 0; i < 1000; ++i)
        angles.push_back(1 + 0.1 * std::sin(2 * std::numbers::pi * 7 * i / 1000 + 1));
    const Swing swing = swing_of(angles, 1);
    EXPECT_NEAR(swing.size, 0.2, 1e-3);
    EXPECT_EQ(swing.frequency, 7);
    EXPECT_FALSE(swing.at_rest());
    EXPECT_TRUE(swing_of(std::vector<double>(100, 0.3), 1).at_rest());
}

TEST(Holding, PutsTheArmWhereItIsAskedFor) {
    for (const double arm : {0.23, 0.3, 0.48}) {
        HostLoop<firmware::LeverChoices<float>> loop(published_parameters(), Holding(arm).script,
                                                     step_takes);
        loop.run_until(0.9);
        EXPECT_NEAR(loop.lever().length(), arm, 0.002);
    }
}

// The chip keeps the schedule of the host's loop: as many steps, and the lever in the same place as
// on the host, as long as nothing amplifies the microseconds between them.
TEST(HostLoop, AgreesWithTheChip) {
    const Parameters p = published_parameters();
    const Script script = Holding(0.3).script;
    DeviceLoop chip(simulator::Elf(damped), p, script);
    HostLoop<firmware::LeverChoices<firmware::LeverScalar>> host(p, script, step_takes);
    double furthest = 0;
    for (double now = 0.001; now < 1; now += 0.001) {
        chip.run_until(now);
        host.run_until(now);
        furthest =
            std::max(furthest, std::abs(chip.plant().lever_angle() - host.plant().lever_angle()));
    }
    EXPECT_LT(furthest, degrees(1));
    EXPECT_NEAR(static_cast<double>(host.steps()),
                static_cast<double>(chip.timing().step_begins.size()), 1);
    EXPECT_NEAR(host.pulse(), chip.pulse(), 10e-6);
}

// A lever whose sensors are on a frame without inertia falls by gravity alone, from 30 degrees
// above the horizontal to 29 below: the pendulum's integral, whose singular end is removed by theta
// = 30 degrees - u^2.
TEST(Fall, IsThatOfGravityIfNothingPressesTheSensors) {
    Parameters p = published_parameters();
    p.lever.inertia *= 1e-2;
    p.servo.inertia *= 1e-2;
    p.electrical.noise = 0;
    const double top = degrees(30), range = std::sqrt(degrees(59));
    constexpr int steps = 10000;
    double integral = 0;
    for (int i = 0; i < steps; ++i) {
        const double u = (i + 0.5) / steps * range;
        integral += 2 * u / std::sqrt(std::sin(top) - std::sin(top - u * u)) * range / steps;
    }
    const double gravity = std::sqrt(shortest_arm / (2 * 9.81)) * integral;
    EXPECT_NEAR(gravity, 0.2294, 1e-4);
    HostLoop<Led> loop(p, scenario("release_and_fall").script, step_takes);
    const auto fall = watch_fall(loop);
    ASSERT_TRUE(fall);
    EXPECT_NEAR(*fall, gravity, Schedule::frame);
}

// A plant that falls and swings as published does so in a separate loop, too; the others are not
// kept.
TEST(Identification, KeepsThePlantsThatFallAndSwingAsPublished) {
    EXPECT_NEAR(published_fall(), 0.18 * std::sqrt(0.23 / 0.20), 1e-12);
    constexpr double takes = 5.8e-3;
    const Identification found = identify(2, takes, 2);
    ASSERT_TRUE(found.draws.back().as_published);
    std::size_t kept = 0;
    for (const Identification::Draw& draw : found.draws) {
        HostLoop<PublishedUndamped> released(draw.plant, scenario("release_and_fall").script,
                                             takes);
        const double ratio = watch_fall(released).value_or(9) / published_fall();
        HostLoop<PublishedUndamped> held(draw.plant, Holding(shortest_arm).script, takes);
        const bool as_published = ratio >= 0.9 && ratio <= 1.1 && !watch_held(held).at_rest();
        EXPECT_EQ(draw.as_published, as_published) << draw.seed;
        kept += as_published;
    }
    EXPECT_EQ(kept, 2u);
    EXPECT_EQ(found.plants(2).size(), 2u);
    EXPECT_THROW(found.plants(3), std::out_of_range);
    EXPECT_EQ(identify(2, takes, 1).draws.size(), found.draws.size());
}

// At the shortest arm, on plants whose light foams let go of a sensor while the weight is held: on
// the chip, and on the host with the threshold that took this for an unplugged sensor.
TEST(Region, TheShortestArmIsStillWhereAFoamLetsGo) {
    const Parameters light = varied(published_parameters(), 9);
    DeviceLoop chip(simulator::Elf(damped), light,
                    Holding(shortest_arm, Start::released_against).script);
    EXPECT_TRUE(watch_held(chip).at_rest());
    for (const Device& device : changes()) {
        const Swing swing = device.hold(light, shortest_arm, Start::released_against, step_takes);
        if (device.change == "as flashed") {
            EXPECT_TRUE(swing.at_rest());
        } else if (device.change.find("believed") != std::string::npos) {
            EXPECT_FALSE(swing.at_rest());
        }
    }
}

TEST(Devices, AreOfAllArithmeticsRatesAndBothDampings) {
    int of_rate[fastest + 1] = {};
    for (const Device& device : devices()) {
        ++of_rate[device.rate];
        EXPECT_EQ(device.damped, device.law.damping > 0);
        if (device.rate != 0) {
            EXPECT_EQ(device.law.step, std::ldexp(1, -device.rate));
        }
    }
    for (int rate = slowest; rate <= fastest; ++rate) EXPECT_EQ(of_rate[rate], 6);
    EXPECT_EQ(of_rate[0], 2);
}

}  // namespace
}  // namespace haptic::region
