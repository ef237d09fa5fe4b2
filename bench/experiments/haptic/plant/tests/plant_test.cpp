// SPDX-License-Identifier: GPL-3.0-or-later
// The plant, compared with closed forms and conservation laws.
#include "bench/experiments/haptic/plant/plant.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace haptic {
namespace {

double width_for(const Parameters& p, double angle) {
    return p.servo.shortest_pulse +
           angle / p.servo.travel * (p.servo.longest_pulse - p.servo.shortest_pulse);
}

Script stalled_at(double angle) {
    Script script;
    script.hand_angle.from(angle);
    script.faults.push_back({Fault::Kind::stalled, 0, 0, 1e9});
    return script;
}

// The time at which the servo passes an angle.
double time_of(Plant& plant, double angle) {
    while (plant.servo_angle() < angle) {
        plant.advance_to(plant.time() + 1.5 * plant.parameters().step);
        if (plant.time() > 5) throw std::runtime_error("the servo does not get there");
    }
    return plant.time();
}

TEST(Servo, SlewsAtItsNoLoadSpeed) {
    Plant plant(published_parameters(), {});
    plant.servo_pulse(width_for(plant.parameters(), degrees(90)), 0);
    const double begin = time_of(plant, degrees(25)), end = time_of(plant, degrees(85));
    // 0.05 s for 60 degrees without load; the lever that it moves costs a little.
    EXPECT_NEAR(end - begin, 0.05, 0.002);
}

// J dw/dt = T (1 - w / w0) from rest: w = w0 (1 - exp(-t T / (J w0))).
TEST(Servo, SpeedsUpAsAMotorOnAFixedVoltage) {
    Parameters p = published_parameters();
    p.foam.stiffness = p.foam.hardening = p.foam.damping = p.foam.stop_stiffness = 0;
    Plant plant(p, {});
    plant.servo_pulse(width_for(p, degrees(89)), 0);
    const double time = 0.01;
    plant.advance_to(time);
    const double constant = p.servo.inertia * p.servo.no_load_speed / p.servo.stall_torque;
    EXPECT_NEAR(plant.servo_velocity(), p.servo.no_load_speed * (1 - std::exp(-time / constant)),
                0.002 * p.servo.no_load_speed);
}

TEST(Servo, StopsWithinHalfAStepAndTheDeadbandOfThePulse) {
    for (const double angle : {10.0, 33.3, 61.7}) {
        Plant plant(published_parameters(), {});
        for (int frame = 0; frame < 50; ++frame)
            plant.servo_pulse(width_for(plant.parameters(), degrees(angle)), 0.02 * frame);
        plant.advance_to(1.5);
        EXPECT_NEAR(plant.servo_angle(), degrees(angle), degrees(0.29 / 2 + 0.15 + 0.01)) << angle;
        EXPECT_NEAR(plant.servo_velocity(), 0, 1e-6);
    }
}

TEST(Servo, ClampsPulsesAndHasNoDriveBeforeTheFirst) {
    Plant plant(published_parameters(), {});
    plant.advance_to(0.1);
    EXPECT_EQ(plant.servo_angle(), 0);
    plant.servo_pulse(0.1, 0.1);
    EXPECT_LE(plant.servo_target(), plant.parameters().servo.travel + degrees(0.29));
    plant.servo_pulse(0, 0.2);
    EXPECT_EQ(plant.servo_target(), 0);
}

TEST(Servo, AStalledOneDoesNotTurn) {
    Plant plant(published_parameters(), stalled_at(degrees(30)));
    plant.servo_pulse(width_for(plant.parameters(), degrees(60)), 0);
    plant.advance_to(0.5);
    EXPECT_EQ(plant.servo_angle(), degrees(30));
}

// Moments about the pivot: force at the hand x length = net force of the foams x sensor radius.
TEST(Lever, BalancesTheHandAndTheFoams) {
    for (const double force : {-1.5, -0.3, 0.3, 1.0, 2.0}) {
        Script script = stalled_at(degrees(30));
        script.hand_force.from(force);
        Parameters p = published_parameters();
        p.lever.friction = 0;
        Plant plant(p, script);
        plant.advance_to(2);
        EXPECT_NEAR((plant.sensor_force(0) - plant.sensor_force(1)) * p.lever.sensor_radius,
                    force * p.lever.length, 1e-6);
    }
}

// Solved by hand: both foams are pressed, f(c) = k c + h c^3, so that F L / r = f(p + d) - f(p - d)
// = 2 (k + 3 h p^2) d + 2 h d^3.
TEST(Lever, MovesAsFarAsTheCubicSays) {
    Parameters p = published_parameters();
    p.lever.friction = 0;
    const double d = 1.2e-3, k = p.foam.stiffness, h = p.foam.hardening, c = p.foam.preload;
    const double net = 2 * (k + 3 * h * c * c) * d + 2 * h * d * d * d;
    Script script = stalled_at(degrees(30));
    script.hand_force.from(net * p.lever.sensor_radius / p.lever.length);
    Plant plant(p, script);
    plant.advance_to(2);
    EXPECT_NEAR((plant.lever_angle() - degrees(30)) * p.lever.sensor_radius, d, 1e-8);
}

TEST(Foam, EndStopHoldsAHardPush) {
    Script script = stalled_at(degrees(30));
    script.hand_force.from(60);
    Plant plant(published_parameters(), script);
    plant.advance_to(2);
    const Parameters& p = plant.parameters();
    const double shift = (plant.lever_angle() - degrees(30)) * p.lever.sensor_radius;
    const double travel = p.foam.thickness - p.foam.preload;
    EXPECT_GT(shift, travel);
    EXPECT_LT(shift, travel + 60 * p.lever.length / p.lever.sensor_radius / p.foam.stop_stiffness);
    EXPECT_EQ(plant.sensor_force(1), 0);  // the other side is released and does not pull
}

// Pushed, then pulled back faster than the foam recovers.
TEST(Foam, NeverPulls) {
    Script script = stalled_at(degrees(30));
    script.hand_force.from(5).step(0.5, -40);
    Parameters p = published_parameters();
    p.foam.damping = 200;
    Plant plant(p, script);
    bool let_go = false;
    for (double time = 0; time < 0.6; time += p.step) {
        plant.advance_to(time);
        ASSERT_GE(plant.sensor_force(0), 0) << time;
        let_go = let_go || (time > 0.5 && plant.sensor_force(0) == 0);
    }
    EXPECT_TRUE(let_go);
}

double largest_gain_of_energy(Parameters p, double& lost) {
    p.servo.no_load_speed = 1;
    Script script = stalled_at(degrees(30));
    script.hand_grip.from(1);
    script.hand_angle.from(degrees(30)).step(0.001, degrees(32));
    Plant plant(p, script);
    plant.advance_to(0.0015);
    const double begin = plant.stored_energy();
    double least = begin, gain = 0;
    for (double time = 0.0016; time < 1; time += 1e-4) {
        plant.advance_to(time);
        least = std::min(least, plant.stored_energy());
        gain = std::max(gain, plant.stored_energy() - least);
    }
    lost = begin - plant.stored_energy();
    return gain / begin;
}

TEST(Energy, HandAndFoamAreDissipative) {
    double lost = 0;
    EXPECT_LT(largest_gain_of_energy(published_parameters(), lost), 1e-4);
    EXPECT_GT(lost, 0);
}

TEST(Energy, IsKeptWithoutDamping) {
    Parameters p = published_parameters();
    p.foam.damping = p.hand.damping = p.lever.friction = 0;
    double lost = 0;
    EXPECT_LT(largest_gain_of_energy(p, lost), 0.02);  // symplectic: it swings but does not drift
    EXPECT_NEAR(lost, 0, 2e-4);
}

TEST(Sensor, ReadsThePublishedTableBackwards) {
    const Parameters p = published_parameters();
    for (const SensorPoint& point : p.sensor) {
        if (point.reading == 0) continue;
        // The preload that presses each sensor with the force of this point.
        Parameters pressed = p;
        pressed.foam.hardening = 0;
        pressed.foam.thickness = 1;
        pressed.foam.preload = point.force / pressed.foam.stiffness;
        pressed.electrical.noise = 0;
        Plant plant(pressed, stalled_at(degrees(30)));
        EXPECT_NEAR(plant.sensor_reading(0), point.reading, 1e-6);
        EXPECT_NEAR(plant.voltage(1), point.reading * 5 / 1023, 1e-6);
    }
}

// A push that grows faster than the sensor follows: the reading lags behind the force and reaches
// it.
TEST(Sensor, LagsBehindTheForce) {
    Script script = stalled_at(degrees(30));
    script.hand_force.step(0.5, 1);
    Parameters p = published_parameters();
    Plant plant(p, script);
    p.electrical.sensor_lag = 10;
    Plant slow(p, script);
    const double rest = plant.sensor_reading(0);
    plant.advance_to(1.5);
    slow.advance_to(1.5);
    ASSERT_EQ(plant.sensor_force(0), slow.sensor_force(0));
    Parameters pressed = p;  // so that the sensor rests under that force
    pressed.foam.hardening = 0;
    pressed.foam.thickness = 1;
    pressed.foam.preload = plant.sensor_force(0) / pressed.foam.stiffness;
    const double end = Plant(pressed, stalled_at(degrees(30))).sensor_reading(0);
    EXPECT_GT(end, rest + 10);
    EXPECT_NEAR(plant.sensor_reading(0), end, 0.01);
    EXPECT_NEAR((slow.sensor_reading(0) - rest) / (end - rest), 0.1, 0.05);
}

TEST(Sensor, FaultsBeginAndEnd) {
    Script script = stalled_at(degrees(30));
    script.faults.push_back({Fault::Kind::unplugged, 0, 0.1, 0.2});
    script.faults.push_back({Fault::Kind::shorted, 1, 0.15, 0.2});
    Parameters p = published_parameters();
    p.electrical.noise = 0;
    Plant plant(p, script);
    const double rest = plant.voltage(0);
    EXPECT_GT(rest, 3);
    plant.advance_to(0.1601);
    EXPECT_EQ(plant.voltage(0), 0);
    EXPECT_EQ(plant.voltage(1), 5);
    plant.advance_to(0.2001);
    EXPECT_NEAR(plant.voltage(0), rest, 1e-9);
    EXPECT_NEAR(plant.voltage(1), rest, 1e-9);
}

TEST(Sensor, NoiseHasItsStatedSizeAndIsTheSameAgain) {
    Plant one(published_parameters(), stalled_at(degrees(30)));
    Plant other(published_parameters(), stalled_at(degrees(30)));
    const double rest = one.sensor_reading(0) * 5 / 1023;
    double sum = 0, squares = 0;
    constexpr int count = 20000;
    for (int i = 0; i < count; ++i) {
        const double volts = one.voltage(0);
        ASSERT_EQ(volts, other.voltage(0));
        sum += volts - rest;
        squares += (volts - rest) * (volts - rest);
    }
    const double noise = one.parameters().electrical.noise;
    EXPECT_NEAR(sum / count, 0, 5 * noise / std::sqrt(count));
    EXPECT_NEAR(std::sqrt(squares / count) / noise, 1, 0.03);
}

TEST(Plant, DialAndUnusedChannels) {
    Script script;
    script.dial.from(0.25);
    Parameters p = published_parameters();
    p.electrical.noise = 0;
    Plant plant(p, script);
    EXPECT_EQ(plant.voltage(p.electrical.dial_channel), 1.25);
    EXPECT_EQ(plant.voltage(7), 0);
}

// A push against a moving servo: everything together.
Plant busy(double step, int calls) {
    Parameters p = published_parameters();
    p.step = step;
    Script script;
    script.hand_angle.from(degrees(30)).ramp(0.05, 0.2, degrees(36));
    script.hand_grip.from(1).step(0.4, 0);
    Plant plant(p, script);
    for (int frame = 0; frame < 25; ++frame) {
        const double at = 0.02 * frame;
        for (int call = 0; call < calls; ++call) plant.advance_to(at * call / calls);
        const int target = 30 + frame / 5;  // degrees
        plant.servo_pulse(width_for(p, degrees(target)), at);
    }
    plant.advance_to(0.5);
    return plant;
}

TEST(Plant, DoesNotDependOnHowOftenItIsRead) {
    const Plant once = busy(20e-6, 0), often = busy(20e-6, 1000);
    EXPECT_EQ(once.lever_angle(), often.lever_angle());
    EXPECT_EQ(once.lever_velocity(), often.lever_velocity());
    EXPECT_EQ(once.servo_angle(), often.servo_angle());
    EXPECT_EQ(once.sensor_reading(0), often.sensor_reading(0));
}

TEST(Plant, TheStepIsShortEnough) {
    EXPECT_NEAR(busy(20e-6, 0).lever_angle(), busy(1.25e-6, 0).lever_angle(), degrees(0.01));
}

// First order where nothing jumps: half the step, half the error.
TEST(Plant, ConvergesWithTheStep) {
    const auto swing = [](double step) {
        Parameters p = published_parameters();
        p.step = step;
        p.lever.friction = 0;
        Script script = stalled_at(degrees(30));
        script.hand_grip.from(1);
        script.hand_angle.ramp(0, 0.1, degrees(34));
        Plant plant(p, script);
        plant.advance_to(0.06);
        return plant.lever_angle();
    };
    const double exact = swing(0.25e-6);
    const double coarse = swing(40e-6) - exact, fine = swing(20e-6) - exact;
    EXPECT_NEAR(coarse / fine, 2, 0.1);
    EXPECT_LT(std::abs(fine), degrees(0.001));
}

// A pulse between two steps drives the servo from the next one on, like one at the step before and
// unlike one at the step after. Only whole steps have passed when it arrives.
TEST(Plant, APulseBetweenTwoStepsActsFromTheNextOneOn) {
    const auto after_a_pulse_at = [](double steps) {
        Plant plant(published_parameters(), {});
        const double step = plant.parameters().step;
        plant.servo_pulse(width_for(plant.parameters(), degrees(60)), steps * step);
        EXPECT_NEAR(plant.time() / step, std::floor(steps), 1e-9);
        EXPECT_EQ(plant.servo_angle(), 0);
        plant.advance_to(40 * step);
        return plant.servo_angle();
    };
    const double at_step = after_a_pulse_at(10);
    EXPECT_GT(at_step, 0);
    for (const double part : {0.01, 0.25, 0.5, 0.75, 0.99})
        EXPECT_EQ(after_a_pulse_at(10 + part), at_step) << part;
    EXPECT_LT(after_a_pulse_at(11), at_step);
}

// One step from rest, each body by its closed form.
TEST(Plant, AStepIsItsEquations) {
    Parameters p = published_parameters();
    Script script;
    script.hand_angle.from(degrees(30));
    script.hand_force.from(2);
    Plant plant(p, script);
    plant.servo_pulse(width_for(p, degrees(60)), 0);
    plant.advance_to(p.step);
    // The foams balance at rest; the drive is full, and nothing moves yet.
    EXPECT_NEAR(plant.lever_velocity(), 2 * p.lever.length / p.lever.inertia * p.step, 1e-12);
    EXPECT_NEAR(plant.lever_angle() - degrees(30), plant.lever_velocity() * p.step, 1e-15);
    EXPECT_NEAR(plant.servo_velocity(), p.servo.stall_torque / p.servo.inertia * p.step, 1e-12);
    EXPECT_NEAR(plant.servo_angle() - degrees(30), plant.servo_velocity() * p.step, 1e-15);
    EXPECT_NEAR(plant.time(), p.step, 1e-15);
    EXPECT_EQ(plant.hand_force(), 2);
}

TEST(Plant, AWholeNumberOfStepsIsAllOfThem) {
    Plant plant(published_parameters(), stalled_at(0));
    const double step = plant.parameters().step;
    for (int steps = 1; steps < 2000; ++steps) {
        plant.advance_to(steps * 20e-6);
        ASSERT_NEAR(plant.time(), steps * step, step / 100) << steps;
    }
}

TEST(Plant, TimeDoesNotDriftOverHours) {
    Parameters p = published_parameters();
    p.step = 0.02;
    Plant plant(p, stalled_at(0));
    for (int frame = 1; frame <= 180000; ++frame) plant.advance_to(frame * 0.02);
    EXPECT_NEAR(plant.time(), 3600, 1e-9);
}

TEST(Plant, RefusesASensorThatDoesNotRise) {
    Parameters p = published_parameters();
    p.sensor = {{1, 0}};
    EXPECT_THROW(Plant(p, {}), std::invalid_argument);
    p.sensor = {{1, 0}, {2, 10}, {3, 10}};
    EXPECT_THROW(Plant(p, {}), std::invalid_argument);
}

// Each parameter of the family stays within its factor, reaches both sides of it, and varies
// independently.
TEST(Family, KeepsToItsFactors) {
    using Get = double (*)(const Parameters&);
    const std::pair<Get, double> of[] = {
        {[](const Parameters& p) { return p.servo.no_load_speed; }, 1.2},
        {[](const Parameters& p) { return p.servo.stall_torque; }, 1.3},
        {[](const Parameters& p) { return p.servo.full_drive_error; }, 2},
        {[](const Parameters& p) { return p.servo.inertia; }, 2},
        {[](const Parameters& p) { return p.foam.stiffness; }, 1.5},
        {[](const Parameters& p) { return p.foam.hardening; }, 2},
        {[](const Parameters& p) { return p.foam.damping; }, 3},
        {[](const Parameters& p) { return p.foam.preload; }, 1.2},
        {[](const Parameters& p) { return p.lever.inertia; }, 1.5},
        {[](const Parameters& p) { return p.lever.friction; }, 3},
        {[](const Parameters& p) { return p.hand.stiffness; }, 3},
        {[](const Parameters& p) { return p.hand.damping; }, 3},
        {[](const Parameters& p) { return p.hand.mass; }, 3},
        {[](const Parameters& p) { return p.electrical.sensor_gain[0]; }, 1.1},
        {[](const Parameters& p) { return p.electrical.sensor_gain[1]; }, 1.1},
        {[](const Parameters& p) { return p.electrical.sensor_lag; }, 2},
        {[](const Parameters& p) { return p.electrical.noise; }, 2}};
    const Parameters p = published_parameters();
    for (const auto& [get, factor] : of) {
        double least = 1, most = 1;
        for (std::uint64_t seed = 0; seed < 400; ++seed) {
            const double ratio = get(varied(p, seed)) / get(p);
            least = std::min(least, ratio), most = std::max(most, ratio);
        }
        EXPECT_GE(least, 1 / factor - 1e-12);
        EXPECT_LE(most, factor + 1e-12);
        EXPECT_LT(least, 1 - 0.9 * (1 - 1 / factor));
        EXPECT_GT(most, 1 + 0.9 * (factor - 1));
    }
    EXPECT_EQ(varied(p, 7).electrical.seed, 7u);
}

TEST(Family, IsTheSameForASeedAndDiffersBetweenSeeds) {
    const Parameters p = published_parameters();
    EXPECT_EQ(varied(p, 3).foam.stiffness, varied(p, 3).foam.stiffness);
    EXPECT_NE(varied(p, 3).foam.stiffness, varied(p, 4).foam.stiffness);
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Parameters v = varied(p, seed);
        EXPECT_NEAR(std::log(v.hand.stiffness / p.hand.stiffness), 0, std::log(3) + 1e-12);
        EXPECT_NEAR(std::log(v.foam.stiffness / p.foam.stiffness), 0, std::log(1.5) + 1e-12);
    }
}

}  // namespace
}  // namespace haptic
