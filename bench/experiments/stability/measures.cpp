// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/measures.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace stability {

std::string in_words(double number, const char* unit) {
    return fmt::format("{:.3g} {}", number, unit);
}

Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator*(Point a, double factor) { return {a.x * factor, a.y * factor}; }
double length(Point p) { return std::hypot(p.x, p.y); }

namespace {

double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
// The larger, or NaN if one is NaN.
double larger(double a, double b) {
    return std::isnan(a) || std::isnan(b) ? std::numeric_limits<double>::quiet_NaN()
                                          : std::max(a, b);
}
Point difference(const Link& link, const State& state) {
    const Point other = link.b == no_body ? link.anchor : state[link.b].position;
    return state[link.a].position - other;
}
Point relative_velocity(const Link& link, const State& state) {
    const Point other = link.b == no_body ? Point{} : state[link.b].velocity;
    return state[link.a].velocity - other;
}

// The accelerations by springs, drag, gravity and constant forces.
std::vector<Point> accelerations(const Description& description, const State& state) {
    std::vector<Point> forces(state.size());
    for (std::size_t i = 0; i < state.size(); ++i) forces[i] = description.bodies[i].force;
    for (const Spring& spring : description.springs) {
        const Point apart = difference(spring, state);
        const double distance = length(apart);
        if (distance == 0) continue;
        const Point direction = apart * (1 / distance);
        const double tension = spring.stiffness * (distance - spring.length) +
                               spring.damping * dot(relative_velocity(spring, state), direction);
        forces[spring.a] = forces[spring.a] - direction * tension;
        if (spring.b != no_body) forces[spring.b] = forces[spring.b] + direction * tension;
    }
    for (const Drag& drag : description.drags) {
        const Point v = state[drag.a].velocity;
        forces[drag.a] = forces[drag.a] - v * (drag.linear + drag.quadratic * length(v));
    }
    for (std::size_t i = 0; i < state.size(); ++i) {
        const double inverse_mass = description.bodies[i].inverse_mass;
        forces[i] = inverse_mass > 0 ? forces[i] * inverse_mass + description.gravity : Point{};
    }
    return forces;
}

// GSL's driver for y' = f(t, y), with a Jacobian by differences.
class Equation {
  public:
    using Function = std::function<void(const double* y, double* dydt)>;

    Equation(std::vector<double> start, Function function, const gsl_odeiv2_step_type* type,
             double tolerance)
        : y_(std::move(start)), function_(std::move(function)) {
        system_ = {derivative, jacobian, y_.size(), this};
        driver_.reset(gsl_odeiv2_driver_alloc_y_new(&system_, type, 1e-6, tolerance, tolerance));
        if (!driver_) throw std::runtime_error("GSL cannot make a solver");
    }
    // Advances to a time that must not be before the previous one; NaN if the solver gives up.
    const std::vector<double>& at(double time) {
        if (time > time_ &&
            gsl_odeiv2_driver_apply(driver_.get(), &time_, time, y_.data()) != GSL_SUCCESS)
            std::fill(y_.begin(), y_.end(), std::numeric_limits<double>::quiet_NaN());
        return y_;
    }

  private:
    struct Free {
        void operator()(gsl_odeiv2_driver* driver) const { gsl_odeiv2_driver_free(driver); }
    };
    static int derivative(double, const double* y, double* dydt, void* self) {
        static_cast<Equation*>(self)->function_(y, dydt);
        return GSL_SUCCESS;
    }
    static int jacobian(double, const double* y, double* dfdy, double* dfdt, void* self) {
        auto& equation = *static_cast<Equation*>(self);
        const std::size_t n = equation.y_.size();
        std::vector<double> moved(y, y + n), above(n), below(n);
        for (std::size_t j = 0; j < n; ++j) {
            const double step = 1e-6 * std::max(1.0, std::abs(y[j]));
            moved[j] = y[j] + step;
            equation.function_(moved.data(), above.data());
            moved[j] = y[j] - step;
            equation.function_(moved.data(), below.data());
            moved[j] = y[j];
            for (std::size_t i = 0; i < n; ++i)
                dfdy[i * n + j] = (above[i] - below[i]) / (2 * step);
        }
        std::fill(dfdt, dfdt + n, 0.0);
        return GSL_SUCCESS;
    }

