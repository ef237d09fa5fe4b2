// SPDX-License-Identifier: GPL-3.0-or-later
// Levenberg-Marquardt by GSL in coordinates in which all coefficients are of order one: s = reading
// / 1024, and kilograms. In grams and counts those of the published family differ by five decades,
// and the normal equations by ten.
#include <fmt/format.h>
#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_interp.h>
#include <gsl/gsl_multifit.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <functional>
#include <memory>
#include <stdexcept>

#include "bench/experiments/calibration/curve.hpp"

namespace calibration {
namespace {

constexpr double counts = 1024, grams = 1000, full_scale = 1023 / counts;
using Parameters = std::array<double, parameters>;

using Vector = std::unique_ptr<gsl_vector, void (*)(gsl_vector*)>;
using Matrix = std::unique_ptr<gsl_matrix, void (*)(gsl_matrix*)>;
Vector vector(std::size_t n) { return {gsl_vector_alloc(n), gsl_vector_free}; }
Matrix matrix(std::size_t n, std::size_t m) { return {gsl_matrix_alloc(n, m), gsl_matrix_free}; }

struct Point {
    double s, y;
};

// A family in scaled coordinates: its value and its derivative with respect to each parameter.
struct Model {
    std::function<double(const Parameters&, double s, Parameters& derivative)> value;
    Parameters start;
};

double conductance(double s) { return s / (full_scale - s); }

// The linear least squares solution of `basis` to weighted points.
std::vector<double> linear(const std::vector<Point>& points, std::size_t terms,
                           const std::function<double(std::size_t, const Point&)>& basis,
                           const std::function<double(const Point&)>& target,
                           double* square_sum = nullptr, std::vector<double>* errors = nullptr) {
    const std::size_t n = points.size();
    const Matrix x = matrix(n, terms), covariance = matrix(terms, terms);
    const Vector y = vector(n), c = vector(terms);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < terms; ++j) gsl_matrix_set(x.get(), i, j, basis(j, points[i]));
        gsl_vector_set(y.get(), i, target(points[i]));
    }
    const std::unique_ptr<gsl_multifit_linear_workspace, void (*)(gsl_multifit_linear_workspace*)>
        workspace(gsl_multifit_linear_alloc(n, terms), gsl_multifit_linear_free);
    double residual = 0;
    gsl_multifit_linear(x.get(), y.get(), c.get(), covariance.get(), &residual, workspace.get());
    if (square_sum != nullptr) *square_sum = residual;
    std::vector<double> result;
    for (std::size_t j = 0; j < terms; ++j) {
        result.push_back(gsl_vector_get(c.get(), j));
        if (errors != nullptr) errors->push_back(std::sqrt(gsl_matrix_get(covariance.get(), j, j)));
    }
    return result;
}

// The best shape of a grid, each with its best offset and scale.
Parameters best_start(const std::vector<Point>& points, const std::vector<double>& grid,
                      const std::function<double(double shape, double s)>& basis) {
    Parameters best{};
    double least = INFINITY;
    for (const double shape : grid) {
        double residual = 0;
        const auto c = linear(
            points, 2,
            [&](std::size_t j, const Point& p) { return j == 0 ? 1.0 : basis(shape, p.s); },
            [](const Point& p) { return p.y; }, &residual);
        if (residual < least) {
            least = residual;
            best = {c[0], c[1], shape};
        }
    }
    return best;
}

Model model_of(Family family, const std::vector<Point>& points) {
    if (family == Family::rational_quadratic) {
        // s / y is a polynomial; weighted by y^2 / s, its residual is close to that of y.
        const auto start = linear(
            points, 3,
            [](std::size_t j, const Point& p) { return std::pow(p.s, 2.0 - double(j)) * p.y; },
            [](const Point& p) { return p.s; });
        return {[](const Parameters& c, double s, Parameters& derivative) {
                    const double d = (c[0] * s + c[1]) * s + c[2], slope = -s / (d * d);
                    derivative = {slope * s * s, slope * s, slope};
                    return s / d;
                },
                {start[0], start[1], start[2]}};
    }
    std::vector<double> grid;
    if (family == Family::hyperbola) {
        for (double gap = 0.003; gap < 2; gap *= 1.3) grid.push_back(points.back().s + gap);
        const auto basis = [](double pole, double s) { return s / (pole - s); };
        return {[](const Parameters& c, double s, Parameters& derivative) {
                    const double ratio = s / (c[2] - s);
                    derivative = {1, ratio, -c[1] * ratio / (c[2] - s)};
                    return c[0] + c[1] * ratio;
                },
                best_start(points, grid, basis)};
    }
    for (double power = 0.3; power < 4; power *= 1.2) grid.push_back(power);
    const auto basis = [](double power, double s) { return std::pow(conductance(s), power); };
    return {[](const Parameters& c, double s, Parameters& derivative) {
                if (s == 0) {
                    derivative = {1, 0, 0};
                    return c[0];
                }
                const double g = std::pow(conductance(s), c[2]);
                derivative = {1, g, c[1] * g * std::log(conductance(s))};
                return c[0] + c[1] * g;
            },
            best_start(points, grid, basis)};
}

