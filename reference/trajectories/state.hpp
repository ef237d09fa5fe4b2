// SPDX-License-Identifier: GPL-3.0-or-later
// What a trajectory consists of.
#pragma once

#include <array>
#include <vector>

namespace reference {

struct ParticleState {
    std::array<double, 3> position{};  // m
    std::array<double, 3> velocity{};  // m/s
};
using State = std::vector<ParticleState>;  // in the order in which the scene adds particles
using Trajectory = std::vector<State>;     // one for each time
using Times = std::vector<double>;         // s

}  // namespace reference
