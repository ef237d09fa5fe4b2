// SPDX-License-Identifier: GPL-3.0-or-later
// The linearised loop of a held lever, and whether it is stable: the theory that the measured
// region is compared with.
//
// Lever with hand, servo and the sensors' lag are linear equations; the firmware's steps and the
// servo's frame are jumps of the state. Together they are a matrix over one frame of 20 ms, and the
// loop is stable if all of its eigenvalues lie within the unit circle (Floquet). Not modelled: the
// servo's steps and dead band, the limits of its drive, foams that let go, noise, rounding.
//
// After Keemink, van der Kooij and Stienen, "Admittance control for physical human-robot
// interaction", IJRR 37 (2018): the virtual mass must not be too small for the delay of the inner
// loop. Colgate and Schenkel, "Passivity of a class of sampled-data systems", J. Robotic Systems 14
// (1997): the energy that a sample and hold adds must be dissipated by damping, stiffness x period
// / 2.
#pragma once

#include <array>
#include <cstddef>

#include "bench/experiments/haptic/plant/parameters.hpp"
#include "bench/experiments/haptic/region/devices.hpp"

namespace haptic::region {

constexpr std::size_t states = 9;
using State = std::array<double, states>;
using Matrix = std::array<State, states>;

// What the linear loop depends on in addition to the plant and the firmware's law.
struct Held {
    double arm;                // m, virtual
    double step_takes;         // s
    double width = 4.0 / 3e3;  // s, of the servo's pulse in the middle; effective when it ends
};

class LinearLoop {
  public:
    enum Index { lever, lever_speed, servo, servo_speed, force, arm, arm_speed, target, latched };

    LinearLoop(const Parameters& plant, const Law& law, const Held& held);

    // Maps the state to that one servo frame later.
    const Matrix& frame() const { return frame_; }
    State after_frame(const State& state) const;

    struct Verdict {
        double radius;     // growth per frame of the mode that decays slowest: stable below 1
        double frequency;  // Hz, of that mode
        bool stable() const { return radius < 1; }
    };
    Verdict verdict() const;

  private:
    Matrix frame_;
};

}  // namespace haptic::region
