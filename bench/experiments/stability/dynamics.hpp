// SPDX-License-Identifier: GPL-3.0-or-later
// How motion goes on in the long run, in every scalar and method, each against theory:
//
// - growth: the spectral radius of the map of a step, fitted to the run of a linear spring, against
//   that of the method's own map: both by GSL's eigenvalues. Above 1 the motion grows;
// - energy: what energy is gained up to so many steps, in windows as long as several periods;
// - reversal: distance from the start after a run forward and the same run with velocities turned
//   back; the theory is the method's own, in double;
// - order: the distance between runs that differ in the order in which rods or springs were added;
// - dead_band: where a damped spring comes to rest, against the bound within which rounding to
//   nearest holds it; limit_cycle: the period of the motion that stays, where it does not rest;
// - divergence: when a chaotic double pendulum has left the same method's run in double by a
//   distance, in the mean over starts drawn from seeds (empty where one of them does not leave it
//   within 40 s); the theory is when an ulp (of floats, of 1 m) has grown to that distance by the
//   Lyapunov exponent of the equations of motion. divergence_rate: the growth rate of that
//   distance, against that exponent.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/experiments/stability/subject.hpp"
#include "bench/lab/records/record.hpp"

namespace stability {

struct DynamicsOptions {
    std::filesystem::path output;
    unsigned threads = 1;
    bool quick = false;  // energies up to 10^5 steps in place of 10^6
};

// A row of dynamics.csv. An empty `measured` is a run that a number of the description does not
// fit, or that ended early by an overflow.
struct DynamicsRow {
    std::string measure, system, scalar, arithmetic, integrator, parameter;
    double at = 0;
    std::optional<double> measured, theory;
    std::string unit;
    unsigned steps = 0;
    double dt = 0;

    static constexpr auto columns = std::tuple(
        records::column("measure", &DynamicsRow::measure),
        records::column("system", &DynamicsRow::system),
        records::column("scalar", &DynamicsRow::scalar),
        records::column("arithmetic", &DynamicsRow::arithmetic),
        records::column("integrator", &DynamicsRow::integrator),
        records::column("parameter", &DynamicsRow::parameter),
        records::column("at", &DynamicsRow::at),
        records::column("measured", &DynamicsRow::measured),
        records::column("theory", &DynamicsRow::theory),
        records::column("unit", &DynamicsRow::unit), records::column("steps", &DynamicsRow::steps),
        records::column("dt", &DynamicsRow::dt));
};

// The largest magnitude of an eigenvalue of a matrix of n x n, row by row.
double spectral_radius(std::vector<double> matrix, std::size_t n);
// (x, v) after a step from (x, v) before it, of a spring of frequency omega, 1/s, and damping
// 2 zeta omega: row by row. Throws std::invalid_argument for a method that is none.
std::vector<double> step_map(const std::string& integrator, double omega, double zeta, double dt);
// The map that takes each state to the next, in least squares; n numbers a state. Empty where the
// states lie on a line, so that more than one map would do.
std::vector<double> fitted_map(const std::vector<std::vector<double>>& states);

std::vector<DynamicsRow> growth_of(const Subject& subject);
std::vector<DynamicsRow> energy_of(const Subject& subject, unsigned longest);
std::vector<DynamicsRow> reversal_of(const Subject& subject);
std::vector<DynamicsRow> order_of(const Subject& subject);
std::vector<DynamicsRow> dead_band_of(const Subject& subject);
std::vector<DynamicsRow> divergence_of(const Subject& subject);

// Of each start of divergence_of, by rising seed: when the run has left that in double, in s, and
// the rate by which the distance grew, in 1/s. What never left, or failed, is not among them.
struct Divergence {
    std::vector<double> times, rates;
};
Divergence divergence(const Subject& subject);
constexpr unsigned chaotic_starts = 16;

// The largest Lyapunov exponent, 1/s, of the double pendulum of divergence_of, in the mean over its
// starts and so many seconds from each.
double lyapunov_exponent(unsigned seconds);

// Writes dynamics.csv.
void measure_dynamics(const DynamicsOptions& options);

}  // namespace stability
