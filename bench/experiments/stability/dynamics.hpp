// SPDX-License-Identifier: GPL-3.0-or-later
// The long-term behaviour of motion, in every scalar and method, each compared with theory:
//
// - growth: the spectral radius of the map of a step, fitted to the run of a linear spring,
// compared with that of the method's own map, both by GSL's eigenvalues. Above 1 the motion grows;
// - energy: the energy gained up to a number of steps, in windows as long as several periods;
// - reversal: the distance from the start after a run forward and the same run with reversed
// velocities; the theory is the method itself, in double;
// - order: the distance between runs that differ in the order in which rods or springs were added;
// - dead_band: where a damped spring comes to rest, compared with the bound within which
// round-to-nearest stops it; limit_cycle: the period of the motion that remains, compared with
// that of rounded products where rounding undoes the damping, and 1 where the motion comes to rest;
// - divergence: when a chaotic double pendulum has left the same method's run in double by a given
// distance, as a mean over starts drawn from seeds (empty if one of them does not leave it within
// 40 s). The theory is when one ulp (for floats, that of 1 m) has grown to that distance by the
// Lyapunov exponent of the equations of motion. divergence_rate: the growth rate of that distance,
// compared with that exponent.
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
    bool quick = false;  // energies up to 10^5 steps instead of 10^6
};

// A row of dynamics.csv. `measured` is empty if a number of the description does not fit, or if the
// run ended early by an overflow.
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

// The largest magnitude of an eigenvalue of an n x n matrix, stored row by row.
double spectral_radius(std::vector<double> matrix, std::size_t n);
// The map from (x, v) before a step to (x, v) after it, for a spring of frequency omega, 1/s, and
// damping 2 zeta omega, row by row. Throws std::invalid_argument for an unknown method.
std::vector<double> step_map(const std::string& integrator, double omega, double zeta, double dt);
// The least-squares map from each state to the next, with n numbers per state. Empty if the states
// lie on a line, so that more than one map would fit.
std::vector<double> fitted_map(const std::vector<std::vector<double>>& states);

// The period, in steps of h, of a body that swings undamped on a spring of k, 1/s^2, where each
// step adds the product of h and the velocity to the position and subtracts that of h, k and the
// position from the velocity, both rounded to nearest: near the middle and near the turning points
// they round to 0, and the body goes on evenly or waits. `fastest` is its largest velocity, in
// ulps; the result is 1 if it is too slow to move. (L. B. Jackson, An analysis of limit cycles due
// to multiplication rounding in recursive digital filters, 1969, takes rounded products by what
// they do within a cycle, too.)
double rounded_period(double k, double h, double fastest);

std::vector<DynamicsRow> growth_of(const Subject& subject);
std::vector<DynamicsRow> energy_of(const Subject& subject, unsigned longest);
std::vector<DynamicsRow> reversal_of(const Subject& subject);
std::vector<DynamicsRow> order_of(const Subject& subject);
std::vector<DynamicsRow> dead_band_of(const Subject& subject);
std::vector<DynamicsRow> divergence_of(const Subject& subject);

// For each start of divergence_of, by rising seed: when the run has left that in double, in s, and
// the growth rate of the distance, in 1/s. Starts whose run never left it, or failed, are left out.
struct Divergence {
    std::vector<double> times, rates;
};
Divergence divergence(const Subject& subject);
constexpr unsigned chaotic_starts = 16;

// The largest Lyapunov exponent, 1/s, of the double pendulum of divergence_of: a mean over its
// starts and `seconds` from each.
double lyapunov_exponent(unsigned seconds);

// Writes dynamics.csv.
void measure_dynamics(const DynamicsOptions& options);

}  // namespace stability
