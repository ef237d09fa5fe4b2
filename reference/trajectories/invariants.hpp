// SPDX-License-Identifier: GPL-3.0-or-later
// Energy and momentum of a scene in a given state.
#pragma once

#include <string_view>

#include "reference/trajectories/state.hpp"

namespace reference {

struct AnchoredSpring {
    std::array<double, 3> anchor{};  // m
    double stiffness = 0;            // N/m
    double rest_length = 0;          // m
};

// The constants that a particle's energy depends on.
struct Mechanics {
    double mass = 1;                // kg; 0 for an immovable particle
    std::array<double, 3> force{};  // N, constant: gravity and the user's force
    AnchoredSpring spring;
};

// One for each particle of the scene of that name, with the scene's default parameters.
std::vector<Mechanics> mechanics(std::string_view scene);

// Kinetic energy, and potential energy of constant forces (0 at the origin) and springs, J.
double energy(const std::vector<Mechanics>& mechanics, const State& state);
// The momentum in kg m/s.
std::array<double, 3> momentum(const std::vector<Mechanics>& mechanics, const State& state);

}  // namespace reference