    std::vector<double> y_;
    Function function_;
    gsl_odeiv2_system system_{};
    std::unique_ptr<gsl_odeiv2_driver, Free> driver_;
    double time_ = 0;
};

void report_no_errors() {
    static const auto before = gsl_set_error_handler_off();
    (void)before;
}

}  // namespace

Measure all_of(std::vector<Measure> measures) {
    std::string holds;
    for (const Measure& measure : measures) holds += (holds.empty() ? "" : "; ") + measure.holds();
    return {[measures = std::move(measures)](const State& state, unsigned step) {
                double most = 0;
                for (const Measure& measure : measures) most = larger(most, measure(state, step));
                return most;
            },
            holds};
}

Measure from_step(unsigned first, Measure measure) {
    const std::string holds = fmt::format("from step {}: {}", first, measure.holds());
    return {[first, measure = std::move(measure)](const State& state, unsigned step) {
                return step < first ? 0 : measure(state, step);
            },
            holds};
}

Measure stays_within(const Description& description, double most) {
    return {[bodies = description.bodies, most](const State& state, unsigned) {
                double worst = 0;
                for (std::size_t i = 0; i < state.size(); ++i)
                    worst = larger(worst, length(state[i].position - bodies[i].position) / most);
                return worst;
            },
            "all within " + in_words(most, "m of the start")};
}

Measure rods_hold(const Description& description, double tolerance) {
    return {[rods = description.rods, tolerance](const State& state, unsigned) {
                double worst = 0;
                for (const Link& rod : rods)
                    worst = larger(worst, std::abs(length(difference(rod, state)) - rod.length) /
                                              (rod.length * tolerance));
                return worst;
            },
            "rods within " + in_words(100 * tolerance, "% of their length")};
}

Measure ropes_hold(const Description& description, double tolerance) {
    return {[ropes = description.ropes, tolerance](const State& state, unsigned) {
                double worst = 0;
                for (const Rope& rope : ropes)
                    worst = larger(worst, (length(difference(rope, state)) - rope.length) /
                                              (rope.length * tolerance));
                return worst;
            },
            "ropes at most " + in_words(100 * tolerance, "% too long")};
}

Measure no_overlap(const Description& description, double tolerance) {
    const auto overlap = [bodies = description.bodies, planes = description.planes, tolerance](
                             const State& state, unsigned) {
        double worst = 0;
        for (std::size_t i = 0; i < state.size(); ++i) {
            const double radius = bodies[i].radius;
            for (std::size_t j = 0; j < i; ++j) {
                if (bodies[i].inverse_mass == 0 && bodies[j].inverse_mass == 0) continue;
                const double reach = radius + bodies[j].radius;
                const double distance = length(state[i].position - state[j].position);
                worst = larger(worst, (reach - distance) / (reach * tolerance));
            }
            for (const Plane& plane : planes) {
                const double height = dot(plane.normal, state[i].position) - plane.offset - radius;
                worst = larger(worst, -height / (radius * tolerance));
            }
        }
        return worst;
    };
    return {overlap, "overlap at most " + in_words(100 * tolerance, "% of the radii")};
}

double energy(const Description& description, const State& state) {
    double sum = 0;
    for (std::size_t i = 0; i < state.size(); ++i) {
        const Body& body = description.bodies[i];
        if (body.inverse_mass == 0) continue;
        const double mass = 1 / body.inverse_mass;
        sum += mass / 2 * dot(state[i].velocity, state[i].velocity);
        sum -= mass * dot(description.gravity, state[i].position);
        sum -= dot(body.force, state[i].position);
    }
    for (const Spring& spring : description.springs) {
        const double extension = length(difference(spring, state)) - spring.length;
        sum += spring.stiffness / 2 * extension * extension;
    }
    return sum;
}

Measure energy_does_not_grow(const Description& description, double tolerance, double scale) {
    State start;
    for (const Body& body : description.bodies) start.push_back({body.position, body.velocity});
    const double before = energy(description, start);
    return {[description, tolerance, scale, before](const State& state, unsigned) {
                return (energy(description, state) - before) / (tolerance * scale);
            },
            "energy grows by at most " + in_words(tolerance * scale, "J")};
}