struct Problem {
    const Model* model;
    const std::vector<Point>* points;
};

Parameters read(const gsl_vector* x) {
    return {gsl_vector_get(x, 0), gsl_vector_get(x, 1), gsl_vector_get(x, 2)};
}

int residuals(const gsl_vector* x, void* data, gsl_vector* f) {
    const Problem& problem = *static_cast<const Problem*>(data);
    Parameters derivative;
    for (std::size_t i = 0; i < problem.points->size(); ++i) {
        const Point& p = (*problem.points)[i];
        gsl_vector_set(f, i, problem.model->value(read(x), p.s, derivative) - p.y);
    }
    return GSL_SUCCESS;
}

int jacobian(const gsl_vector* x, void* data, gsl_matrix* j) {
    const Problem& problem = *static_cast<const Problem*>(data);
    Parameters derivative;
    for (std::size_t i = 0; i < problem.points->size(); ++i) {
        problem.model->value(read(x), (*problem.points)[i].s, derivative);
        for (std::size_t k = 0; k < parameters; ++k) gsl_matrix_set(j, i, k, derivative[k]);
    }
    return GSL_SUCCESS;
}

struct Solution {
    Parameters parameters, errors;
};

Solution solve(Family family, const std::vector<Point>& points) {
    const Model model = model_of(family, points);
    Problem problem{&model, &points};
    gsl_multifit_nlinear_fdf functions{};
    functions.f = residuals;
    functions.df = jacobian;
    functions.n = points.size();
    functions.p = parameters;
    functions.params = &problem;
    const gsl_multifit_nlinear_parameters options = [] {
        auto defaults = gsl_multifit_nlinear_default_parameters();
        defaults.scale = gsl_multifit_nlinear_scale_more;
        defaults.solver = gsl_multifit_nlinear_solver_qr;
        return defaults;
    }();
    const std::unique_ptr<gsl_multifit_nlinear_workspace, void (*)(gsl_multifit_nlinear_workspace*)>
        workspace(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &options, points.size(),
                                             parameters),
                  gsl_multifit_nlinear_free);
    const Vector start = vector(parameters);
    for (std::size_t k = 0; k < parameters; ++k) gsl_vector_set(start.get(), k, model.start[k]);
    gsl_multifit_nlinear_init(start.get(), &functions, workspace.get());
    int reason = 0;
    const int status = gsl_multifit_nlinear_driver(1000, 1e-13, 1e-13, 0, nullptr, nullptr, &reason,
                                                   workspace.get());
    // GSL_ENOPROG: no step reduces the residual, which means that the minimum is reached to the
    // last digit.
    if (status != GSL_SUCCESS && status != GSL_ENOPROG)
        throw std::runtime_error(fmt::format("the fit of {} does not converge: {}", name_of(family),
                                             gsl_strerror(status)));
    const Matrix covariance = matrix(parameters, parameters);
    gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(workspace.get()), 0, covariance.get());
    double square_sum = 0;
    const gsl_vector* f = gsl_multifit_nlinear_residual(workspace.get());
    gsl_blas_ddot(f, f, &square_sum);
    const double variance = square_sum / static_cast<double>(points.size() - parameters);
    Solution solution{read(gsl_multifit_nlinear_position(workspace.get())), {}};
    for (std::size_t k = 0; k < parameters; ++k) {
        if (!std::isfinite(solution.parameters[k]))
            throw std::runtime_error(fmt::format("the fit of {} diverges", name_of(family)));
        solution.errors[k] = std::sqrt(variance * gsl_matrix_get(covariance.get(), k, k));
    }
    return solution;
}

// A monotone cubic through all readings (Steffen 1990, as implemented by GSL).
Curve steffen(const std::vector<Reading>& readings) {
    std::vector<double> x, y;
    for (const Reading& r : readings) {
        x.push_back(r.adc);
        y.push_back(r.grams);
    }
    const std::unique_ptr<gsl_interp, void (*)(gsl_interp*)> interpolation(
        gsl_interp_alloc(gsl_interp_steffen, x.size()), gsl_interp_free);
    gsl_interp_init(interpolation.get(), x.data(), y.data(), x.size());
    Curve curve{Family::monotone_cubic, {}};
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double slope =
            gsl_interp_eval_deriv(interpolation.get(), x.data(), y.data(), x[i], nullptr);
        curve.coefficients.insert(curve.coefficients.end(), {x[i], y[i], slope});
    }
    return curve;
}

}  // namespace

