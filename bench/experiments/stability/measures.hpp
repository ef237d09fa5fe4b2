// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of cases: each 1 at its tolerance. In double, from what a state shows.
#pragma once

#include "bench/experiments/stability/cases.hpp"

namespace stability {

double length(Point p);
Point operator-(Point a, Point b);
Point operator+(Point a, Point b);
Point operator*(Point a, double factor);

// The greatest of several.
Measure all_of(std::vector<Measure> measures);
// Only after so many steps.
Measure from_step(unsigned step, Measure measure);

// How far any body is from where it began, against `most`, m.
Measure stays_within(const Description& description, double most);
// The error of the lengths of all rods, as a part of each, against a tolerance.
Measure rods_hold(const Description& description, double tolerance);
// By how much ropes are longer than they are.
Measure ropes_hold(const Description& description, double tolerance);
// The largest penetration of two bodies or of a body and a plane as a part of the radii.
Measure no_overlap(const Description& description, double tolerance);
// Total energy beyond that of the start, as a part of `scale`, J.
double energy(const Description& description, const State& state);
Measure energy_does_not_grow(const Description& description, double tolerance, double scale);
// The centre of mass against where it would be without forces from outside, m.
Measure centre_of_mass_keeps(const Description& description, double tolerance);
// One body's position against a function of time, m.
Measure follows(const Description& description, unsigned body,
                std::function<Point(double time)> truth, double tolerance);
// One body's velocity, m/s.
Measure has_velocity(unsigned body, Point velocity, double tolerance);

// GSL's solvers for stiff equations, for bodies under springs, drag, gravity and constant forces.
enum class Solver { msbdf, bsimp, rk4imp };
// All positions against the solver's at `checks` times spread over the run, m.
Measure follows_solver(const Description& description, Solver solver, double tolerance);
// The angle of a pendulum of one length under gravity from the vertical, released at rest.
std::function<double(double time)> pendulum_angle(double start, double gravity, double length);

}  // namespace stability
