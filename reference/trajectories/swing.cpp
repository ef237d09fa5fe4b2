// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/trajectories/swing.hpp"

#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>

#include <cmath>

namespace reference {
namespace {

struct Shape {
    double length;     // m
    double lowest;     // direction of the acceleration, radians from the x axis
    double frequency;  // of small swings, 1/s
    double modulus;    // sin(amplitude / 2), with the sign of the first angle
};

Shape shape_of(const Swing& swing) {
    const double x = swing.start[0] - swing.pivot[0], y = swing.start[1] - swing.pivot[1];
    const auto [ax, ay] = swing.acceleration;
    const double length = std::hypot(x, y);
    const double amplitude = std::atan2(ax * y - ay * x, ax * x + ay * y);
    return {length, std::atan2(ay, ax), std::sqrt(std::hypot(ax, ay) / length),
            std::sin(amplitude / 2)};
}

}  // namespace

// sin(angle / 2) = k cd(w t, k^2), and so angle' = -2 k w sqrt(1 - k^2) sd(w t, k^2).
ParticleState at(const Swing& swing, double time) {
    const Shape shape = shape_of(swing);
    const double k = shape.modulus;
    double sn, cn, dn;
    gsl_sf_elljac_e(shape.frequency * time, k * k, &sn, &cn, &dn);
    const double angle = shape.lowest + 2 * std::asin(k * cn / dn);
    const double speed = -2 * k * shape.frequency * std::sqrt(1 - k * k) * sn / dn * shape.length;
    ParticleState state;
    state.position = {swing.pivot[0] + shape.length * std::cos(angle),
                      swing.pivot[1] + shape.length * std::sin(angle), 0};
    state.velocity = {-speed * std::sin(angle), speed * std::cos(angle), 0};
    return state;
}

double period(const Swing& swing) {
    const Shape shape = shape_of(swing);
    return 4 * gsl_sf_ellint_Kcomp(shape.modulus, GSL_PREC_DOUBLE) / shape.frequency;
}

}  // namespace reference