Measure centre_of_mass_keeps(const Description& description, double tolerance) {
    const auto centre = [bodies = description.bodies](const State& state) {
        double mass = 0;
        Point sum;
        for (std::size_t i = 0; i < state.size(); ++i) {
            mass += 1 / bodies[i].inverse_mass;
            sum = sum + state[i].position * (1 / bodies[i].inverse_mass);
        }
        return sum * (1 / mass);
    };
    State start, moved;
    for (const Body& body : description.bodies) {
        start.push_back({body.position, body.velocity});
        moved.push_back({body.velocity, {}});
    }
    return {[centre, at_start = centre(start), velocity = centre(moved),
             dt = description.dt.value(), tolerance](const State& state, unsigned step) {
                return length(centre(state) - at_start - velocity * (step * dt)) / tolerance;
            },
            "centre of mass within " + in_words(tolerance, "m of its path")};
}

Measure follows(const Description& description, unsigned body, std::function<Point(double)> truth,
                double tolerance) {
    return {[dt = description.dt.value(), body, truth = std::move(truth), tolerance](
                const State& state, unsigned step) {
                return length(state[body].position - truth(step * dt)) / tolerance;
            },
            fmt::format("body {} within {:.3g} m of its path", body, tolerance)};
}

Measure has_velocity(unsigned body, Point velocity, double tolerance) {
    return {[=](const State& state, unsigned) {
                return length(state[body].velocity - velocity) / tolerance;
            },
            fmt::format("velocity of body {} within {:.3g} m/s of ({:.3g} {:.3g}) m/s", body,
                        tolerance, velocity.x, velocity.y)};
}

Measure follows_solver(const Description& description, Solver solver, double tolerance) {
    report_no_errors();
    constexpr unsigned checks = 8;
    const std::size_t n = description.bodies.size();
    std::vector<double> start;
    for (const Body& body : description.bodies)
        for (const double x : {body.position.x, body.position.y, body.velocity.x, body.velocity.y})
            start.push_back(x);
    const auto function = [description, n](const double* y, double* dydt) {
        State state(n);
        for (std::size_t i = 0; i < n; ++i)
            state[i] = {{y[4 * i], y[4 * i + 1]}, {y[4 * i + 2], y[4 * i + 3]}};
        const auto change = accelerations(description, state);
        for (std::size_t i = 0; i < n; ++i) {
            dydt[4 * i] = state[i].velocity.x;
            dydt[4 * i + 1] = state[i].velocity.y;
            dydt[4 * i + 2] = change[i].x;
            dydt[4 * i + 3] = change[i].y;
        }
    };
    const gsl_odeiv2_step_type* type = solver == Solver::msbdf   ? gsl_odeiv2_step_msbdf
                                       : solver == Solver::bsimp ? gsl_odeiv2_step_bsimp
                                                                 : gsl_odeiv2_step_rk4imp;
    Equation equation(std::move(start), function, type, 1e-7);
    std::vector<std::vector<double>> truth;
    const unsigned between = description.steps / checks;
    const double dt = description.dt.value();
    for (unsigned check = 1; check <= checks; ++check)
        truth.push_back(equation.at(check * between * dt));
    const auto distance = [truth = std::move(truth), between, n, tolerance](const State& state,
                                                                            unsigned step) {
        double worst = 0;
        for (std::size_t i = 0; i < n; ++i)  // a runaway is reported immediately
            worst = larger(worst, std::isfinite(state[i].position.x + state[i].position.y)
                                      ? 0
                                      : std::numeric_limits<double>::quiet_NaN());
        if (step == 0 || step % between != 0 || step / between > truth.size()) return worst;
        const auto& y = truth[step / between - 1];
        for (std::size_t i = 0; i < n; ++i)
            worst = larger(worst,
                           length(state[i].position - Point{y[4 * i], y[4 * i + 1]}) / tolerance);
        return worst;
    };
    return {distance,
            fmt::format("all within {:.3g} m of the solver's path at {} times", tolerance, checks)};
}

std::function<double(double)> pendulum_angle(double start, double gravity, double length) {
    report_no_errors();
    const auto function = [rate = gravity / length](const double* y, double* dydt) {
        dydt[0] = y[1];
        dydt[1] = -rate * std::sin(y[0]);
    };
    const auto equation = std::make_shared<Equation>(std::vector<double>{start, 0.0}, function,
                                                     gsl_odeiv2_step_rk8pd, 1e-9);
    return [equation](double time) { return equation->at(time)[0]; };
}

}  // namespace stability
