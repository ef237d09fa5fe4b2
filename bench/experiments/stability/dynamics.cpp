// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/dynamics.hpp"

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <stdexcept>

#include "bench/experiments/stability/measures.hpp"
#include "bench/lab/parallel.hpp"
#include "bench/lab/records/progress.hpp"
#include "reference/trajectories/chain.hpp"

namespace stability {
namespace {

constexpr double rest = 32;  // m, of springs along one axis, which are linear there

DynamicsRow row_of(const Subject& subject, std::string measure, std::string system,
                   std::string parameter, double at, std::string unit,
                   const Description& description) {
    DynamicsRow row;
    row.measure = std::move(measure);
    row.system = std::move(system);
    row.scalar = subject.scalar;
    row.arithmetic = subject.arithmetic;
    row.integrator = subject.integrator;
    row.parameter = std::move(parameter);
    row.at = at;
    row.unit = std::move(unit);
    row.steps = description.steps;
    row.dt = description.dt.value();
    return row;
}

// Whether it ran to the end of its steps, or to where it was told to stop, without wrapping.
bool went_well(const Outcome& outcome) {
    return outcome.unfit.empty() && outcome.vanished.empty() && outcome.error.empty() &&
           !outcome.record.first_failure();
}

std::optional<State> end_of(const Subject& subject, const Description& description) {
    State last;
    const Outcome outcome = subject.run(description, [&](const State& state, unsigned) {
        last = state;
        return true;
    });
    return went_well(outcome) ? std::optional(last) : std::nullopt;
}

double distance(const State& a, const State& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, length(a[i].position - b[i].position));
    return largest;
}

// The same method in double.
const Subject& exact(const Subject& subject) {
    static const std::vector<Subject> all = subjects_of_double();
    for (const Subject& one : all)
        if (one.integrator == subject.integrator) return one;
    throw std::logic_error("no such method in double: " + subject.integrator);
}

Description spring(double extension, double stiffness, double damping, TimeStep dt,
                   unsigned steps) {
    Description made;
    made.bodies = {{.position = {rest + extension, 0}}};
    made.springs = {{{.length = rest}, stiffness, damping}};
    made.dt = dt;
    made.steps = steps;
    return made;
}
Description pendulum(TimeStep dt, unsigned steps) {
    Description made;
    made.bodies = {{.position = {0.6, -0.8}}};
    made.rods = {{.length = 1}};
    made.gravity = {0, -9.81};
    made.dt = dt;
    made.steps = steps;
    return made;
}
// A body on a spring of length 0 circles its fixed point, in exact arithmetic for ever.
Description orbit(TimeStep dt, unsigned steps) {
    Description made;
    made.bodies = {{.position = {1, 0}, .velocity = {0, 2}}};
    made.springs = {{{.length = 0}, 4, 0}};
    made.dt = dt;
    made.steps = steps;
    return made;
}

}  // namespace

double spectral_radius(std::vector<double> matrix, std::size_t n) {
    const std::unique_ptr<gsl_eigen_nonsymm_workspace, decltype(&gsl_eigen_nonsymm_free)> space(
        gsl_eigen_nonsymm_alloc(n), gsl_eigen_nonsymm_free);
    const std::unique_ptr<gsl_vector_complex, decltype(&gsl_vector_complex_free)> values(
        gsl_vector_complex_alloc(n), gsl_vector_complex_free);
    gsl_matrix_view view = gsl_matrix_view_array(matrix.data(), n, n);
    gsl_eigen_nonsymm(&view.matrix, values.get(), space.get());
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i)
        largest = std::max(largest, gsl_complex_abs(gsl_vector_complex_get(values.get(), i)));
    return largest;
}

