// SPDX-License-Identifier: GPL-3.0-or-later
// Every number of the plant, in SI units, each with its source: `published` (the 2016 design or its
// tables, reference/published/), `data sheet`, or `assumed`. Absolute results depend on what is
// assumed: judge trends and envelopes over a family of plants, never a trace of one.
#pragma once

#include <cstdint>
#include <numbers>
#include <vector>

namespace haptic {

constexpr double degrees(double angle) { return angle * std::numbers::pi / 180; }

// A point of a force sensor's curve; the reading is that of a converter with 1023 counts at 5 V.
struct SensorPoint {
    double force;  // N
    double reading;
};

struct ServoParameters {
    double shortest_pulse = 1e-3;       // s, at angle 0: the hobby servo protocol, assumed
    double longest_pulse = 2e-3;        // s, at the end of the travel: likewise assumed
    double travel = degrees(90);        // rad: assumed, 0 to 60 or 65 degrees are used
    double resolution = degrees(0.29);  // rad: published
    double deadband = degrees(0.15);    // rad: assumed, half a step
    // The drive: torque = stall_torque (drive - speed / no_load_speed), -1 <= drive <= 1, as for a
    // motor at a constant voltage.
    double no_load_speed = degrees(60) / 0.05;    // rad/s: published, REXHobby FS0521HV
    double stall_torque = 21.3 * 9.80665 * 0.01;  // N m: published, 21.3 kg cm
    double full_drive_error = degrees(3);         // rad of error for full drive: assumed
    double inertia = 1e-3;  // kg m^2 at the shaft: assumed, a time constant of 10 ms
};

// One side of the foam pair: force = stiffness c + hardening c^3, plus that of the end stop beyond
// `thickness`; c >= 0 is the compression. The damping is proportional to the speed, and the foam
// never pulls.
struct FoamParameters {
    double stiffness = 1900;      // N/m: assumed, for 5 N at the preload: in the sensors' range
    double hardening = 1.5e8;     // N/m^3: assumed
    double damping = 4;           // N s/m: assumed
    double preload = 2e-3;        // m of compression at rest: published
    double thickness = 4e-3;      // m: published, a travel of 2 mm beyond the preload
    double stop_stiffness = 2e5;  // N/m: assumed
};

struct LeverParameters {
    // kg m^2 about the pivot: published. Table D.2 levels off at 0.06 N per m/s^2, which is inertia
    // / (sensor_radius length) for an acceleration of the lever's end.
    double inertia = 0.06 * 0.04 * 0.198;
    double sensor_radius = 0.04;   // m: published
    double length = 0.198;         // m, pivot to hand: published, 0.97 cm at 2.8 degrees
    double friction = 1e-3;        // N m of dry friction in the pivot: assumed
    double friction_speed = 0.01;  // rad/s: below it, friction is proportional to speed: assumed
};

struct HandParameters {
    double stiffness = 300;  // N/m: assumed, of a finger pressing lightly; 100 to 1000 in studies
    double damping = 3;      // N s/m: assumed
    double mass = 0.05;      // kg moving along while the hand holds on: assumed
    double max_force = 15;   // N: assumed
};

struct ElectricalParameters {
    double supply = 5;               // V: published
    double sensor_gain[2] = {1, 1};  // of the conductance: parts differ by some percent: data sheet
    double sensor_lag = 1e-3;  // s, time constant of the sensor: data sheet, rises in under 3 ms
    double noise = 1.5e-3;     // V rms at the converter: assumed, a third of a count
    int sensor_channel[2] = {0, 1};  // of the ADC: the one pressed by rising angles first
    int dial_channel = 2;
    std::uint64_t seed = 1;  // of the noise
};

struct Parameters {
    ServoParameters servo;
    FoamParameters foam;
    LeverParameters lever;
    HandParameters hand;
    ElectricalParameters electrical;
    std::vector<SensorPoint> sensor;  // by rising force; at the first point the reading is 0
    double step = 20e-6;              // s, of the integration
};

// The plant as published, its sensors by Table D.1.
Parameters published_parameters();

// A number that data sheets or studies leave open by a factor, in either direction.
struct Uncertain {
    const char* name;
    double factor;
    double& (*of)(Parameters&);
};
const std::vector<Uncertain>& uncertain();

// A member of a family of plants: each uncertain number is multiplied by a factor drawn
// log-uniformly from its range. The same seed gives the same plant on every machine.
Parameters varied(const Parameters& parameters, std::uint64_t seed);

}  // namespace haptic
