// SPDX-License-Identifier: GPL-3.0-or-later
// The true motion of each scene: where every particle is, and how fast, at given times. Of a scene
// only the numbers are known here (its Parameters<double>); the laws are written anew, in closed
// form where there is one, else in generalised coordinates and integrated by GSL.
//
// Times are in seconds, not negative and never falling; what breaks that, and parameters that no
// truth is known for, throw std::invalid_argument.
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

// The error that the integration may make in a step, absolute and relative.
constexpr double default_tolerance = 1e-13;

// In closed form.
Trajectory trajectory(const scenes::FreeFall::Parameters<double>& with, const Times& times);
Trajectory trajectory(const scenes::SpringAndMass::Parameters<double>& with, const Times& times);
Trajectory trajectory(const scenes::TwoBodyCollision::Parameters<double>& with, const Times& times);
Trajectory trajectory(const scenes::Stack::Parameters<double>& with, const Times& times);
// Every bounce is one, however slow.
Trajectory trajectory(const scenes::BouncingBall::Parameters<double>& with, const Times& times);
Trajectory trajectory(const scenes::Pendulum::Parameters<double>& with, const Times& times);
Trajectory trajectory(const scenes::Lever::Parameters<double>& with, const Times& times);
Trajectory trajectory(const scenes::PublishedLever::Parameters<double>& with, const Times& times);
Trajectory trajectory(const scenes::NewtonsCradle::Parameters<double>& with, const Times& times);

// Integrated.
Trajectory trajectory(const scenes::DoublePendulum::Parameters<double>& with, const Times& times,
                      double tolerance = default_tolerance);
Trajectory trajectory(const scenes::ChainOfRods::Parameters<double>& with, const Times& times,
                      double tolerance = default_tolerance);
Trajectory trajectory(const scenes::ProjectileWithDrag::Parameters<double>& with,
                      const Times& times, double tolerance = default_tolerance);
Trajectory trajectory(const scenes::RopeSwing::Parameters<double>& with, const Times& times,
                      double tolerance = default_tolerance);

// When the rope of the swing becomes taut, s: the event is located by root finding.
double taut_time(const scenes::RopeSwing::Parameters<double>& with);

// The scene of that name with the numbers of its own; nothing where only conserved quantities are
// known of it.
std::optional<Trajectory> trajectory(std::string_view scene, const Times& times);

}  // namespace reference
