// SPDX-License-Identifier: GPL-3.0-or-later
// Springs and drag. Lengths are many times the amplitude, so that oscillations are harmonic, and
// fit the narrowest format.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "bench/experiments/stability/measures.hpp"

namespace stability {
namespace {

constexpr double rest = 32, amplitude = 0.25;  // m
// A bounded motion grows to at most this many amplitudes, in at least this many steps of the map of
// stiffness. The report reads both constants.
constexpr double growth = 50, growth_steps = 300;
constexpr double pi = std::numbers::pi;

Description on_spring(double stiffness, double damping, double inverse_mass, TimeStep dt,
                      unsigned steps, double extension = amplitude, double rest_length = rest) {
    Description made;
    made.bodies = {{.position = {rest_length + extension, 0}, .inverse_mass = inverse_mass}};
    made.springs = {{{.length = rest_length}, stiffness, damping}};
    made.dt = dt;
    made.steps = steps;
    return made;
}

// Stays within `most` amplitudes of the rest length; starts where it should, within half an
// amplitude; and has moved half an amplitude by the end.
Measure oscillates(const Description& description, double extension, double most) {
    const auto lowest = std::make_shared<double>(extension);
    const auto swing = [spring = description.springs[0], steps = description.steps, extension, most,
                        lowest](const State& state, unsigned step) {
        const double now = length(state[0].position - spring.anchor) - spring.length;
        *lowest = step == 0 ? now : std::min(*lowest, now);
        if (step == 0 && !(std::abs(now - extension) <= extension / 2)) return 2.0;
        if (step == steps && !(*lowest < extension / 2)) return 2.0;
        return std::abs(now) / (most * extension);
    };
    return {swing, fmt::format("extension at most {:.3g} m; starts within {:.3g} m of {:.3g} m and "
                               "has passed half of it by the end",
                               most * extension, extension / 2, extension)};
}

Experiment bounded(const Description& description, double extension = amplitude,
                   double most = growth) {
    return {description, oscillates(description, extension, most)};
}

// A row of bodies from an anchor at the origin, pulled at its far end.
Description chain(unsigned n, double stiffness, TimeStep dt, unsigned steps) {
    constexpr double link = 4;  // m
    Description made;
    for (unsigned i = 0; i < n; ++i) {
        made.bodies.push_back({.position = {link * (i + 1), 0}});
        Spring spring{{.a = int(i), .b = int(i) - 1, .length = link}, stiffness, 0};
        if (i == 0) spring.b = no_body;
        made.springs.push_back(spring);
    }
    made.bodies.back().position.x += amplitude;
    made.dt = dt;
    made.steps = steps;
    return made;
}

Experiment chain_experiment(unsigned n, double omega_dt) {
    const TimeStep dt = TimeStep::binary(4);
    const double omega = omega_dt / dt.value();
    const Description made = chain(n, omega * omega, dt, 600);
    return {made, stays_within(made, growth * amplitude)};
}

Description two_springs(double second_stiffness, double second_damping, double second_inverse) {
    Description made;
    made.bodies = {{.position = {8.25, 0}},
                   {.position = {16.25, 0}, .inverse_mass = second_inverse}};
    made.springs = {{{.a = 0, .length = 8}, 10, 0.5},
                    {{.a = 0, .b = 1, .length = 8}, second_stiffness, second_damping}};
    made.dt = TimeStep::binary(8);
    made.steps = 1024;
    return made;
}

// Each spring keeps the length at which it bears what hangs below it.
Measure springs_keep(const Description& description, double tolerance) {
    const auto lengths = [springs = description.springs](const State& state) {
        std::vector<double> all;
        for (const Spring& spring : springs)
            all.push_back(length(
                state[std::size_t(spring.a)].position -
                (spring.b == no_body ? spring.anchor : state[std::size_t(spring.b)].position)));
        return all;
    };
    State start;
    for (const Body& body : description.bodies) start.push_back({body.position, body.velocity});
    const auto off = [lengths, tolerance, at_start = lengths(start)](const State& state, unsigned) {
        const std::vector<double> now = lengths(state);
        double worst = 0;
        for (std::size_t i = 0; i < now.size(); ++i) {
            const double off = std::abs(now[i] / at_start[i] - 1) / tolerance;
            if (!(off <= worst)) worst = off;  // NaN too
        }
        return worst;
    };
    return {off, "springs within " + in_words(100 * tolerance, "% of their lengths at the start")};
}

// Light bodies below each other on stiff springs, the last with a mass of `ratio` of them, in
// balance and pushed sideways.
Experiment loaded_springs(unsigned n, double ratio) {
    constexpr double link = 0.5, stiffness = 20000, mass = 0.01, gravity = 9.81;
    Description made;
    double y = 0;
    for (unsigned i = 0; i < n; ++i) {
        y -= link + mass * (n - 1 - i + ratio) * gravity / stiffness;
        made.bodies.push_back({.position = {0, y}, .inverse_mass = 1 / mass});
        made.springs.push_back(
            {{.a = int(i), .b = i == 0 ? no_body : int(i) - 1, .length = link}, stiffness, 0});
    }
    made.bodies.back().inverse_mass /= ratio;
    made.bodies.back().velocity = {0.5, 0};
    made.gravity = {0, -gravity};
    made.dt = TimeStep::binary(8);
    made.steps = 400;
    return {made, springs_keep(made, 0.2)};
}
Case loaded_spring_chain(const char* name, unsigned n) {
    return {name,
            "springs",
            "mass ratio of the end",
            "1",
            1,
            1e6,
            "closed form: m g / k, within 20 % of the length",
            [n](double p) { return loaded_springs(n, p); },
            false,
            {"direct_springs", "gauss_seidel_springs", "implicit_midpoint"}};
}

Experiment at_step_product(double omega_dt, TimeStep dt, unsigned steps) {
    const double omega = omega_dt / dt.value();
    return bounded(on_spring(omega * omega, 0, 1, dt, steps));
}

}  // namespace

Case stiffness_at_step(int exponent, bool softer) {
    // Softer: long enough to move half an amplitude. Stiffer: as many steps as show growth.
    return {"stiffness",
            "map",
            "stiffness",
            "N/m",
            10,
            softer ? 1e-9 : 1e15,
            "closed form: amplitude",
            [=](double p) {
                const TimeStep dt = TimeStep::binary(exponent);
                const double period = 2 * pi / std::sqrt(p);
                const unsigned steps =
                    unsigned(std::min(20000.0, std::max(growth_steps, period / 3 / dt.value())));
                const Description made = on_spring(p, 0, 1, dt, steps);
                return softer ? bounded(made)
                              : Experiment{made, stays_within(made, growth * amplitude)};
            }};
}

std::vector<Case> spring_cases() {
    const char* bound = "closed form: amplitude";
    return {
        {"spring_coarse_step", "springs", "omega dt", "1", 0.03, 1e4, bound,
         [](double p) { return at_step_product(p, TimeStep::binary(2), 1000); }},
        {"spring_frame_step", "springs", "omega dt", "1", 0.01, 1e4, bound,
         [](double p) { return at_step_product(p, TimeStep::binary(6), 1000); }},
        {"spring_stiffness", "springs", "stiffness", "N/m", 10, 1e12, bound,
         [](double p) { return bounded(on_spring(p, 0, 1, TimeStep::binary(10), 1024)); }},
        {"spring_light_mass", "springs", "inverse mass", "1/kg", 1, 1e9, bound,
         [](double p) { return bounded(on_spring(10, 0, p, TimeStep::binary(8), 1000)); }},
        {"spring_light_and_stiff", "springs", "inverse mass", "1/kg", 1, 1e9, bound,
         [](double p) { return bounded(on_spring(10000, 0, p, TimeStep::binary(8), 1000)); }},
        {"spring_light_and_damped", "springs", "inverse mass", "1/kg", 1, 1e9, bound,
         [](double p) {
             const Description made = on_spring(10, 1000, p, TimeStep::binary(8), 1000);
             return Experiment{made, stays_within(made, growth * amplitude)};
         }},
        {"spring_heavy_mass", "springs", "inverse mass", "1/kg", 1, 1e-9, bound,
         [](double p) {
             const double period = 2 * pi / std::sqrt(100 * p);
             return bounded(on_spring(100, 0, p, TimeStep::of_seconds(period / 500), 500),
                            amplitude, 2);
         }},
        {"spring_with_weight", "springs", "stiffness", "N/m", 10, 1e10, "closed form: m g / k",
         [](double p) {
             Description made = on_spring(p, 2 * std::sqrt(p), 1, TimeStep::binary(8), 2048, 0, 1);
             made.bodies[0].position = {0, -1};
             made.gravity = {0, -9.81};
             return Experiment{made, all_of({stays_within(made, 4),
                                             from_step(2000, follows(
                                                                 made, 0,
                                                                 [p](double) {
                                                                     return Point{0, -1 - 9.81 / p};
                                                                 },
                                                                 0.05))})};
         }},
        {"spring_critically_damped", "springs", "omega dt", "1", 0.01, 1e4, "GSL msbdf",
         [](double p) {
             const double omega = 64 * p;
             const Description made =
                 on_spring(omega * omega, 2 * omega, 1, TimeStep::binary(6), 512, 1);
             return Experiment{made, follows_solver(made, Solver::msbdf, 0.2)};
         }},
        {"spring_overdamped", "springs", "damping", "N s/m", 1, 1e7, "GSL msbdf",
         [](double p) {
             const Description made = on_spring(10, p, 1, TimeStep::binary(8), 1024, 1);
             return Experiment{made, follows_solver(made, Solver::msbdf, 0.2)};
         }},
        {"spring_free_pair", "springs", "omega dt", "1", 0.03, 1e4, "conserved: momentum",
         [](double p) {
             const TimeStep dt = TimeStep::binary(4);
             const double omega = p / dt.value();
             Description made;
             made.bodies = {{.position = {0, 0}, .velocity = {0.25, 0}},
                            {.position = {8.25, 0}, .velocity = {0.25, 0}}};
             made.springs = {{{.a = 0, .b = 1, .length = 8}, omega * omega / 2, 0}};
             made.dt = dt;
             made.steps = 600;
             return Experiment{made,
                               all_of({centre_of_mass_keeps(made, 0.1), stays_within(made, 30)})};
         }},
        {"two_springs_stiffness_ratio", "springs", "stiffness ratio", "1", 1, 1e6, "GSL bsimp",
         [](double p) {
             const Description made = two_springs(10 * p, 2 * std::sqrt(10 * p), 1);
             return Experiment{made, follows_solver(made, Solver::bsimp, 0.1)};
         }},
        {"two_springs_mass_ratio", "springs", "mass ratio", "1", 1, 1e6, "GSL rk4imp",
         [](double p) {
             const Description made = two_springs(10, 1, 1 / p);
             return Experiment{made, follows_solver(made, Solver::rk4imp, 0.1)};
         }},
        {"two_springs_light_end", "springs", "mass ratio", "1", 1, 1e6, "GSL msbdf",
         [](double p) {
             const Description made = two_springs(10, 1, p);
             return Experiment{made, follows_solver(made, Solver::msbdf, 0.1)};
         }},
        {"spring_chain_of_4", "springs", "omega dt", "1", 0.03, 1e4, bound,
         [](double p) { return chain_experiment(4, p); }},
        {"spring_chain_of_16", "springs", "omega dt", "1", 0.03, 1e4, bound,
         [](double p) { return chain_experiment(16, p); }},
        loaded_spring_chain("spring_chain_of_4_heavy_end", 4),
        loaded_spring_chain("spring_chain_of_16_heavy_end", 16),
        {"spring_length", "springs", "rest length on both axes", "m", 1, 1e12, bound,
         [](double p) {
             Description made =
                 on_spring(40, 0, 1, TimeStep::binary(8), 512, amplitude, p * std::numbers::sqrt2);
             made.bodies[0].position = {p + 0.177, p + 0.177};
             return bounded(made, amplitude, 2);
         }},
        {"spring_extension", "springs", "extension", "m", 0.1, 1e10, bound,
         [](double p) {
             return bounded(on_spring(40, 0, 1, TimeStep::binary(8), 128, p, 1), p, 1.5);
         }},
        {"spring_small_extension", "springs", "extension", "m", 0.1, 1e-10, bound,
         [](double p) {
             return bounded(on_spring(40, 0, 1, TimeStep::binary(8), 256, p, 1), p, 2);
         }},
        {"spring_slow", "springs", "stiffness", "N/m", 10, 1e-8, bound,
         [](double p) {
             const double period = 2 * pi / std::sqrt(p);
             return bounded(on_spring(p, 0, 1, TimeStep::of_seconds(period / 300), 300), amplitude,
                            2);
         }},
        {"spring_phase", "springs", "omega dt", "1", 0.03, 10, "closed form: cosine",
         [](double p) {
             const TimeStep dt = TimeStep::binary(2);
             const double omega = p / dt.value();
             const Description made =
                 on_spring(omega * omega, 0, 1, dt, unsigned(std::ceil(4 * pi / p)), 1.0);
             return Experiment{made, follows(
                                         made, 0,
                                         [omega](double t) {
                                             return Point{rest + std::cos(omega * t), 0};
                                         },
                                         0.2)};
         }},
        {"drag_linear", "springs", "drag", "N s/m", 1, 1e9, "closed form: exponential",
         [](double p) {
             Description made;
             made.bodies = {{.velocity = {10, 0}}};
             made.drags = {{0, p, 0}};
             made.dt = TimeStep::binary(8);
             made.steps = 400;
             return Experiment{made, follows(
                                         made, 0,
                                         [p](double t) {
                                             return Point{10 * -std::expm1(-p * t) / p, 0};
                                         },
                                         0.5)};
         }},
        {"drag_quadratic", "springs", "speed", "m/s", 1, 1e9, "closed form: logarithm",
         [](double p) {
             Description made;
             made.bodies = {{.velocity = {p, 0}}};
             made.drags = {{0, 0, 0.25}};
             made.dt = TimeStep::binary(8);
             made.steps = 400;
             return Experiment{made, follows(
                                         made, 0,
                                         [p](double t) {
                                             return Point{std::log1p(0.25 * p * t) / 0.25, 0};
                                         },
                                         5)};
         }},
        {"orbit", "springs", "radius", "m", 0.1, 1e10, "closed form: circle",
         [](double p) {
             Description made;
             made.bodies = {{.position = {p, 0}, .velocity = {0, p}}};
             made.springs = {{{.length = 0}, 1, 0}};
             made.dt = TimeStep::binary(8);
             made.steps = 1600;
             return Experiment{made, follows(
                                         made, 0,
                                         [p](double t) {
                                             return Point{p * std::cos(t), p * std::sin(t)};
                                         },
                                         p / 10)};
         }},
    };
}

}  // namespace stability
