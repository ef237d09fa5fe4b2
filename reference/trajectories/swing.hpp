// SPDX-License-Identifier: GPL-3.0-or-later
// A point on a rod about a pivot, released at rest under a constant acceleration: the pendulum in
// closed form by Jacobi's elliptic functions, for every amplitude below half a turn.
#pragma once

#include "reference/trajectories/state.hpp"

namespace reference {

struct Swing {
    std::array<double, 2> pivot;         // m
    std::array<double, 2> start;         // m
    std::array<double, 2> acceleration;  // m/s^2, not zero
};

// The state at `time`, in s.
ParticleState at(const Swing& swing, double time);

// The period of a full swing back and forth, in s.
double period(const Swing& swing);

}  // namespace reference
