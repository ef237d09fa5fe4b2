// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/trajectories/chain.hpp"

#include <gsl/gsl_linalg.h>

#include <cmath>

#include "reference/trajectories/integrate.hpp"

namespace reference {
namespace {

// Lagrange's equations in the angles. With m_i the mass from link i outwards and k = max(i, j):
//   sum_j m_k L_i L_j cos(a_i - a_j) a_j'' =
//       m_i L_i (g_x cos a_i + g_y sin a_i) - sum_j m_k L_i L_j sin(a_i - a_j) a_j'^2.
void accelerate(const Chain& chain, const double* angles, const double* velocities,
                double* accelerations) {
    const std::size_t count = chain.links.size();
    std::vector<double> beyond(count);
    double mass = 0;
    for (std::size_t i = count; i-- > 0;) beyond[i] = mass += chain.links[i].mass;
    std::vector<double> inertia(count * count), torque(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double length = chain.links[i].length;
        torque[i] = beyond[i] * length *
                    (chain.acceleration[0] * std::cos(angles[i]) +
                     chain.acceleration[1] * std::sin(angles[i]));
        for (std::size_t j = 0; j < count; ++j) {
            const double weight = beyond[std::max(i, j)] * length * chain.links[j].length;
            inertia[i * count + j] = weight * std::cos(angles[i] - angles[j]);
            torque[i] -= weight * std::sin(angles[i] - angles[j]) * velocities[j] * velocities[j];
        }
    }
    auto matrix = gsl_matrix_view_array(inertia.data(), count, count);
    const auto right = gsl_vector_view_array(torque.data(), count);
    auto solution = gsl_vector_view_array(accelerations, count);
    gsl_linalg_cholesky_decomp1(&matrix.matrix);
    gsl_linalg_cholesky_solve(&matrix.matrix, &right.vector, &solution.vector);
}

State state_of(const Chain& chain, const Variables& variables) {
    const std::size_t count = chain.links.size();
    State state;
    ParticleState point;
    point.position = {chain.pivot[0], chain.pivot[1], 0};
    for (std::size_t i = 0; i < count; ++i) {
        const double sine = chain.links[i].length * std::sin(variables[i]);
        const double cosine = chain.links[i].length * std::cos(variables[i]);
        const double rate = variables[count + i];
        point.position[0] += sine;
        point.position[1] -= cosine;
        point.velocity[0] += cosine * rate;
        point.velocity[1] += sine * rate;
        state.push_back(point);
    }
    return state;
}

}  // namespace

Trajectory move(const Chain& chain, const Times& times, double tolerance) {
    const std::size_t count = chain.links.size();
    Variables start(2 * count);
    for (std::size_t i = 0; i < count; ++i) {
        start[i] = chain.links[i].angle;
        start[count + i] = chain.links[i].angular_velocity;
    }
    const auto derivative = [&](const double* variables, double* rates) {
        std::copy_n(variables + count, count, rates);
        accelerate(chain, variables, variables + count, rates + count);
    };
    Trajectory trajectory;
    for (const Variables& variables : integrate(derivative, start, times, tolerance))
        trajectory.push_back(state_of(chain, variables));
    return trajectory;
}

}  // namespace reference
