// SPDX-License-Identifier: GPL-3.0-or-later
// The lever as seen by the chip: servo, lever between two foam-covered force sensors on the servo's
// frame, hand, dial, and the voltages of the sensors' dividers. Depends on neither a chip nor a
// firmware.
//
// Time advances in whole steps from 0, so that the state at a time depends only on the pulses and
// the script, not on how often it was asked for: the coupling to a chip may be as lazy as it likes.
// Angles are the servo's, in rad; 0 is the position for the shortest pulse.
#pragma once

#include <cstdint>

#include "bench/experiments/haptic/plant/parameters.hpp"
#include "bench/experiments/haptic/plant/random.hpp"
#include "bench/experiments/haptic/plant/script.hpp"

namespace haptic {

class Plant {
  public:
    // Everything rests at the angle at which the hand wants the lever at the start of the script.
    // Throws std::invalid_argument if the sensor's curve has fewer than two points or does not
    // rise.
    Plant(Parameters parameters, Script script);

    // Advances to the last whole step at or before `seconds`. A time before the present does
    // nothing.
    void advance_to(double seconds);

    // A pulse of `width` seconds that ended at `at`; the servo follows it from then on. Before the
    // first pulse the servo has no drive. A pulse that is too short or too long counts as the
    // shortest or longest.
    void servo_pulse(double width, double at);

    // The voltage at a channel of the converter now, 0..supply, with noise: two calls return two
    // values. A channel that nothing is wired to reads 0.
    double voltage(int channel);

    // The true state.
    double time() const { return static_cast<double>(steps_) * parameters_.step; }
    double lever_angle() const { return lever_.angle; }
    double lever_velocity() const { return lever_.velocity; }
    double servo_angle() const { return servo_.angle; }
    double servo_velocity() const { return servo_.velocity; }
    double servo_target() const { return target_; }
    double sensor_force(int sensor) const { return sensor_force_[sensor]; }  // N, on the foam
    double sensor_reading(int sensor) const;           // counts, without noise, rounding or fault
    double hand_force() const { return hand_force_; }  // N at the lever's end
    // The kinetic energy of the lever (and the hand) and the energy stored in foam and hand: J,
    // relative to a foam at rest without preload.
    double stored_energy() const;
    const Parameters& parameters() const { return parameters_; }

    // The future of the script. A change takes effect from now on.
    Script& script() { return script_; }

  private:
    struct Body {
        double angle, velocity;
    };
    void step();
    double compression(int sensor) const;
    bool faulty(Fault::Kind kind, int sensor) const;
    double conductance_of(double force) const;
    double lever_inertia() const;
    double hand_spring() const;

    Parameters parameters_;
    Script script_;
    std::vector<SensorPoint>
        conductance_;  // `reading` is the conductance in units of the divider's
    Random noise_;
    std::int64_t steps_ = 0;
    Body servo_{}, lever_{};
    double target_ = 0;
    bool driven_ = false;
    double sensor_force_[2] = {}, sensor_conductance_[2] = {};
    double hand_force_ = 0;
};

}  // namespace haptic
