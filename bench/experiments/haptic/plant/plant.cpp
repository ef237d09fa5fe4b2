// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/plant/plant.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace haptic {
namespace {

constexpr double full_scale = 1023;  // counts of the readings of Parameters::sensor

double elastic_force(const FoamParameters& foam, double compression) {
    const double c = std::max(compression, 0.0), beyond = std::max(c - foam.thickness, 0.0);
    return foam.stiffness * c + foam.hardening * c * c * c + foam.stop_stiffness * beyond;
}

double elastic_energy(const FoamParameters& foam, double compression) {
    const double c = std::max(compression, 0.0), beyond = std::max(c - foam.thickness, 0.0);
    return (foam.stiffness + foam.hardening * c * c / 2) * c * c / 2 +
           foam.stop_stiffness * beyond * beyond / 2;
}

// Foam pushes, but does not pull when it is released faster than it recovers.
double foam_force(const FoamParameters& foam, double compression, double speed) {
    if (compression <= 0) return 0;
    return std::max(elastic_force(foam, compression) + foam.damping * speed, 0.0);
}

}  // namespace

Plant::Plant(Parameters parameters, Script script)
    : parameters_(std::move(parameters)),
      script_(std::move(script)),
      noise_(parameters_.electrical.seed) {
    for (const SensorPoint& point : parameters_.sensor)
        conductance_.push_back({point.force, point.reading / (full_scale - point.reading)});
    const auto falls = [](const SensorPoint& a, const SensorPoint& b) {
        return !(b.force > a.force && b.reading > a.reading);
    };
    if (conductance_.size() < 2 ||
        std::adjacent_find(conductance_.begin(), conductance_.end(), falls) != conductance_.end())
        throw std::invalid_argument("a sensor's curve needs at least two points and must rise");
    servo_.angle = lever_.angle = target_ = script_.hand_angle.at(0);
    for (int sensor : {0, 1}) {
        sensor_force_[sensor] = elastic_force(parameters_.foam, compression(sensor));
        sensor_conductance_[sensor] =
            conductance_of(sensor_force_[sensor]) * parameters_.electrical.sensor_gain[sensor];
    }
}

void Plant::advance_to(double seconds) {
    // A time that is a whole number of steps, except for rounding, belongs to that step.
    const auto due = static_cast<std::int64_t>(std::floor(seconds / parameters_.step + 1e-6));
    while (steps_ < due) step();
}

void Plant::servo_pulse(double width, double at) {
    advance_to(at);
    const ServoParameters& servo = parameters_.servo;
    const double share = std::clamp(
        (width - servo.shortest_pulse) / (servo.longest_pulse - servo.shortest_pulse), 0.0, 1.0);
    target_ = std::round(share * servo.travel / servo.resolution) * servo.resolution;
    driven_ = true;
}

double Plant::compression(int sensor) const {
    const double shift = (lever_.angle - servo_.angle) * parameters_.lever.sensor_radius;
    return parameters_.foam.preload + (sensor == 0 ? shift : -shift);
}

bool Plant::faulty(Fault::Kind kind, int sensor) const {
    return std::any_of(script_.faults.begin(), script_.faults.end(), [&](const Fault& fault) {
        return fault.kind == kind && (kind == Fault::Kind::stalled || fault.sensor == sensor) &&
               time() >= fault.begin && time() < fault.end;
    });
}

// Linear in the force between the points, like a force-sensitive resistor, and beyond the last.
double Plant::conductance_of(double force) const {
    if (force <= conductance_.front().force) return conductance_.front().reading;
    auto next =
        std::upper_bound(conductance_.begin(), conductance_.end(), force,
                         [](double f, const SensorPoint& point) { return f < point.force; });
    if (next == conductance_.end()) --next;
    const SensorPoint &a = *std::prev(next), &b = *next;
    return a.reading + (b.reading - a.reading) * (force - a.force) / (b.force - a.force);
}

double Plant::lever_inertia() const {
    const double length = parameters_.lever.length;
    return parameters_.lever.inertia +
           script_.hand_grip.at(time()) * parameters_.hand.mass * length * length;
}

