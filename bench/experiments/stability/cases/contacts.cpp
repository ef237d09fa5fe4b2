// SPDX-License-Identifier: GPL-3.0-or-later
// Collisions, stacks, resting contact, overlap and immovable bodies.
#include <cmath>
#include <memory>
#include <numbers>

#include "bench/experiments/stability/measures.hpp"

namespace stability {
namespace {

constexpr double radius = 0.25;  // m
const Plane floor_plane{{0, 1}, 0, 0};

Body ball(Point position, Point velocity = {}, double inverse_mass = 1, double r = radius) {
    return {.position = position, .velocity = velocity, .inverse_mass = inverse_mass, .radius = r};
}

Description on_floor(double gravity, TimeStep dt, unsigned steps, double restitution = 0) {
    Description made;
    made.gravity = {0, -gravity};
    made.planes = {floor_plane};
    made.planes[0].restitution = restitution;
    made.restitution = restitution;
    made.restitution_threshold = 0.25;
    made.dt = dt;
    made.steps = steps;
    return made;
}

Description stack_of(unsigned n, double gravity, unsigned steps) {
    Description made = on_floor(gravity, TimeStep::binary(8), steps);
    for (unsigned i = 0; i < n; ++i) made.bodies.push_back(ball({0, radius * (2 * i + 1)}));
    return made;
}

Experiment stack_experiment(unsigned n, double gravity) {
    const Description made = stack_of(n, gravity, 500);
    return {made, all_of({no_overlap(made, 0.2), stays_within(made, radius)})};
}

// Two in a line, elastic; with the closed form of the velocities afterwards.
Experiment head_on(double first_inverse, double second_inverse) {
    Description made;
    made.bodies = {ball({-1, 0}, {1, 0}, first_inverse), ball({0.5, 0}, {}, second_inverse)};
    made.restitution = 1;
    made.dt = TimeStep::binary(8);
    made.steps = 400;
    const double share = first_inverse / (first_inverse + second_inverse);
    return {made, from_step(390, all_of({has_velocity(0, {1 - 2 * share, 0}, 0.05),
                                         has_velocity(1, {2 * (1 - share), 0}, 0.05)}))};
}

// Between two walls and nothing else, for that many steps; a bounce takes about 6.4.
Experiment between_walls(double steps) {
    Description made;
    made.planes = {{{1, 0}, 0, 1}, {{-1, 0}, -0.6, 1}};
    made.bodies = {ball({0.3, 0}, {4, 0})};
    made.restitution = 1;
    made.dt = TimeStep::binary(8);
    made.steps = unsigned(steps);
    return {made,
            {[](const State& state, unsigned) {
                 return std::max(std::abs(std::abs(state[0].velocity.x) / 4 - 1) / 0.1,
                                 std::abs(state[0].position.x - 0.3) / 0.2);
             },
             "speed within 10 % of 4 m/s; position within 0.2 m of the middle"}};
}

// Where a ball with `reach` to its target's centre starts, so that the step before it touches ends
// just short of it: the start that takes it deepest into the target.
double just_short_of(double reach, double speed, TimeStep dt) {
    return -1.01 * reach - 4 * speed * dt.value();
}

Experiment at_rest(double steps, double restitution, double restitution_threshold) {
    Description made = on_floor(9.81, TimeStep::binary(8), unsigned(steps), restitution);
    made.restitution_threshold = restitution_threshold;
    made.bodies = {ball({0, radius + 0.01})};
    return {made, from_step(256, all_of({no_overlap(made, 0.1), stays_within(made, 0.05)}))};
}

Experiment part(std::vector<Body> bodies) {
    Description made;
    made.bodies = std::move(bodies);
    made.dt = TimeStep::binary(8);
    made.steps = 200;
    return {made, all_of({from_step(100, no_overlap(made, 0.05)),
                          {[](const State& state, unsigned) {
                               double fastest = 0;
                               for (const BodyState& body : state)
                                   fastest = std::max(fastest, length(body.velocity));
                               return fastest / 0.5;
                           },
                           "speeds at most 0.5 m/s"},
                          stays_within(made, 10 * made.bodies[0].radius)})};
}

}  // namespace

std::vector<Case> contact_cases() {
    const char* momentum = "closed form: elastic collision";
    const char* apart = "constraint: no overlap beyond 20 %";
    const char* geometry = "closed form: no way through";
    return {
        {"collision_heavy_target", "contacts", "mass ratio", "1", 1, 1e9, momentum,
         [](double p) { return head_on(1, 1 / p); }},
        {"collision_light_target", "contacts", "mass ratio", "1", 1, 1e9, momentum,
         [](double p) { return head_on(1, p); }},
        {"stack_of_2", "contacts", "gravity", "m/s^2", 1, 1e8, apart,
         [](double p) { return stack_experiment(2, p); }},
        {"stack_of_5", "contacts", "gravity", "m/s^2", 1, 1e8, apart,
         [](double p) { return stack_experiment(5, p); }},
        {"stack_of_10", "contacts", "gravity", "m/s^2", 1, 1e8, apart,
         [](double p) { return stack_experiment(10, p); }},
        {"stack_of_20", "contacts", "gravity", "m/s^2", 1, 1e8, apart,
         [](double p) { return stack_experiment(20, p); }},
        {"stack_heavy_top", "contacts", "mass ratio", "1", 1, 1e6, apart,
         [](double p) {
             Description made = stack_of(3, 9.81, 500);
             made.bodies[2].inverse_mass = 1 / p;
             return Experiment{made, all_of({no_overlap(made, 0.2), stays_within(made, radius)})};
         }},
        {"stack_light_top", "contacts", "mass ratio", "1", 1, 1e6, apart,
         [](double p) {
             Description made = stack_of(3, 9.81, 500);
             made.bodies[2].inverse_mass = p;
             return Experiment{made, all_of({no_overlap(made, 0.2), stays_within(made, radius)})};
         }},
        {"cradle_of_5", "contacts", "speed", "m/s", 0.1, 1e6, momentum,
         [](double p) {
             Description made;
             made.bodies = {ball({-1, 0}, {p, 0})};
             for (unsigned i = 0; i < 4; ++i) made.bodies.push_back(ball({i * 2 * radius, 0}));
             made.restitution = 1;
             made.dt = TimeStep::of_seconds(0.02 / p);
             made.steps = 60;
             std::vector<Measure> after;
             for (unsigned i = 0; i < 5; ++i)
                 after.push_back(has_velocity(i, {i == 4 ? p : 0, 0}, 0.1 * p));
             return Experiment{made, from_step(55, all_of(after))};
         }},
        {"thin_wall",
         "contacts",
         "speed",
         "m/s",
         0.1,
         1e7,
         geometry,
         [](double p) {
             Description made;
             made.dt = TimeStep::binary(8);
             made.bodies = {ball({just_short_of(0.1, p, made.dt), 0}, {p, 0}, 1, 0.05)};
             for (int i = -1; i <= 1; ++i) made.bodies.push_back(ball({0, 0.1 * i}, {}, 0, 0.05));
             made.restitution = 0.5;
             made.steps = unsigned(std::min(4000.0, 500 + 512 / p));
             return Experiment{
                 made,
                 {[](const State& state, unsigned) { return 1 + state[0].position.x - 0.05; },
                  "at most 0.05 m beyond the middle of the wall"}};
         },
         false,
         {"continuous_contacts"}},
        {"thin_target",
         "contacts",
         "speed",
         "m/s",
         0.1,
         1e7,
         geometry,
         [](double p) {
             Description made;
             made.dt = TimeStep::binary(8);
             made.bodies = {ball({just_short_of(0.1, p, made.dt), 0}, {p, 0}, 1, 0.05),
                            ball({0, 0}, {}, 1, 0.05)};
             made.restitution = 0.5;
             made.steps = unsigned(std::min(4000.0, 50 + 512 / p));
             return Experiment{made,
                               {[](const State& state, unsigned) {
                                    return 1 + state[0].position.x - state[1].position.x;
                                },
                                "body 0 not beyond the middle of body 1"}};
         },
         false,
         {"continuous_contacts"}},
        {"half_space", "contacts", "speed", "m/s", 0.5, 1e10, geometry,
         [](double p) {
             Description made;
             made.bodies = {ball({1, 0}, {-p, 0})};
             made.planes = {{{1, 0}, 0, 0.5}};
             made.dt = TimeStep::binary(8);
             made.steps = unsigned(std::min(1000.0, 10 + 512 / p));
             const Measure outside = {[](const State& state, unsigned) {
                                          const double out = state[0].velocity.x;
                                          return out > 0 ? (radius - state[0].position.x) / 0.05
                                                         : 2.0;
                                      },
                                      "moves out of the plane; at most 0.05 m deep in it"};
             return Experiment{made, from_step(made.steps, outside)};
         }},
        {"bounces_elastic", "contacts", "steps of 100000 bounces", "1", 1, 640000,
         "conserved: energy", between_walls, true},
        {"bounces_under_gravity", "contacts", "steps of 1000 bounces", "1", 1, 160000,
         "conserved: energy",
         [](double steps) {
             Description made = on_floor(9.81, TimeStep::binary(8), unsigned(steps), 1.0);
             made.bodies = {ball({0, 1})};
             const auto highest = std::make_shared<double>(1);
             const Measure height = {[highest](const State& state, unsigned step) {
                                         constexpr unsigned window = 256;
                                         const double y = state[0].position.y;
                                         const double before = *highest;
                                         *highest = step % window == 0 ? y : std::max(before, y);
                                         if (step == 0 || step % window != 0) return (y - 1) / 0.15;
                                         return std::abs(before - 1) / 0.15;
                                     },
                                     "highest point of each 256 steps within 0.15 m of 1 m"};
             return Experiment{made, height};
         },
         true},
        {"bounces_inelastic", "contacts", "steps in contact", "1", 1, 100000, "closed form: rest",
         [](double steps) { return at_rest(steps, 0, 0); }, true},
        {"resting_contact", "contacts", "steps at rest", "1", 1, 1000000, "closed form: rest",
         [](double steps) { return at_rest(steps, 0.5, 0.25); }, true},
        {"resting_without_threshold", "contacts", "steps at rest", "1", 1, 100000,
         "closed form: rest", [](double steps) { return at_rest(steps, 0.5, 0); }, true},
        {"resting_on_another", "contacts", "steps at rest", "1", 1, 100000, "closed form: rest",
         [](double steps) {
             const Description made = stack_of(2, 9.81, unsigned(steps));
             return Experiment{made, all_of({no_overlap(made, 0.2), stays_within(made, radius)})};
         },
         true},
        {"resting_weight", "contacts", "gravity", "m/s^2", 1, 1e8, apart,
         [](double p) { return stack_experiment(1, p); }},
        {"resting_light_mass", "contacts", "inverse mass", "1/kg", 1, 1e10, apart,
         [](double p) {
             Description made = stack_of(2, 9.81, 500);
             for (Body& body : made.bodies) body.inverse_mass = p;
             return Experiment{made, all_of({no_overlap(made, 0.2), stays_within(made, radius)})};
         }},
        {"resting_heavy_mass", "contacts", "inverse mass", "1/kg", 1, 1e-10, apart,
         [](double p) {
             Description made = stack_of(2, 9.81, 500);
             for (Body& body : made.bodies) body.inverse_mass = p;
             return Experiment{made, all_of({no_overlap(made, 0.2), stays_within(made, radius)})};
         }},
        {"collision_small", "contacts", "radius", "m", 0.5, 1e-10, momentum,
         [](double p) {
             Description made;
             made.bodies = {ball({-2 * p, 0}, {4 * p, 0}, 1, p), ball({p, 0}, {}, 1, p)};
             made.restitution = 1;
             made.dt = TimeStep::binary(8);
             made.steps = 128;
             return Experiment{
                 made,
                 from_step(120, all_of({has_velocity(0, {}, p), has_velocity(1, {4 * p, 0}, p)}))};
         }},
        {"collision_large", "contacts", "radius", "m", 0.5, 1e12, momentum,
         [](double p) {
             Description made;
             made.bodies = {ball({-p - 0.5, 0}, {2, 0}, 1, p), ball({p, 0}, {}, 1, p)};
             made.restitution = 1;
             made.dt = TimeStep::binary(8);
             made.steps = 200;
             return Experiment{
                 made,
                 from_step(190, all_of({has_velocity(0, {}, 0.2), has_velocity(1, {2, 0}, 0.2)}))};
         }},
        {"overlap_at_start", "contacts", "overlap by diameter", "1", 0.01, 0.999, apart,
         [](double p) {
             return part({ball({0, 0}), ball({2 * radius * (1 - p), 0})});
         }},
        {"overlap_oblique", "contacts", "distance", "m", 0.25, 1e-12, apart,
         [](double p) {
             return part({ball({0, 0}), ball({0.6 * p, 0.8 * p})});
         }},
        {"coincident_two", "contacts", "radius", "m", 0.1, 1e6, apart,
         [](double p) {
             return part({ball({1, 1}, {}, 1, p), ball({1, 1}, {}, 1, p)});
         }},
        {"coincident_three", "contacts", "radius", "m", 0.1, 1e6, apart,
         [](double p) {
             return part({ball({1, 1}, {}, 1, p), ball({1, 1}, {}, 1, p), ball({1, 1}, {}, 1, p)});
         }},
        {"coincident_spring_ends", "contacts", "stiffness", "N/m", 1, 1e6,
         "closed form: no direction, no force",
         [](double p) {
             Description made;
             made.bodies = {{.position = {1, 1}}, {.position = {1, 1}}};
             made.springs = {{{.a = 0, .b = 1, .length = 0.5}, p, 0}};
             made.dt = TimeStep::binary(8);
             made.steps = 100;
             return Experiment{made, stays_within(made, 4)};
         }},
        {"immovable_all", "contacts", "gravity", "m/s^2", 1, 1e6, "closed form: rest",
         [](double p) {
             Description made = on_floor(p, TimeStep::binary(8), 100, 1);
             made.bodies = {ball({0, 0.1}, {}, 0), ball({0.1, 0.1}, {}, 0)};
             made.springs = {{{.a = 0, .b = 1, .length = 0.5}, 100, 1}};
             made.rods = {{.a = 0, .b = 1, .length = 0.5}};
             return Experiment{made, stays_within(made, 0.01)};
         }},
        {"immovable_one", "contacts", "speed", "m/s", 0.5, 1e6, momentum,
         [](double p) {
             Description made;
             made.bodies = {ball({-1, 0}, {p, 0}), ball({0, 0}, {}, 0)};
             made.restitution = 1;
             made.dt = TimeStep::of_seconds(0.02 / p);
             made.steps = 100;
             return Experiment{made, from_step(95, has_velocity(0, {-p, 0}, 0.1 * p))};
         }},
        {"immovable_none", "contacts", "speed", "m/s", 0.5, 1e6, momentum,
         [](double p) {
             Description made;
             made.bodies = {ball({-1, 0}, {p, 0}), ball({0, 0}, {})};
             made.restitution = 1;
             made.dt = TimeStep::of_seconds(0.02 / p);
             made.steps = 100;
             return Experiment{made, from_step(95, all_of({has_velocity(0, {}, 0.1 * p),
                                                           has_velocity(1, {p, 0}, 0.1 * p)}))};
         }},
        {"wedge", "contacts", "gravity", "m/s^2", 1, 1e8, apart,
         [](double p) {
             Description made = on_floor(p, TimeStep::binary(8), 500);
             const double c = std::numbers::sqrt2 / 2;
             made.planes = {{{c, c}, 0, 0}, {{-c, c}, 0, 0}};
             made.bodies = {ball({0, radius / c})};
             return Experiment{made, all_of({no_overlap(made, 0.2), stays_within(made, radius)})};
         }},
        // Two balls of 1 kg in a V, touching each other and its walls, and a heavy one on them.
        {"wedge_heavy_top",
         "contacts",
         "mass ratio",
         "1",
         1,
         1e6,
         apart,
         [](double p) {
             Description made = on_floor(9.81, TimeStep::binary(8), 500);
             const double c = std::numbers::sqrt2 / 2, height = radius / c + radius;
             made.planes = {{{c, c}, 0, 0}, {{-c, c}, 0, 0}};
             made.bodies = {ball({-radius, height}), ball({radius, height}),
                            ball({0, height + radius * std::numbers::sqrt3}, {}, 1 / p)};
             return Experiment{made,
                               all_of({no_overlap(made, 0.2), stays_within(made, 2 * radius)})};
         },
         false,
         {"one_iteration", "warm_started"}},
        {"box_of_8", "contacts", "speed", "m/s", 0.1, 1e6, "conserved: energy",
         [](double p) {
             Description made;
             made.planes = {{{1, 0}, 0, 1}, {{-1, 0}, -4, 1}, {{0, 1}, 0, 1}, {{0, -1}, -4, 1}};
             for (int i = 0; i < 8; ++i) {
                 const double turn = 2.399963 * i;  // the golden angle
                 const int column = i % 4, row = i / 4;
                 made.bodies.push_back(ball({0.5 + column, 1.0 + 2.0 * row},
                                            {p * std::cos(turn), p * std::sin(turn)}));
             }
             made.restitution = 1;
             made.dt = TimeStep::binary(8);
             made.steps = 500;
             return Experiment{
                 made, all_of({energy_does_not_grow(made, 0.2, 4 * p * p), stays_within(made, 8)})};
         }},
        {"large_step_rest", "contacts", "time step", "s", 0.001, 1, "closed form: rest",
         [](double p) {
             Description made = on_floor(9.81, TimeStep::of_seconds(p), 500, 0);
             made.bodies = {ball({0, radius})};
             return Experiment{made, all_of({no_overlap(made, 0.5), stays_within(made, 0.5)})};
         }},
    };
}

}  // namespace stability
