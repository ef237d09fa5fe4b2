// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of cases. Each is 1 at its tolerance, is computed in double from a state, and says in
// words what it allows.
#pragma once

#include "bench/experiments/stability/cases.hpp"

namespace stability {

// A number and its unit, as in the words of a measure.
std::string in_words(double number, const char* unit);

double length(Point p);
Point operator-(Point a, Point b);
Point operator+(Point a, Point b);
Point operator*(Point a, double factor);

// The largest of several measures.
Measure all_of(std::vector<Measure> measures);
// Only after that many steps.
Measure from_step(unsigned step, Measure measure);

// The largest distance of a body from its start, relative to `most`, m.
Measure stays_within(const Description& description, double most);
// The relative error of the lengths of all rods, relative to a tolerance.
Measure rods_hold(const Description& description, double tolerance);
// By how much ropes exceed their lengths.
Measure ropes_hold(const Description& description, double tolerance);
// The largest penetration of two bodies, or of a body and a plane, relative to the radii.
Measure no_overlap(const Description& description, double tolerance);
// The total energy beyond that at the start, relative to `scale`, J.
double energy(const Description& description, const State& state);
Measure energy_does_not_grow(const Description& description, double tolerance, double scale);
// The distance of the centre of mass from where it would be without external forces, m.
Measure centre_of_mass_keeps(const Description& description, double tolerance);
// The distance of one body's position from a function of time, m.
Measure follows(const Description& description, unsigned body,
                std::function<Point(double time)> truth, double tolerance);
// The difference of one body's velocity, m/s.
Measure has_velocity(unsigned body, Point velocity, double tolerance);

// GSL's solvers for stiff equations, for bodies under springs, drag, gravity and constant forces.
enum class Solver { msbdf, bsimp, rk4imp };
// The distance of all positions from the solver's at `checks` times distributed over the run, m.
Measure follows_solver(const Description& description, Solver solver, double tolerance);
// The angle from the vertical of a pendulum of one length under gravity, released at rest.
std::function<double(double time)> pendulum_angle(double start, double gravity, double length);

}  // namespace stability
