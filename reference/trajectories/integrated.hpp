// SPDX-License-Identifier: GPL-3.0-or-later
// The motion of scenes by integration.
#pragma once

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <scenes/all.hpp>
#include <stdexcept>

#include "reference/trajectories/chain.hpp"
#include "reference/trajectories/integrate.hpp"
#include "reference/trajectories/state.hpp"
#include "reference/trajectories/vector.hpp"

namespace reference {

// The error allowed in a step of the integration, absolute and relative.
constexpr double default_tolerance = 1e-13;

namespace motion {

// The angle of a rod in the convention of chain.hpp.
inline double angle(double x, double y) { return std::atan2(x, -y); }

// The squared distance of a free fall from rest less the squared length of the rope, in m^2.
struct Reach {
    const scenes::RopeSwing::Parameters<double>& with;
    double operator()(double time) const {
        const double y = with.y - with.gravity / 2 * time * time;
        return with.x * with.x + y * y - with.length * with.length;
    }
};

}  // namespace motion

inline Trajectory trajectory(const scenes::DoublePendulum::Parameters<double>& with,
                             const Times& times, double tolerance = default_tolerance) {
    check(times);
    const double lower = motion::angle(with.lower_x - with.x, with.lower_y - with.y);
    return move({{0, 0},
                 {0, -with.gravity},
                 {{1, with.length, motion::angle(with.x, with.y), 0}, {1, with.length, lower, 0}}},
                times, tolerance);
}

inline Trajectory trajectory(const scenes::ChainOfRods::Parameters<double>& with,
                             const Times& times, double tolerance = default_tolerance) {
    check(times);
    const Link link = {1, with.length, motion::angle(with.x, with.y), 0};
    return move({{0, 0}, {0, -with.gravity}, {scenes::ChainOfRods::links, link}}, times, tolerance);
}

inline Trajectory trajectory(const scenes::ProjectileWithDrag::Parameters<double>& with,
                             const Times& times, double tolerance = default_tolerance) {
    check(times);
    const auto derivative = [&](const double* variables, double* rates) {
        const double vx = variables[2], vy = variables[3];
        const double drag = with.linear + with.quadratic * std::hypot(vx, vy);
        rates[0] = vx;
        rates[1] = vy;
        rates[2] = -drag * vx;
        rates[3] = -drag * vy - with.gravity;
    };
    Trajectory trajectory;
    for (const Variables& now :
         integrate(derivative, {0, 0, with.velocity_x, with.velocity_y}, times, tolerance))
        trajectory.push_back({{{now[0], now[1], 0}, {now[2], now[3], 0}}});
    return trajectory;
}

// The time in s at which the rope of the swing becomes taut, located by root finding.
inline double taut_time(const scenes::RopeSwing::Parameters<double>& with) {
    motion::Reach reach{with};
    // After a fall of twice its diameter, the point is below the rope's circle; at first it is
    // inside.
    const double end = std::sqrt(2 * (std::abs(with.y) + 4 * with.length) / with.gravity);
    if (!(reach(0) < 0))
        throw std::invalid_argument(
            "the swing's motion is known only for a rope slack at the start");
    gsl_function function = {
        [](double time, void* object) { return (*static_cast<motion::Reach*>(object))(time); },
        &reach};
    const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
        gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
    gsl_root_fsolver_set(solver.get(), &function, 0, end);
    for (int i = 0; i < 200; ++i) {
        gsl_root_fsolver_iterate(solver.get());
        const double low = gsl_root_fsolver_x_lower(solver.get());
        const double high = gsl_root_fsolver_x_upper(solver.get());
        if (gsl_root_test_interval(low, high, 1e-15, 1e-15) == GSL_SUCCESS) break;
    }
    return gsl_root_fsolver_root(solver.get());
}

inline Trajectory trajectory(const scenes::RopeSwing::Parameters<double>& with, const Times& times,
                             double tolerance = default_tolerance) {
    check(times);
    const double taut = taut_time(with);
    Trajectory trajectory;
    Times swinging;
    for (double time : times) {
        if (time > taut) {
            swinging.push_back(time - taut);
        } else {
            const double y = with.y - with.gravity / 2 * time * time;
            trajectory.push_back({{{with.x, y, 0}, {0, -with.gravity * time, 0}}});
        }
    }
    // Only the part of the velocity (0, -g t) along the arc remains.
    const double y = with.y - with.gravity / 2 * taut * taut;
    const double first_angle = motion::angle(with.x, y);
    const double speed = -with.gravity * taut * std::sin(first_angle);
    const Chain chain = {
        {0, 0}, {0, -with.gravity}, {{1, with.length, first_angle, speed / with.length}}};
    const double energy = speed * speed / 2 + with.gravity * y;
    if (!(energy < 0))
        throw std::invalid_argument("the swing would rise above the rope's fixed end");
    for (State& state : move(chain, swinging, tolerance)) trajectory.push_back(std::move(state));
    return trajectory;
}

}  // namespace reference
