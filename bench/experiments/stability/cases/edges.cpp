// SPDX-License-Identifier: GPL-3.0-or-later
// The ends of number formats: what is too large or too small for them.
#include <cmath>
#include <numbers>

#include "bench/experiments/stability/measures.hpp"

namespace stability {
namespace {

// One body in flight, whose path must be right to a fraction of itself.
Experiment flight(const Body& body, Point gravity, TimeStep dt, unsigned steps,
                  double tolerance = 0.1) {
    Description made;
    made.bodies = {body};
    made.gravity = gravity;
    made.dt = dt;
    made.steps = steps;
    const Point pull = gravity + body.force * body.inverse_mass;
    const auto way = [body, pull](double t) { return body.velocity * t + pull * (t * t / 2); };
    const double scale = length(way(steps * dt.value()));
    return {made,
            from_step(steps, follows(
                                 made, 0, [body, way](double t) { return body.position + way(t); },
                                 tolerance * scale))};
}

}  // namespace

std::vector<Case> edge_cases() {
    const char* line = "closed form: uniform motion";
    const char* parabola = "closed form: parabola";
    return {
        {"far_from_origin", "edges", "position", "m", 1, 1e15, line,
         [](double p) {
             return flight({.position = {p, p}, .velocity = {-1, 1}}, {}, TimeStep::binary(8), 256);
         }},
        {"fast", "edges", "speed", "m/s", 1, 1e15, line,
         [](double p) {
             return flight({.velocity = {p, 0}}, {}, TimeStep::binary(8), 64);
         }},
        {"slow", "edges", "speed", "m/s", 10, 1e-12, line,
         [](double p) {
             return flight({.velocity = {p, 0}}, {}, TimeStep::binary(8), 256);
         }},
        {"slow_small_step", "edges", "speed", "m/s", 10, 1e-12, line,
         [](double p) {
             return flight({.velocity = {p, 0}}, {}, TimeStep::binary(12), 256);
         }},
        {"small_step", "edges", "time step", "s", 1, 1e-10, line,
         [](double p) {
             return flight({.velocity = {0.4, 0}}, {}, TimeStep::of_seconds(p), 200);
         }},
        {"small_binary_step", "edges", "time step", "s", 1, 1e-10, line,
         [](double p) {
             const int exponent = int(std::lround(-std::log2(p)));
             return flight({.velocity = {0.4, 0}}, {}, TimeStep::binary(exponent), 200);
         }},
        {"strong_gravity", "edges", "gravity", "m/s^2", 1, 1e12, parabola,
         [](double p) {
             return flight({}, {0, -p}, TimeStep::binary(8), 128);
         }},
        {"weak_gravity", "edges", "gravity", "m/s^2", 10, 1e-12, parabola,
         [](double p) {
             return flight({}, {0, -p}, TimeStep::binary(8), 128);
         }},
        {"strong_force", "edges", "force", "N", 1, 1e12, parabola,
         [](double p) {
             return flight({.inverse_mass = 1 / p, .force = {p, 0}}, {}, TimeStep::binary(8), 128);
         }},
        {"weak_force", "edges", "force", "N", 1, 1e-12, parabola,
         [](double p) {
             return flight({.inverse_mass = 1 / p, .force = {p, 0}}, {}, TimeStep::binary(8), 128);
         }},
        {"light_body", "edges", "inverse mass", "1/kg", 1, 1e12, parabola,
         [](double p) {
             return flight({.inverse_mass = p, .force = {0.1, 0}}, {}, TimeStep::binary(8), 128);
         }},
        {"heavy_body", "edges", "inverse mass", "1/kg", 1, 1e-12, parabola,
         [](double p) {
             return flight({.inverse_mass = p, .force = {10, 0}}, {}, TimeStep::binary(8), 128);
         }},
        {"throw", "edges", "speed", "m/s", 1, 1e10, parabola,
         [](double p) {
             return flight({.velocity = {p, p}}, {0, -9.81}, TimeStep::binary(8), 256);
         }},
        {"damping_factor", "edges", "damping a step", "1", 0.1, 1e-9, "closed form: power",
         [](double p) {
             Description made;
             made.bodies = {{.velocity = {10, 0}, .damping = 1 - p}};
             made.dt = TimeStep::binary(8);
             made.steps = unsigned(std::min(4000.0, std::ceil(1 / p)));
             const double left = 10 * std::pow(1 - p, made.steps);
             return Experiment{
                 made, from_step(made.steps, has_velocity(0, {left, 0}, 0.2 * (10 - left)))};
         }},
        {"distant_pair", "edges", "half distance on both axes", "m", 1, 1e12,
         "closed form: no contact",
         [](double p) {
             Description made;
             made.bodies = {{.position = {p, p}, .radius = 0.5},
                            {.position = {-p, -p}, .radius = 0.5}};
             made.restitution = 1;
             made.dt = TimeStep::binary(8);
             made.steps = 50;
             return Experiment{made, stays_within(made, 0.01)};
         }},
        {"plane_far_away", "edges", "offset", "m", 1, 1e12, "closed form: rest",
         [](double p) {
             Description made;
             made.planes = {{{0, 1}, p, 0}};
             made.bodies = {{.position = {0, p + 0.25}, .radius = 0.25}};
             made.gravity = {0, -9.81};
             made.restitution_threshold = 0.25;
             made.dt = TimeStep::binary(8);
             made.steps = 300;
             return Experiment{made, stays_within(made, 0.1)};
         }},
        {"plane_oblique", "edges", "distance along it", "m", 1, 1e12, "closed form: rest",
         [](double p) {
             const double c = std::numbers::sqrt2 / 2;
             Description made;
             made.planes = {{{-c, c}, 0, 0}};
             made.bodies = {{.position = {p - 0.25 * c, p + 0.25 * c}, .radius = 0.25}};
             made.gravity = {9.81 * c, -9.81 * c};
             made.restitution_threshold = 0.25;
             made.dt = TimeStep::binary(8);
             made.steps = 300;
             return Experiment{made, stays_within(made, 0.1)};
         }},
    };
}

}  // namespace stability