std::vector<double> step_map(const std::string& integrator, double omega, double zeta, double h) {
    const double k = omega * omega, c = 2 * zeta * omega;
    if (integrator == "explicit_euler") return {1, h, -h * k, 1 - h * c};
    if (integrator == "implicit_springs") {
        const double d = 1 + h * (h * k + c);
        return {1 - h * h * k / d, h / d, -h * k / d, 1 / d};
    }
    if (integrator == "velocity_verlet") {
        // The forces are those of the previous half step: u follows from v = u + h/2 a(x, u); then
        // w = v + h/2 a(x, u); x' = x + h w; v' = w + h/2 a(x', w).
        const double uv = 1 / (1 - h / 2 * c), ux = h / 2 * k * uv;
        const double wx = -h / 2 * (k + c * ux), wv = 1 - h / 2 * c * uv;
        const double xx = 1 + h * wx, xv = h * wv;
        return {xx, xv, wx - h / 2 * (k * xx + c * wx), wv - h / 2 * (k * xv + c * wv)};
    }
    if (integrator == "semi_implicit_euler" || integrator == "semi_implicit_compensated")
        return {1 - h * h * k, h * (1 - h * c), -h * k, 1 - h * c};
    throw std::invalid_argument("no step map is known for " + integrator);
}

std::vector<double> fitted_map(const std::vector<std::vector<double>>& states) {
    const std::size_t n = states.front().size();
    // The normal equations G M^T = R; G is the sum of y y^T, and R that of y y'^T.
    std::vector<double> gram(n * n), right(n * n), map(n * n);
    for (std::size_t s = 0; s + 1 < states.size(); ++s)
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) {
                gram[i * n + j] += states[s][i] * states[s][j];
                right[i * n + j] += states[s][i] * states[s + 1][j];
            }
    gsl_matrix_view lu = gsl_matrix_view_array(gram.data(), n, n);
    const std::unique_ptr<gsl_permutation, decltype(&gsl_permutation_free)> order(
        gsl_permutation_alloc(n), gsl_permutation_free);
    const std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)> solution(gsl_vector_alloc(n),
                                                                           gsl_vector_free);
    int sign = 0;
    gsl_linalg_LU_decomp(&lu.matrix, order.get(), &sign);
    if (gsl_linalg_LU_det(&lu.matrix, sign) == 0) return {};
    gsl_matrix_view sides = gsl_matrix_view_array(right.data(), n, n);
    for (std::size_t j = 0; j < n; ++j) {
        const gsl_vector_view side = gsl_matrix_column(&sides.matrix, j);
        gsl_linalg_LU_solve(&lu.matrix, order.get(), &side.vector, solution.get());
        for (std::size_t i = 0; i < n; ++i) map[j * n + i] = gsl_vector_get(solution.get(), i);
    }
    return map;
}

// The run starts small if the motion grows, and ends where it is large or lost in rounding.
std::vector<DynamicsRow> growth_of(const Subject& subject) {
    constexpr double small = 1.0 / 16, large = 1, end = 1.0 / 64;  // m
    const TimeStep dt = TimeStep::binary(2);
    const double h = dt.value();
    std::vector<DynamicsRow> rows;
    for (const double zeta : {0.0, 0.1})
        for (const double omega_dt : {0.1, 0.5, 1.0, 1.5, 1.9, 1.99, 2.01, 2.1, 2.2}) {
            const double omega = omega_dt / h;
            const double theory = spectral_radius(step_map(subject.integrator, omega, zeta, h), 2);
            const double start = theory > 0.999 ? small : large / 2;
            const Description made = spring(start, omega * omega, 2 * zeta * omega, dt, 1000);
            std::vector<std::vector<double>> states;
            const Outcome outcome = subject.run(made, [&](const State& state, unsigned) {
                const double x = state[0].position.x - rest, v = state[0].velocity.x;
                states.push_back({x, v / omega});
                const double size = std::hypot(x, v / omega);
                return size < 1.3 * large && size > end;
            });
            DynamicsRow row = row_of(subject, "growth", zeta > 0 ? "damped spring" : "spring",
                                     "omega dt", omega_dt, "1/step", made);
            row.theory = theory;
            row.steps = static_cast<unsigned>(states.size()) - (states.empty() ? 0 : 1);
            // The first step has no forces of a previous step.
            if (!states.empty()) states.erase(states.begin());
            if (went_well(outcome) && states.size() > 2) {
                const auto map = fitted_map(states);
                if (!map.empty()) row.measured = spectral_radius(map, 2);
            }
            rows.push_back(row);
        }
    return rows;
}

