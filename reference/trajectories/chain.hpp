// SPDX-License-Identifier: GPL-3.0-or-later
// A chain of rods with a point mass at the end of each, which hangs from a fixed point, in the
// plane. The variables are the angles of the rods.
#pragma once

#include "reference/trajectories/state.hpp"

namespace reference {

struct Link {
    double mass;              // kg, of the point at its end
    double length;            // m
    double angle;             // from (0, -1), towards (1, 0)
    double angular_velocity;  // 1/s
};

struct Chain {
    std::array<double, 2> pivot;         // m
    std::array<double, 2> acceleration;  // m/s^2, of every point without its rods
    std::vector<Link> links;             // from the pivot outwards
};

Trajectory move(const Chain& chain, const Times& times, double tolerance);

}  // namespace reference
