// SPDX-License-Identifier: GPL-3.0-or-later
// The families of curves from a reading to grams, in any number type, and their fit to readings.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "bench/experiments/calibration/readings.hpp"

namespace calibration {

enum class Family {
    line,
    rational_quadratic,
    quadratic,
    hyperbola,
    conductance_power,
    monotone_cubic
};
inline constexpr std::array families = {
    Family::line,      Family::rational_quadratic, Family::quadratic,
    Family::hyperbola, Family::conductance_power,  Family::monotone_cubic};

std::string name_of(Family family);
std::string formula_of(Family family);

// The coefficients in the order of the formula's letters; for a monotone cubic (reading, grams,
// slope) of each knot.
struct Curve {
    Family family;
    std::vector<double> coefficients;
};

// The value of the curve's formula, even at poles.
template <class Number>
Number value(const Curve& curve, const Number& x) {
    const std::vector<double>& c = curve.coefficients;
    using std::exp, std::log;
    switch (curve.family) {
        case Family::line:
            return Number(c[0]) * x + Number(c[1]);
        case Family::rational_quadratic:
            return x / ((Number(c[0]) * x + Number(c[1])) * x + Number(c[2]));
        case Family::quadratic:
            return (Number(c[0]) * x + Number(c[1])) * x + Number(c[2]);
        case Family::hyperbola:
            return Number(c[0]) + Number(c[1]) * x / (Number(c[2]) - x);
        case Family::conductance_power:
            if (x <= 0) return Number(c[0]);
            return Number(c[0]) +
                   Number(exp(Number(c[1]) + Number(c[2]) * Number(log(Number(x / (1023 - x))))));
        case Family::monotone_cubic:
            break;
    }
    const std::size_t knots = c.size() / 3;
    std::size_t i = knots - 1;
    while (i > 0 && x < c[3 * i]) --i;
    const Number y0 = c[3 * i + 1], m0 = c[3 * i + 2], d = x - Number(c[3 * i]);
    if (i == knots - 1) return y0 + m0 * d;
    const Number width = Number(c[3 * i + 3]) - Number(c[3 * i]), m1 = c[3 * i + 5];
    const Number secant = (Number(c[3 * i + 4]) - y0) / width, t = d / width;
    return y0 + d * (m0 + t * ((3 * secant - 2 * m0 - m1) + t * (m0 + m1 - 2 * secant)));
}

struct Fit {
    Curve curve;
    std::vector<double> standard_errors;  // of each coefficient; empty for a monotone cubic
    double square_sum;                    // of the residuals, in grams^2
};

// The number of parameters of each fitted family, except the line, which has two. A fit needs more
// readings than parameters.
inline constexpr std::size_t parameters = 3;

// Unweighted least squares in grams. Throws std::runtime_error if there are too few readings or the
// iteration does not converge.
Fit fit(Family family, const std::vector<Reading>& readings);

// The readings between which a curve is used: those around the calibrated ones over which it rises
// and is between 0 and max_grams. Outside them the weight is that of the nearest end.
struct Range {
    int lowest, highest;
};
inline constexpr double max_grams = 2000;  // the FSR 402 is sold for 0.2 to 20 N
Range rising_range(const Curve& curve, const std::vector<Reading>& readings);

double held_value(const Curve& curve, Range range, int reading);

// The sum of the squared residuals of a curve.
double square_sum(const Curve& curve, const std::vector<Reading>& readings);

}  // namespace calibration
