// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/region/linear_loop.hpp"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>

#include "bench/experiments/haptic/schedule.hpp"

namespace haptic::region {
namespace {

constexpr double weight_mass = 0.1, gravity = 9.81, tolerated_push = 0.5;  // kg, m/s^2, N

Matrix identity() {
    Matrix m{};
    for (std::size_t i = 0; i < states; ++i) m[i][i] = 1;
    return m;
}

Matrix operator*(const Matrix& a, const Matrix& b) {
    Matrix product{};
    for (std::size_t i = 0; i < states; ++i)
        for (std::size_t j = 0; j < states; ++j)
            for (std::size_t k = 0; k < states; ++k) product[i][j] += a[i][k] * b[k][j];
    return product;
}

Matrix exponential(const Matrix& a) {
    Matrix copy = a, result{};
    gsl_matrix_view in = gsl_matrix_view_array(copy[0].data(), states, states);
    gsl_matrix_view out = gsl_matrix_view_array(result[0].data(), states, states);
    gsl_linalg_exponential_ss(&in.matrix, &out.matrix, GSL_PREC_DOUBLE);
    return result;
}

// Rates of change between two steps of the firmware.
Matrix motion(const Parameters& p, double reading_age) {
    using L = LinearLoop;
    const double radius = p.lever.sensor_radius, c = p.foam.preload;
    // Of both foams, each compressed by its preload.
    const double stiffness = 2 * (p.foam.stiffness + 3 * p.foam.hardening * c * c);
    const double damping = 2 * p.foam.damping;
    const double hand = p.lever.length * p.lever.length;
    const double inertia = p.lever.inertia + p.hand.mass * hand;

    // The net force of the foams, N, by state variable.
    State net{};
    net[L::lever] = stiffness * radius;
    net[L::servo] = -net[L::lever];
    net[L::lever_speed] = damping * radius;
    net[L::servo_speed] = -net[L::lever_speed];

    Matrix a{};
    a[L::lever][L::lever_speed] = 1;
    a[L::servo][L::servo_speed] = 1;
    for (std::size_t i = 0; i < states; ++i) {
        a[L::lever_speed][i] = -net[i] * radius / inertia;
        a[L::servo_speed][i] = net[i] * radius / p.servo.inertia;
        a[L::force][i] = net[i] / (p.electrical.sensor_lag + reading_age);
    }
    a[L::lever_speed][L::lever] -= p.hand.stiffness * hand / inertia;
    a[L::lever_speed][L::lever_speed] -= p.hand.damping * hand / inertia;
    const double drive = p.servo.stall_torque / p.servo.full_drive_error / p.servo.inertia;
    a[L::servo_speed][L::target] += drive;
    a[L::servo_speed][L::servo] -= drive;
    a[L::servo_speed][L::servo_speed] -=
        p.servo.stall_torque / p.servo.no_load_speed / p.servo.inertia;
    a[L::force][L::force] -= 1 / (p.electrical.sensor_lag + reading_age);
    return a;
}

// The firmware's step. The damping acts while the arm moves down, against the weight that the hand
// carries, which is half of the time: on average that is its square root.
Matrix step_of(const Parameters& p, const Law& law, double arm, double dt) {
    using L = LinearLoop;
    const double slowed = 1 - law.damping * (1 - tolerated_push / (weight_mass * gravity));
    const double kept = std::sqrt(slowed);
    const double push = p.lever.sensor_radius / (weight_mass * arm * arm) * dt;
    Matrix m = identity();
    m[L::arm_speed][L::arm_speed] = kept;
    m[L::arm_speed][L::force] = push;
    m[L::arm][L::arm_speed] = dt * kept;
    if (!law.position_first) m[L::arm][L::force] = dt * push;
    return m;
}

// The pulse that starts now is for the arm's future position.
Matrix latch(double servo_delay) {
    using L = LinearLoop;
    Matrix m = identity();
    m[L::latched] = {};
    m[L::latched][L::arm] = 1;
    m[L::latched][L::arm_speed] = servo_delay;
    return m;
}

Matrix apply() {
    using L = LinearLoop;
    Matrix m = identity();
    m[L::target] = {};
    m[L::target][L::latched] = 1;
    return m;
}

}  // namespace

// The frame is divided into the nearest whole number of steps. It starts at the end of a pulse; the
// next pulse was commanded some steps before its end.
LinearLoop::LinearLoop(const Parameters& plant, const Law& law, const Held& held) {
    const int steps = std::max(1, static_cast<int>(std::lround(Schedule::frame / law.step)));
    const double dt = Schedule::frame / steps;
    const int told = static_cast<int>(std::lround((held.width + held.step_takes) / dt)) % steps;
    const Matrix between = exponential([&] {
        Matrix a = motion(plant, Schedule::mean_reading_age());
        for (State& row : a)
            for (double& cell : row) cell *= dt;
        return a;
    }());
    const Matrix step = step_of(plant, law, held.arm, dt) * between;
    frame_ = identity();
    for (int i = 1; i <= steps; ++i) {
        frame_ = step * frame_;
        if (i == steps - told) frame_ = latch(law.servo_delay) * frame_;
    }
    frame_ = apply() * frame_;
}

State LinearLoop::after_frame(const State& state) const {
    State next{};
    for (std::size_t i = 0; i < states; ++i)
        for (std::size_t j = 0; j < states; ++j) next[i] += frame_[i][j] * state[j];
    return next;
}

LinearLoop::Verdict LinearLoop::verdict() const {
    Matrix copy = frame_;
    gsl_matrix_view matrix = gsl_matrix_view_array(copy[0].data(), states, states);
    const std::unique_ptr<gsl_vector_complex, decltype(&gsl_vector_complex_free)> values(
        gsl_vector_complex_alloc(states), gsl_vector_complex_free);
    const std::unique_ptr<gsl_eigen_nonsymm_workspace, decltype(&gsl_eigen_nonsymm_free)> room(
        gsl_eigen_nonsymm_alloc(states), gsl_eigen_nonsymm_free);
    gsl_eigen_nonsymm(&matrix.matrix, values.get(), room.get());
    std::complex<double> most;
    for (std::size_t i = 0; i < states; ++i) {
        const gsl_complex value = gsl_vector_complex_get(values.get(), i);
        const std::complex<double> z(GSL_REAL(value), GSL_IMAG(value));
        if (std::abs(z) > std::abs(most)) most = z;
    }
    return {std::abs(most), std::abs(std::arg(most)) / (2 * std::numbers::pi * Schedule::frame)};
}

}  // namespace haptic::region
