// SPDX-License-Identifier: GPL-3.0-or-later
// The exact motion of each scene: the position and velocity of every particle at given times. Only
// the numbers of a scene are used here (its Parameters<double>); the laws are written
// independently, in closed form where one exists, otherwise in generalised coordinates, integrated
// by GSL.
//
// Times are in seconds, must not be negative and must not decrease. Other times, and parameters for
// which no truth is known, throw std::invalid_argument.
#pragma once

#include <array>
#include <optional>
#include <scenes/all.hpp>
#include <string_view>
#include <vector>

namespace reference {

struct ParticleState {
    std::array<double, 3> position{};  // m
    std::array<double, 3> velocity{};  // m/s
};
using State = std::vector<ParticleState>;  // in the order in which the scene adds particles
using Trajectory = std::vector<State>;     // one for each time
using Times = std::vector<double>;         // s

// The error allowed in a step of the integration, absolute and relative.
constexpr double default_tolerance = 1e-13;

// In closed form.
Trajectory trajectory(const scenes::FreeFall::Parameters<double>& with, const Times& times);
Trajectory trajectory(const scenes::SpringAndMass::Parameters<double>& with, const Times& times);
Trajectory trajectory(const scenes::TwoBodyCollision::Parameters<double>& with, const Times& times);
Trajectory trajectory(const scenes::Stack::Parameters<double>& with, const Times& times);
// Every contact with the floor is a bounce, however slow.
Trajectory trajectory(const scenes::BouncingBall::Parameters<double>& with, const Times& times);
Trajectory trajectory(const scenes::Pendulum::Parameters<double>& with, const Times& times);
Trajectory trajectory(const scenes::Lever::Parameters<double>& with, const Times& times);
Trajectory trajectory(const scenes::PublishedLever::Parameters<double>& with, const Times& times);
Trajectory trajectory(const scenes::NewtonsCradle::Parameters<double>& with, const Times& times);

// By integration.
Trajectory trajectory(const scenes::DoublePendulum::Parameters<double>& with, const Times& times,
                      double tolerance = default_tolerance);
Trajectory trajectory(const scenes::ChainOfRods::Parameters<double>& with, const Times& times,
                      double tolerance = default_tolerance);
Trajectory trajectory(const scenes::ProjectileWithDrag::Parameters<double>& with,
                      const Times& times, double tolerance = default_tolerance);
Trajectory trajectory(const scenes::RopeSwing::Parameters<double>& with, const Times& times,
                      double tolerance = default_tolerance);

// The time in s at which the rope of the swing becomes taut, located by root finding.
double taut_time(const scenes::RopeSwing::Parameters<double>& with);

// The scene of that name with its default parameters; nothing if only its conserved quantities are
// known.
std::optional<Trajectory> trajectory(std::string_view scene, const Times& times);

}  // namespace reference
