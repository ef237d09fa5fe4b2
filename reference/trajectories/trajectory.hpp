// SPDX-License-Identifier: GPL-3.0-or-later
// The exact motion of each scene: the position and velocity of every particle at given times. Only
// the numbers of a scene are used here (its Parameters<double>); the laws are written
// independently, in closed form where one exists, otherwise in generalised coordinates, integrated
// by GSL.
//
// trajectory(with, times) of each scene's parameters is in one of the two headers included here.
// Times are in seconds, must not be negative and must not decrease. Other times, and parameters for
// which no truth is known, throw std::invalid_argument.
#pragma once

#include <optional>
#include <string_view>

#include "reference/trajectories/closed_forms.hpp"
#include "reference/trajectories/integrated.hpp"
#include "reference/trajectories/state.hpp"

namespace reference {

// The scene of that name with its default parameters; nothing if only its conserved quantities are
// known.
std::optional<Trajectory> trajectory(std::string_view scene, const Times& times);

}  // namespace reference