std::string name_of(Family family) {
    switch (family) {
        case Family::line:
            return "line";
        case Family::rational_quadratic:
            return "rational_quadratic";
        case Family::quadratic:
            return "quadratic";
        case Family::hyperbola:
            return "hyperbola";
        case Family::conductance_power:
            return "conductance_power";
        case Family::monotone_cubic:
            return "monotone_cubic";
    }
    throw std::logic_error("a family without a name");
}

std::string formula_of(Family family) {
    switch (family) {
        case Family::line:
            return "a x + b";
        case Family::rational_quadratic:
            return "x / (a x^2 + b x + c)";
        case Family::quadratic:
            return "a x^2 + b x + c";
        case Family::hyperbola:
            return "a + b x / (c - x)";
        case Family::conductance_power:
            return "a + exp(b + c ln(x / (1023 - x)))";
        case Family::monotone_cubic:
            return "piecewise cubic through the readings";
    }
    throw std::logic_error("a family without a formula");
}

Range rising_range(const Curve& curve, const std::vector<Reading>& readings) {
    const auto at = [&](int reading) { return value<double>(curve, reading); };
    const int middle = readings[readings.size() / 2].adc;
    Range range{middle, middle};
    while (range.highest < 1023 && at(range.highest + 1) >= at(range.highest) &&
           at(range.highest + 1) <= max_grams)
        ++range.highest;
    while (range.lowest > 0 && at(range.lowest - 1) <= at(range.lowest) &&
           at(range.lowest - 1) >= 0)
        --range.lowest;
    return range;
}

double held_value(const Curve& curve, Range range, int reading) {
    return value<double>(curve, std::clamp(reading, range.lowest, range.highest));
}

double square_sum(const Curve& curve, const std::vector<Reading>& readings) {
    double sum = 0;
    for (const Reading& r : readings) {
        const double residual = value<double>(curve, r.adc) - r.grams;
        sum += residual * residual;
    }
    return sum;
}

Fit fit(Family family, const std::vector<Reading>& readings) {
    if (readings.size() <= parameters)
        throw std::runtime_error(fmt::format("{} readings; the fit of {} needs at least {}",
                                             readings.size(), name_of(family), parameters + 1));
    gsl_set_error_handler_off();
    std::vector<Point> points;
    for (const Reading& r : readings) points.push_back({r.adc / counts, r.grams / grams});

    Fit result{{family, {}}, {}, 0};
    const auto set = [&](Parameters c, Parameters errors) {
        result.curve.coefficients.assign(c.begin(), c.end());
        result.standard_errors.assign(errors.begin(), errors.end());
    };
    if (family == Family::monotone_cubic) {
        result.curve = steffen(readings);
    } else if (family == Family::line) {
        std::vector<double> e;
        const auto c = linear(
            points, 2, [](std::size_t j, const Point& p) { return j == 0 ? p.s : 1.0; },
            [](const Point& p) { return p.y; }, nullptr, &e);
        result.curve.coefficients = {c[0] * grams / counts, c[1] * grams};
        result.standard_errors = {e[0] * grams / counts, e[1] * grams};
    } else if (family == Family::quadratic) {
        std::vector<double> e;
        const auto c = linear(
            points, 3, [](std::size_t j, const Point& p) { return std::pow(p.s, 2.0 - double(j)); },
            [](const Point& p) { return p.y; }, nullptr, &e);
        const Parameters unit = {grams / (counts * counts), grams / counts, grams};
        set({c[0] * unit[0], c[1] * unit[1], c[2] * unit[2]},
            {e[0] * unit[0], e[1] * unit[1], e[2] * unit[2]});
    } else {
        const auto [c, e] = solve(family, points);
        if (family == Family::rational_quadratic) {
            // x / 1024 / d kilograms = x / (1.024 d) grams
            const double unit = counts / grams;
            const Parameters units = {unit / (counts * counts), unit / counts, unit};
            set({c[0] * units[0], c[1] * units[1], c[2] * units[2]},
                {e[0] * units[0], e[1] * units[1], e[2] * units[2]});
        } else if (family == Family::hyperbola) {
            set({c[0] * grams, c[1] * grams, c[2] * counts},
                {e[0] * grams, e[1] * grams, e[2] * counts});
        } else {
            if (c[1] <= 0)
                throw std::runtime_error("the fit of conductance_power falls with the reading");
            set({c[0] * grams, std::log(c[1] * grams), c[2]}, {e[0] * grams, e[1] / c[1], e[2]});
        }
    }
    result.square_sum = square_sum(result.curve, readings);
    return result;
}

}  // namespace calibration