std::vector<DynamicsRow> energy_of(const Subject& subject, unsigned longest) {
    constexpr unsigned window = 1000;  // steps: 3.9 s, some periods of each system
    const TimeStep dt = TimeStep::binary(8);
    struct System {
        const char* name;
        Description description;
        double omega;  // of linear systems; 0 for others
        double scale;  // J, of the motion
    };
    const double omega = 2;
    // It damps only along the spring, and the length of an orbit's spring hardly changes.
    const bool implicit = subject.integrator == "implicit_springs";
    const System systems[] = {{"spring", spring(1, omega * omega, 0, dt, longest), omega, 2},
                              {"orbit", orbit(dt, longest), implicit ? 0 : omega, 4},
                              {"pendulum", pendulum(dt, longest), 0, 0.2 * 9.81}};
    std::vector<DynamicsRow> rows;
    for (const auto& [name, made, of_linear, scale] : systems) {
        double sum = 0, first = 0;
        std::vector<std::pair<unsigned, double>> gains;
        const Outcome outcome = subject.run(made, [&](const State& state, unsigned step) {
            if (step == 0) return true;
            sum += energy(made, state);
            if (step % window != 0) return true;
            const double mean = sum / window;
            sum = 0;
            if (step == window) first = mean;
            const double gain = (mean - first) / scale;
            for (unsigned at = 10 * window; at <= longest; at *= 10)
                if (step == at) gains.emplace_back(step, gain);
            return std::isfinite(gain) && std::abs(gain) < 100;
        });
        for (unsigned at = 10 * window; at <= longest; at *= 10) {
            DynamicsRow row =
                row_of(subject, "energy", name, "steps", at, "of the energy of the motion", made);
            for (const auto& [step, gain] : gains)
                if (step == at && went_well(outcome)) row.measured = gain;
            // The energy of a linear system grows by the square of the map's radius per step; with
            // the symplectic methods not at all.
            if (of_linear > 0) {
                const double log_radius = std::log(
                    spectral_radius(step_map(subject.integrator, of_linear, 0, dt.value()), 2));
                const double of_window = std::abs(log_radius) < 1e-12 ? 0 : 2 * log_radius * window;
                const unsigned windows = at / window;
                row.theory = of_window == 0 ? 0
                                            : std::expm1(of_window) / of_window *
                                                  std::expm1(of_window * (windows - 1));
            } else if (!implicit && subject.integrator != "explicit_euler") {
                row.theory = 0;
            }
            rows.push_back(row);
        }
    }
    return rows;
}

namespace {

// Forward, and back with reversed velocities.
std::optional<double> reversal(const Subject& subject, const Description& forward) {
    const auto there = end_of(subject, forward);
    if (!there) return std::nullopt;
    Description back = forward;
    for (std::size_t i = 0; i < there->size(); ++i) {
        back.bodies[i].position = (*there)[i].position;
        back.bodies[i].velocity = (*there)[i].velocity * -1;
    }
    const auto home = end_of(subject, back);
    if (!home) return std::nullopt;
    State start;
    for (const Body& body : forward.bodies) start.push_back({body.position, body.velocity});
    return distance(*home, start);
}

// The distance at the end if the links are added in reverse order.
std::optional<double> reordered(const Subject& subject, const Description& made) {
    Description other = made;
    std::reverse(other.rods.begin(), other.rods.end());
    std::reverse(other.springs.begin(), other.springs.end());
    const auto one = end_of(subject, made), two = end_of(subject, other);
    return one && two ? std::optional(distance(*one, *two)) : std::nullopt;
}

}  // namespace

std::vector<DynamicsRow> reversal_of(const Subject& subject) {
    const TimeStep dt = TimeStep::binary(8);
    constexpr unsigned steps = 1024;  // 4 s
    std::vector<DynamicsRow> rows;
    const std::pair<const char*, Description> systems[] = {{"spring", spring(1, 4, 0, dt, steps)},
                                                           {"orbit", orbit(dt, steps)},
                                                           {"pendulum", pendulum(dt, steps)}};
    for (const auto& [name, made] : systems) {
        DynamicsRow row = row_of(subject, "reversal", name, "steps each way", steps, "m", made);
        row.measured = reversal(subject, made);
        row.theory = reversal(exact(subject), made);
        rows.push_back(row);
    }
    return rows;
}