// The stretch of the hand's spring in m, limited by its force.
double Plant::hand_spring() const {
    const double stretch =
        (script_.hand_angle.at(time()) - lever_.angle) * parameters_.lever.length;
    const double most = parameters_.hand.max_force / parameters_.hand.stiffness;
    return std::clamp(stretch, -most, most);
}

void Plant::step() {
    const LeverParameters& lever = parameters_.lever;
    const ServoParameters& servo = parameters_.servo;
    const double dt = parameters_.step;

    const double shift_speed = (lever_.velocity - servo_.velocity) * lever.sensor_radius;
    for (int sensor : {0, 1})
        sensor_force_[sensor] = foam_force(parameters_.foam, compression(sensor),
                                           sensor == 0 ? shift_speed : -shift_speed);
    const double foam_torque = (sensor_force_[0] - sensor_force_[1]) * lever.sensor_radius;

    const double grip = script_.hand_grip.at(time());
    hand_force_ = script_.hand_force.at(time()) +
                  grip * (parameters_.hand.stiffness * hand_spring() -
                          parameters_.hand.damping * lever_.velocity * lever.length);
    const double friction =
        lever.friction * std::clamp(lever_.velocity / lever.friction_speed, -1.0, 1.0);
    lever_.velocity += (hand_force_ * lever.length - foam_torque - friction) / lever_inertia() * dt;

    if (faulty(Fault::Kind::stalled, 0)) {
        servo_.velocity = 0;
    } else {
        const double error = driven_ ? target_ - servo_.angle : 0;
        const double drive = std::abs(error) <= servo.deadband
                                 ? 0
                                 : std::clamp(error / servo.full_drive_error, -1.0, 1.0);
        const double motor = servo.stall_torque * (drive - servo_.velocity / servo.no_load_speed);
        servo_.velocity += (motor + foam_torque) / servo.inertia * dt;
    }

    // Positions by the new velocities: semi-implicit Euler, which keeps a spring's energy bounded.
    lever_.angle += lever_.velocity * dt;
    servo_.angle += servo_.velocity * dt;
    if (servo_.angle < 0 || servo_.angle > servo.travel) {
        servo_.angle = std::clamp(servo_.angle, 0.0, servo.travel);
        servo_.velocity = 0;
    }

    const double follow = dt / (parameters_.electrical.sensor_lag + dt);
    for (int sensor : {0, 1}) {
        const double conductance =
            conductance_of(sensor_force_[sensor]) * parameters_.electrical.sensor_gain[sensor];
        sensor_conductance_[sensor] += (conductance - sensor_conductance_[sensor]) * follow;
    }
    ++steps_;
}

double Plant::sensor_reading(int sensor) const {
    const double g = sensor_conductance_[sensor];
    return full_scale * g / (1 + g);
}

double Plant::voltage(int channel) {
    const ElectricalParameters& electrical = parameters_.electrical;
    double volts = 0;
    if (channel == electrical.dial_channel) {
        volts = std::clamp(script_.dial.at(time()), 0.0, 1.0) * electrical.supply;
    }
    for (int sensor : {0, 1}) {
        if (channel != electrical.sensor_channel[sensor]) continue;
        if (faulty(Fault::Kind::unplugged, sensor)) {
            volts = 0;
        } else if (faulty(Fault::Kind::shorted, sensor)) {
            volts = electrical.supply;
        } else {
            volts = sensor_reading(sensor) / full_scale * electrical.supply;
        }
    }
    return std::clamp(volts + electrical.noise * noise_.normal(), 0.0, electrical.supply);
}

double Plant::stored_energy() const {
    const double spring = hand_spring();
    return lever_inertia() * lever_.velocity * lever_.velocity / 2 +
           elastic_energy(parameters_.foam, compression(0)) +
           elastic_energy(parameters_.foam, compression(1)) +
           script_.hand_grip.at(time()) * parameters_.hand.stiffness * spring * spring / 2;
}

}  // namespace haptic
