// SPDX-License-Identifier: GPL-3.0-or-later
// The loop of a held lever, linearised, and whether it is stable: the theory that the measured
// region is held against.
//
// Lever with hand, servo and the sensors' lag are linear equations; the firmware's steps and the
// servo's frame are jumps of the state. All of it over one frame of 20 ms is a matrix, and the loop
// is stable where all of its eigenvalues lie within the unit circle (Floquet). Left out: the
// servo's steps and dead band, the limits of its drive, foams that let go, noise, rounding.
//
// After Keemink, van der Kooij and Stienen, "Admittance control for physical human-robot
// interaction", IJRR 37 (2018): the virtual mass must not be too small for the delay of the inner
// loop; Colgate and Schenkel, "Passivity of a class of sampled-data systems", J. Robotic Systems 14
// (1997): what a held sample costs has to be paid for by damping, stiffness x period / 2.
#pragma once

#include <array>
#include <cstddef>

#include "bench/experiments/haptic/plant/parameters.hpp"
#include "bench/experiments/haptic/region/devices.hpp"

namespace haptic::region {

constexpr std::size_t states = 9;
using State = std::array<double, states>;
using Matrix = std::array<State, states>;

// What is asked of the linear loop beside the plant and the firmware's law.
struct Held {
    double arm;                // m, virtual
    double step_takes;         // s
    double width = 4.0 / 3e3;  // s, of the servo's pulse in the middle: it counts when it has ended
};

class LinearLoop {
  public:
    enum Index { lever, lever_speed, servo, servo_speed, force, arm, arm_speed, target, latched };

    LinearLoop(const Parameters& plant, const Law& law, const Held& held);

    // The state a frame of the servo later.
    const Matrix& frame() const { return frame_; }
    State after_frame(const State& state) const;

    struct Verdict {
        double radius;     // factor by which the slowest to decay grows each frame: stable below 1
        double frequency;  // Hz, of that motion
        bool stable() const { return radius < 1; }
    };
    Verdict verdict() const;

  private:
    Matrix frame_;
};

}  // namespace haptic::region