std::vector<DynamicsRow> order_of(const Subject& subject) {
    const TimeStep dt = TimeStep::binary(8);
    constexpr unsigned links = 4, steps = 256;  // 1 s
    Description rods;
    for (unsigned i = 0; i < links; ++i) {
        rods.bodies.push_back({.position = {0.3 * (i + 1), -0.4 * (i + 1)}});
        rods.rods.push_back({.a = int(i), .b = i == 0 ? no_body : int(i) - 1, .length = 0.5});
    }
    rods.gravity = {0, -9.81};
    rods.dt = dt;
    rods.steps = steps;
    Description springs = rods;
    springs.rods.clear();
    for (const Link& rod : rods.rods) springs.springs.push_back({rod, 50, 0.5});
    std::vector<DynamicsRow> rows;
    const std::pair<const char*, const Description*> systems[] = {{"chain of rods", &rods},
                                                                  {"chain of springs", &springs}};
    for (const auto& [name, made] : systems) {
        DynamicsRow row = row_of(subject, "order", name, "links", links, "m", *made);
        row.measured = reordered(subject, *made);
        row.theory = reordered(exact(subject), *made);
        rows.push_back(row);
    }
    return rows;
}

// Where round-to-nearest stops a damped spring of 1 kg, in m. At rest v h is below half an ulp, and
// so is (k x + c v) h, which gives |k x| < ulp / 2h + c ulp / 2h, plus half an ulp by which the
// force is rounded and k times half an ulp of the length. Velocity Verlet adds the force over half
// a step at a time: twice as much is lost. Residuals lose neither. The implicit method divides the
// velocity by d = 1 + h (h k + c): if that changes it by less than half an ulp nothing is damped,
// and the spring keeps swinging at x = v / omega.
static double dead_band_bound(const std::string& integrator, double ulp, double k, double c,
                              double h) {
    if (integrator == "semi_implicit_compensated") return ulp * (2 + k / 2 + c) / k;
    if (integrator == "implicit_springs") {
        const double d = 1 + h * (h * k + c);
        return ulp * (0.5 / (1 - 1 / d) / std::sqrt(k) + 2);
    }
    const double changes = integrator == "velocity_verlet" ? 2 : 1;
    return ulp / 2 * ((changes + c) / h + 1 + k) / k;
}

// The largest velocity, in ulps, that an implicit step does not damp: divided by d it changes by
// less than half an ulp. NaN if d is 1 in the format.
static double fastest_undamped(double ulp, double k, double c, double h) {
    const double d = 1 + ulp * std::round(h * (h * k + c) / ulp);
    return d > 1 ? std::ceil(0.5 / (1 - 1 / d)) - 1 : std::numeric_limits<double>::quiet_NaN();
}

double rounded_period(double k, double h, double fastest) {
    // A quarter of it, from the middle. Both products are constant up to the next place where one
    // rounds to another integer.
    double x = 0, v = fastest, steps = 0;
    double way = std::ceil(h * v - 0.5), pull = 0;  // h v and h k x, rounded
    while (v > 0) {
        if (way <= 0 && pull <= 0) return 1;
        const double slower = std::max(0.0, (way - 0.5) / h), farther = (pull + 0.5) / (h * k);
        constexpr double never = std::numeric_limits<double>::infinity();
        const double until_slower = pull > 0 ? (v - slower) / pull : never;
        const double until_farther = way > 0 ? (farther - x) / way : never;
        if (until_slower <= until_farther) {
            steps += until_slower;
            x += way * until_slower;
            v = slower;
            way -= 1;
        } else {
            steps += until_farther;
            v -= pull * until_farther;
            x = farther;
            pull += 1;
        }
    }
    return 4 * steps;
}

