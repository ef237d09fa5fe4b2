// SPDX-License-Identifier: GPL-3.0-or-later
// Rods and ropes under loads, at speeds, over lengths and mass ratios.
#include <cmath>

#include "bench/experiments/stability/measures.hpp"

namespace stability {
namespace {

Description pendulum(Point start, double length, TimeStep dt, unsigned steps) {
    Description made;
    made.bodies = {{.position = start}};
    made.rods = {{.length = length}};
    made.dt = dt;
    made.steps = steps;
    return made;
}

Experiment holds(const Description& made, double tolerance = 0.05) {
    return {made, rods_hold(made, tolerance)};
}

Measure keeps_speed(double speed) {
    return {[speed](const State& state, unsigned) {
                return std::abs(length(state[0].velocity) / speed - 1) / 0.1;
            },
            "speed within " + in_words(0.1 * speed, "m/s of that at the start")};
}

constexpr double link_length = 0.5, chain_gravity = 9.81;  // m, m/s^2

// Bodies of 1 kg hanging below each other, the last with another mass, pushed sideways.
Description hanging_chain(unsigned n, double last_inverse_mass, int exponent = 8) {
    Description made;
    for (unsigned i = 0; i < n; ++i)
        made.bodies.push_back({.position = {0, -link_length * (i + 1)}});
    made.bodies.back().inverse_mass = last_inverse_mass;
    made.bodies.back().velocity = {0.5, 0};
    made.gravity = {0, -chain_gravity};
    made.dt = TimeStep::binary(exponent);
    made.steps = 400u << (exponent - 8);
    return made;
}

Experiment rod_chain_in_steps(unsigned n, double last_inverse_mass, int exponent) {
    Description made = hanging_chain(n, last_inverse_mass, exponent);
    for (unsigned i = 0; i < n; ++i)
        made.rods.push_back(
            {.a = int(i), .b = i == 0 ? no_body : int(i) - 1, .length = link_length});
    return holds(made, 0.2);
}
Experiment rod_chain(unsigned n, double last_inverse_mass) {
    return rod_chain_in_steps(n, last_inverse_mass, 8);
}
// Steps that resolve the light bodies' vibration under a weight of 10^5 of them.
Experiment rod_chain_in_fine_steps(unsigned n, double last_inverse_mass) {
    return rod_chain_in_steps(n, last_inverse_mass, 11);
}

Experiment rope_chain(unsigned n, double last_inverse_mass) {
    Description made = hanging_chain(n, last_inverse_mass);
    for (unsigned i = 0; i < n; ++i)
        made.ropes.push_back(
            {{.a = int(i), .b = i == 0 ? no_body : int(i) - 1, .length = link_length}, 0});
    return {made, ropes_hold(made, 0.2)};
}

Description lever(TimeStep dt, unsigned steps) {
    Description made;
    made.bodies = {{.position = {0.14, 0.08}, .inverse_mass = 10, .force = {0.3, 0.5}}};
    made.rods = {{.anchor = {0.38, 0.15}, .length = 0.25}};
    made.gravity = {0, -9.81};
    made.dt = dt;
    made.steps = steps;
    return made;
}

Case chain_case(const char* name, unsigned n, Experiment (*of)(unsigned, double), double towards) {
    return {name,
            "links",
            "mass ratio of the end",
            "1",
            1,
            1e6,
            "constraint: lengths within 20 %",
            [=](double p) { return of(n, towards > 0 ? 1 / p : p); }};
}
Case loaded_chain(const char* name, unsigned n, Experiment (*of)(unsigned, double)) {
    Case made = chain_case(name, n, of, 1);
    made.more_methods = {"one_iteration", "warm_started", "direct_rods"};
    return made;
}

}  // namespace

Case mass_ratio_at_links(unsigned links) {
    Case made = chain_case("mass_ratio", links, rod_chain, 1);
    made.group = "map";
    return made;
}

Case speed_at_length(double rod, int exponent) {
    return {"speed",
            "map",
            "speed",
            "m/s",
            rod / 4,
            rod * 1e6,
            "constraint: length within 5 %, speed within 10 %",
            [=](double p) {
                Description made = pendulum({rod, 0}, rod, TimeStep::binary(exponent), 400);
                made.bodies[0].velocity = {0, p};
                return Experiment{made, all_of({rods_hold(made, 0.05), keeps_speed(p)})};
            }};
}

std::vector<Case> link_cases() {
    const char* held = "constraint: length within 5 %";
    constexpr double heavy = 1, light = -1;
    return {
        {"rod_speed", "links", "speed", "m/s", 0.1, 1e9, held,
         [](double p) {
             Description made = pendulum({1, 0}, 1, TimeStep::binary(10), 1000);
             made.bodies[0].velocity = {0, p};
             return Experiment{made, all_of({rods_hold(made, 0.05), keeps_speed(p)})};
         }},
        {"rod_weight", "links", "gravity", "m/s^2", 1, 1e10, held,
         [](double p) {
             Description made = pendulum({0, -1}, 1, TimeStep::binary(8), 500);
             made.gravity = {0, -p};
             return holds(made);
         }},
        {"pendulum_gravity", "links", "gravity", "m/s^2", 1, 1e10, "conserved: energy",
         [](double p) {
             Description made = pendulum({0.6, -0.8}, 1, TimeStep::binary(10), 1000);
             made.gravity = {0, -p};
             return Experiment{
                 made, all_of({rods_hold(made, 0.05), energy_does_not_grow(made, 0.2, 0.2 * p)})};
         }},
        {"pendulum_long", "links", "length", "m", 1, 1e12, "GSL rk8pd",
         [](double p) {
             Description made = pendulum({0.6 * p, -0.8 * p}, p, TimeStep::binary(8), 1000);
             made.gravity = {0, -9.81};
             const auto angle = pendulum_angle(std::asin(0.6), 9.81, p);
             return Experiment{
                 made,
                 all_of({rods_hold(made, 0.05),
                         follows(
                             made, 0,
                             [angle, p](double t) {
                                 return Point{p * std::sin(angle(t)), -p * std::cos(angle(t))};
                             },
                             2)})};
         }},
        {"rod_short", "links", "length", "m", 1, 1e-9, held,
         [](double p) {
             Description made = pendulum({0.6 * p, -0.8 * p}, p, TimeStep::binary(10), 1000);
             made.gravity = {0, -9.81};
             return holds(made, 0.1);
         }},
        {"rod_pull", "links", "force", "N", 1, 1e10, held,
         [](double p) {
             Description made = pendulum({0, -1}, 1, TimeStep::binary(8), 500);
             made.bodies[0].force = {0, -p};
             return holds(made);
         }},
        {"rod_light_mass", "links", "inverse mass", "1/kg", 1, 1e10, held,
         [](double p) {
             Description made = pendulum({1, 0}, 1, TimeStep::binary(8), 500);
             made.bodies[0].inverse_mass = p;
             made.bodies[0].force = {1, 0};
             return holds(made);
         }},
        {"rod_heavy_mass", "links", "inverse mass", "1/kg", 1, 1e-12, "closed form: circle",
         [](double p) {
             Description made = pendulum({1, 0}, 1, TimeStep::binary(8), 256);
             made.bodies[0].inverse_mass = p;
             made.bodies[0].velocity = {0, 1};
             return Experiment{made, follows(
                                         made, 0,
                                         [](double t) {
                                             return Point{std::cos(t), std::sin(t)};
                                         },
                                         0.1)};
         }},
        {"rod_mass_ratio", "links", "mass ratio", "1", 1, 1e9, held,
         [](double p) {
             Description made;
             made.bodies = {{.position = {-0.5, 0}, .velocity = {0, 1}},
                            {.position = {0.5, 0}, .velocity = {0, -1 / p}, .inverse_mass = 1 / p}};
             made.rods = {{.a = 0, .b = 1, .length = 1}};
             made.dt = TimeStep::binary(8);
             made.steps = 1000;
             return Experiment{made, all_of({rods_hold(made, 0.05), stays_within(made, 3)})};
         }},
        chain_case("rod_chain_of_2_heavy_end", 2, rod_chain, heavy),
        loaded_chain("rod_chain_of_4_heavy_end", 4, rod_chain),
        loaded_chain("rod_chain_of_8_heavy_end", 8, rod_chain),
        loaded_chain("rod_chain_of_16_heavy_end", 16, rod_chain),
        loaded_chain("rod_chain_of_4_heavy_end_fine_steps", 4, rod_chain_in_fine_steps),
        loaded_chain("rod_chain_of_8_heavy_end_fine_steps", 8, rod_chain_in_fine_steps),
        loaded_chain("rod_chain_of_16_heavy_end_fine_steps", 16, rod_chain_in_fine_steps),
        // A ball of 10 kg hits the end of a chain of bodies of 1 kg from the side. A step ends
        // where it overlaps the end by half of the radii, at every speed.
        {"impact_on_chain_of_8",
         "links",
         "speed",
         "m/s",
         0.5,
         1e6,
         "constraint: lengths within 20 %",
         [](double p) {
             constexpr double radius = 0.1;
             Description made = hanging_chain(8, 1);
             for (unsigned i = 0; i < 8; ++i)
                 made.rods.push_back(
                     {.a = int(i), .b = i == 0 ? no_body : int(i) - 1, .length = link_length});
             made.bodies.back().velocity = {};
             made.bodies.back().radius = radius;
             const Point end = made.bodies.back().position;
             made.bodies.push_back({.position = end - Point{radius + 4 * p * made.dt.value(), 0},
                                    .velocity = {p, 0},
                                    .inverse_mass = 0.1,
                                    .radius = radius});
             return holds(made, 0.2);
         },
         false,
         {"one_iteration", "warm_started"}},
        chain_case("rod_chain_of_2_light_end", 2, rod_chain, light),
        chain_case("rod_chain_of_8_light_end", 8, rod_chain, light),
        chain_case("rope_chain_of_4_heavy_end", 4, rope_chain, heavy),
        chain_case("rope_chain_of_16_heavy_end", 16, rope_chain, heavy),
        chain_case("rope_chain_of_4_light_end", 4, rope_chain, light),
        {"rope_pull", "links", "force", "N", 1, 1e10, held,
         [](double p) {
             Description made;
             made.bodies = {{.position = {0, -1}, .force = {0, -p}}};
             made.ropes = {{{.length = 1}, 0}};
             made.dt = TimeStep::binary(8);
             made.steps = 500;
             return Experiment{made, ropes_hold(made, 0.05)};
         }},
        {"rope_weight", "links", "gravity", "m/s^2", 1, 1e10, held,
         [](double p) {
             Description made;
             made.bodies = {{.position = {0, -1}}};
             made.ropes = {{{.length = 1}, 0}};
             made.gravity = {0, -p};
             made.dt = TimeStep::binary(8);
             made.steps = 500;
             return Experiment{made, ropes_hold(made, 0.05)};
         }},
        {"rope_short", "links", "length", "m", 1, 1e-9, "constraint: length within 10 %",
         [](double p) {
             Description made;
             made.bodies = {{.position = {0.6 * p, -0.8 * p}}};
             made.ropes = {{{.length = p}, 0}};
             made.gravity = {0, -9.81};
             made.dt = TimeStep::binary(10);
             made.steps = 1000;
             return Experiment{made, ropes_hold(made, 0.1)};
         }},
        {"rope_pulled_taut", "links", "speed", "m/s", 0.5, 1e8, "constraint: length within 20 %",
         [](double p) {
             Description made;
             made.bodies = {{.position = {0, -0.5}, .velocity = {0, -p}}};
             made.ropes = {{{.length = 1}, 0.5}};
             made.dt = TimeStep::binary(8);
             made.steps = 500;
             return Experiment{made, ropes_hold(made, 0.2)};
         }},
        {"rod_too_long", "links", "distance by length", "1", 1.01, 1e9,
         "constraint: length and rest",
         [](double p) {
             Description made = pendulum({p, 0}, 1, TimeStep::binary(8), 200);
             return Experiment{
                 made, from_step(100, all_of({rods_hold(made, 0.05), has_velocity(0, {}, 1)}))};
         }},
        {"rod_too_short", "links", "distance by length", "1", 0.99, 1e-9,
         "constraint: length and rest",
         [](double p) {
             Description made = pendulum({p, 0}, 1, TimeStep::binary(8), 200);
             return Experiment{
                 made, from_step(100, all_of({rods_hold(made, 0.05), has_velocity(0, {}, 1)}))};
         }},
        {"rod_coincident_ends", "links", "length", "m", 0.1, 1e6, held,
         [](double p) {
             Description made = pendulum({0, 0}, p, TimeStep::binary(8), 100);
             return Experiment{made, from_step(50, rods_hold(made, 0.05))};
         }},
        {"lever_dial", "links", "length after", "m", 0.26, 1e9, held,
         [](double p) {
             Description made = lever(TimeStep::binary(8), 200);
             made.dial_step = 100;
             made.dial_length = p;
             Description turned = made;
             turned.rods[0].length = p;
             return Experiment{made, from_step(104, rods_hold(turned, 0.05))};
         }},
        {"lever_dial_shortened", "links", "length after", "m", 0.24, 1e-8, held,
         [](double p) {
             Description made = lever(TimeStep::binary(8), 200);
             made.dial_step = 100;
             made.dial_length = p;
             Description turned = made;
             turned.rods[0].length = p;
             return Experiment{made, from_step(104, rods_hold(turned, 0.1))};
         }},
        {"lever_dial_across", "links", "speed", "m/s", 0.1, 1e9,
         "constraint: length within 5 %, speed",
         [](double p) {
             // From one end of the dial to the other in one step, in mid-swing.
             constexpr double shortest = 0.23, longest = 0.48;  // m
             Description made = lever(TimeStep::binary(8), 200);
             made.bodies[0].position = made.rods[0].anchor - Point{shortest, 0};
             made.bodies[0].velocity = {0, p};
             made.rods[0].length = shortest;
             made.dial_step = 20;
             made.dial_length = longest;
             Description turned = made;
             turned.rods[0].length = longest;
             const Measure slow_enough = {[p](const State& state, unsigned) {
                                              // In addition to what gravity and the push give it.
                                              return length(state[0].velocity) / (p + 5);
                                          },
                                          "speed at most " + in_words(p + 5, "m/s")};
             return Experiment{made, from_step(24, all_of({rods_hold(turned, 0.05), slow_enough}))};
         }},
        {"lever_push", "links", "force", "N", 0.1, 1e9, held,
         [](double p) {
             Description made = lever(TimeStep::binary(8), 500);
             made.bodies[0].force = {-p, 0};
             return holds(made);
         }},
        {"lever_step", "links", "time step", "s", 0.001, 1, held,
         [](double p) { return holds(lever(TimeStep::of_seconds(p), 500)); }},
        {"pendulum_step", "links", "time step", "s", 0.001, 1, "conserved: energy",
         [](double p) {
             Description made = pendulum({0.6, -0.8}, 1, TimeStep::of_seconds(p), 500);
             made.gravity = {0, -9.81};
             return Experiment{made, all_of({rods_hold(made, 0.05),
                                             energy_does_not_grow(made, 0.5, 0.2 * 9.81)})};
         }},
        {"rod_span", "links", "half span on both axes", "m", 1, 1e12, held,
         [](double p) {
             Description made;
             made.bodies = {{.position = {-p, -p}, .velocity = {1, -1}},
                            {.position = {p, p}, .velocity = {-1, 1}}};
             made.rods = {{.a = 0, .b = 1, .length = std::sqrt(8.0) * p}};
             made.dt = TimeStep::binary(8);
             made.steps = 200;
             return holds(made);
         }},
    };
}

}  // namespace stability