std::vector<DynamicsRow> dead_band_of(const Subject& subject) {
    constexpr double k = 4, c = 0.5;
    constexpr unsigned window = 4096, steps = 60000;  // by exp(-c t / 2) over 234 s: 4e-26
    const TimeStep dt = TimeStep::binary(8);
    const Description made = spring(0.5, k, c, dt, steps);
    std::vector<std::pair<double, double>> last;
    const Outcome outcome = subject.run(made, [&](const State& state, unsigned step) {
        if (step > steps - window)
            last.emplace_back(state[0].position.x - rest, state[0].velocity.x);
        return true;
    });
    DynamicsRow band = row_of(subject, "dead_band", "damped spring", "stiffness", k, "m", made);
    DynamicsRow period =
        row_of(subject, "limit_cycle", "damped spring", "stiffness", k, "steps", made);
    if (went_well(outcome) && last.size() == window) {
        double largest = 0;
        for (const auto& [x, v] : last) largest = std::max(largest, std::abs(x));
        band.measured = largest;
        for (std::size_t p = 1; p <= window / 2 && !period.measured; ++p)
            if (std::equal(last.begin() + std::ptrdiff_t(p), last.end(), last.begin()))
                period.measured = double(p);
    }
    // Both theories are those of rounding to nearest.
    if (subject.ulp > 0 && subject.arithmetic != "published") {
        const double h = dt.value();
        band.theory = dead_band_bound(subject.integrator, subject.ulp, k, c, h);
        if (subject.integrator != "implicit_springs") {
            period.theory = 1;  // at rest
        } else if (const double v = fastest_undamped(subject.ulp, k, c, h); !std::isnan(v)) {
            period.theory = rounded_period(k, h, v);
        }
    }
    return {band, period};
}

namespace {

constexpr double apart = 0.1;  // m, the distance at which a run has left the other

// Points of 1 kg on rods of 1 m; each run sets their start.
Description double_pendulum() {
    Description made;
    made.rods = {{.a = 0, .length = 1}, {.a = 1, .b = 0, .length = 1}};
    made.gravity = {0, -9.81};
    made.dt = TimeStep::binary(10);
    made.steps = 40 << 10;
    return made;
}

// Two points of such a pendulum, at rest, both above the fixed point or slightly below it.
reference::Chain chaotic_start(unsigned seed) {
    std::mt19937 bits(seed);
    const auto angle = [&](double low, double high) {
        return (low + (high - low) * std::ldexp(double(bits()), -32)) * std::numbers::pi / 180;
    };
    const double upper = angle(100, 140), lower = angle(100, 180);
    return {{0, 0}, {0, -9.81}, {{1, 1, upper, 0}, {1, 1, lower, 0}}};
}

// The angles and their rates of change in a state of these points.
std::vector<double> variables_of(const reference::State& state) {
    std::vector<double> angles, rates;
    reference::ParticleState from{};
    for (const reference::ParticleState& to : state) {
        const double x = to.position[0] - from.position[0], y = to.position[1] - from.position[1];
        angles.push_back(std::atan2(x, -y));
        rates.push_back(
            ((to.velocity[0] - from.velocity[0]) * -y + (to.velocity[1] - from.velocity[1]) * x) /
            (x * x + y * y));
        from = to;
    }
    angles.insert(angles.end(), rates.begin(), rates.end());
    return angles;
}
reference::Chain put_into(reference::Chain chain, const std::vector<double>& variables) {
    for (std::size_t i = 0; i < chain.links.size(); ++i) {
        chain.links[i].angle = variables[i];
        chain.links[i].angular_velocity = variables[chain.links.size() + i];
    }
    return chain;
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

// The slope of the least-squares line through points.
double slope(const std::vector<std::pair<double, double>>& points) {
    double x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& [at, value] : points) x += at, y += value;
    x /= double(points.size()), y /= double(points.size());
    for (const auto& [at, value] : points) xx += (at - x) * (at - x), xy += (at - x) * (value - y);
    return xy / xx;
}

}  // namespace

// Benettin, Galgani, Giorgilli and Strelcyn 1980: a second motion starts next to the first. Every
// second its distance gives the growth and is reset.
double lyapunov_exponent(unsigned seconds) {
    constexpr double beside = 1e-7, tolerance = 1e-12;
    double growth = 0;
    for (unsigned seed = 0; seed < chaotic_starts; ++seed) {
        reference::Chain one = chaotic_start(seed), other = one;
        other.links.front().angle += beside;
        for (unsigned second = 0; second < seconds; ++second) {
            const auto a = variables_of(reference::move(one, {0, 1}, tolerance).back());
            auto b = variables_of(reference::move(other, {0, 1}, tolerance).back());
            double square = 0;
            for (std::size_t i = 0; i < a.size(); ++i) {
                double difference = b[i] - a[i];
                if (i < a.size() / 2) difference = std::remainder(difference, 2 * std::numbers::pi);
                b[i] = difference;
                square += difference * difference;
            }
            const double by = std::sqrt(square) / beside;
            growth += std::log(by);
            for (std::size_t i = 0; i < a.size(); ++i) b[i] = a[i] + b[i] / by;
            one = put_into(one, a);
            other = put_into(other, b);
        }
    }
    return growth / (chaotic_starts * seconds);
}

Divergence divergence(const Subject& subject) {
    Description made = double_pendulum();
    Divergence found;
    for (unsigned seed = 0; seed < chaotic_starts; ++seed) {
        const reference::Trajectory at_start = reference::move(chaotic_start(seed), {0}, 1e-12);
        made.bodies.clear();
        for (const auto& point : at_start.front())
            made.bodies.push_back({.position = {point.position[0], point.position[1]}});
        std::vector<State> true_states;
        exact(subject).run(made, [&](const State& state, unsigned) {
            true_states.push_back(state);
            return true;
        });
        double first = 0;
        std::optional<double> left;
        std::vector<std::pair<double, double>> growing;
        const Outcome outcome = subject.run(made, [&](const State& state, unsigned step) {
            const double distance_now = distance(state, true_states.at(step));
            const double time = step * made.dt.value();
            if (first == 0) first = distance_now;
            // The rounding errors of the first steps add up before they grow.
            if (distance_now > 16 * first) growing.emplace_back(time, std::log(distance_now));
            if (distance_now > apart) left = time;
            return !left;
        });
        if (!went_well(outcome) || !left) continue;
        found.times.push_back(*left);
        if (growing.size() > 2) found.rates.push_back(slope(growing));
    }
    return found;
}

std::vector<DynamicsRow> divergence_of(const Subject& subject) {
    static const double exponent = lyapunov_exponent(100);
    constexpr double of_float = 0x1p-23;  // m, the ulp of 1 m
    const auto [times, rates] = divergence(subject);
    const Description made = double_pendulum();
    DynamicsRow time =
        row_of(subject, "divergence", "double pendulum", "distance, m", apart, "s", made);
    DynamicsRow rate =
        row_of(subject, "divergence_rate", "double pendulum", "distance, m", apart, "1/s", made);
    if (times.size() == chaotic_starts) time.measured = mean(times);
    if (rates.size() == chaotic_starts) rate.measured = mean(rates);
    const double ulp = subject.ulp > 0 ? subject.ulp : of_float;
    time.theory = std::log(apart / ulp) / exponent;
    rate.theory = exponent;
    return {time, rate};
}

void measure_dynamics(const DynamicsOptions& options) {
    using Part = std::function<std::vector<DynamicsRow>(const Subject&)>;
    const unsigned longest = options.quick ? 100000 : 1000000;
    const Part parts[] = {[=](const Subject& subject) { return energy_of(subject, longest); },
                          growth_of,
                          reversal_of,
                          order_of,
                          dead_band_of,
                          divergence_of};
    const std::vector<Subject>& all = subjects();
    std::vector<std::vector<DynamicsRow>> found(std::size(parts) * all.size());
    records::Progress progress("dynamics", found.size());
    operations::in_parallel(options.threads, found.size(), [&](std::size_t i) {
        found[i] = parts[i / all.size()](all[i % all.size()]);
        progress.advance();
    });
    std::vector<DynamicsRow> rows;
    for (const auto& part : found) rows.insert(rows.end(), part.begin(), part.end());
    records::table_of(rows).save(options.output / "dynamics.csv");
}

}  // namespace stability
