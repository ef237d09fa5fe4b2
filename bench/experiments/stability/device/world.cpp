// SPDX-License-Identifier: GPL-3.0-or-later
// A Q16.16 world on the chip that is built from outside, number by number: -DMETHOD=... and
// -DARITHMETIC=... determine how it moves, -DEXPONENT=8 a step of 2^-8 s, and the other macros its
// capacities.
#include <engine.h>

#include <engine/hash.hpp>

#include "bench/experiments/stability/methods.hpp"

using Scalar = fixedpoint::Fixed<16, 16, ARITHMETIC>;

struct Scene : scenes::UsesWith<METHOD> {
    static constexpr unsigned char dimensions = stability::DimensionsOf<METHOD>::value;
    static constexpr unsigned particles = PARTICLES, springs = SPRINGS,
                              anchored_springs = ANCHORED_SPRINGS, drags = DRAGS, rods = RODS,
                              anchored_rods = ANCHORED_RODS, ropes = ROPES,
                              anchored_ropes = ANCHORED_ROPES, planes = PLANES;
    // Rods that are contacts take contact rows.
    static constexpr unsigned contacts = CONTACTS + (METHOD::Solver::rows_per_rod > 1);
    using BroadPhase = typename stability::BroadPhaseOf<METHOD>::Type;
    static constexpr bool gravity = GRAVITY, damping = DAMPING, collisions = COLLISIONS,
                          radii = COLLISIONS || PLANES, custom_force = FORCES,
                          compensated_integration = stability::IsCompensated<METHOD>::value,
                          continuous_contacts = stability::HasContinuousContacts<METHOD>::value;
#if FORCES
    template <class World>
    using CustomForce = stability::ConstantForces<World>;
#endif
};

using World = engine::World<Scalar, Scene>;
World world;
using engine::only_if;

extern "C" {

// The arguments of the next call: numbers in SI units, three for a vector, and the particles at
// both ends; the second may be none.
Scalar numbers[12];
struct {
    uint8_t a, b;
} ends;
}

constexpr uint8_t none = 255;
World::Vector vector(uint8_t i) {
    World::Vector v;
    for (uint8_t axis = 0; axis < World::dimensions; ++axis) v[axis] = numbers[i + axis];
    return v;
}
World::Handle handle(uint8_t i) { return {static_cast<World::Index>(i)}; }

#define FROM_OUTSIDE extern "C" __attribute__((noinline))
// Keeps a function that has nothing to do in this world, so that it is linked.
inline void keep() { __asm__ volatile(""); }

// Gravity, restitution, restitution threshold.
FROM_OUTSIDE void set_world() {
    keep();
    only_if<GRAVITY>(world, [](auto& w) { w.gravity = vector(0); });
    only_if<World::bounces>(world, [](auto& w) {
        w.set_restitution(numbers[3]);
        w.set_restitution_threshold(numbers[4]);
    });
}
// Position, velocity, inverse mass, radius, damping, force.
FROM_OUTSIDE void add_particle() {
    World::Body body;
    body.position = vector(0);
    body.velocity = vector(3);
    body.inverse_mass = numbers[6];
    body.radius = numbers[7];
    body.damping = numbers[8];
    const auto added = world.add_particle(body);
    only_if<FORCES>(world, [&](auto& w) {
        if (added) w.custom_force().force[added.index] = vector(9);
    });
}
// Length, anchor, stiffness, damping.
FROM_OUTSIDE void add_spring() {
    keep();
    only_if<(ANCHORED_SPRINGS > 0)>(world, [](auto& w) {
        if (ends.b == none) {
            w.add_anchored_spring(handle(ends.a), vector(1), numbers[4], numbers[5], numbers[0]);
        }
    });
    only_if<(SPRINGS > 0)>(world, [](auto& w) {
        if (ends.b != none) {
            w.add_spring(handle(ends.a), handle(ends.b), numbers[4], numbers[5], numbers[0]);
        }
    });
}
// Length, anchor.
FROM_OUTSIDE void add_rod() {
    keep();
    only_if<(ANCHORED_RODS > 0)>(world, [](auto& w) {
        if (ends.b == none) w.add_anchored_rod(handle(ends.a), vector(1), numbers[0]);
    });
    only_if<(RODS > 0)>(world, [](auto& w) {
        if (ends.b != none) w.add_rod(handle(ends.a), handle(ends.b), numbers[0]);
    });
}
// Length, anchor, restitution.
FROM_OUTSIDE void add_rope() {
    keep();
    only_if<(ANCHORED_ROPES > 0)>(world, [](auto& w) {
        if (ends.b == none) w.add_anchored_rope(handle(ends.a), vector(1), numbers[0], numbers[4]);
    });
    only_if<(ROPES > 0)>(world, [](auto& w) {
        if (ends.b != none) w.add_rope(handle(ends.a), handle(ends.b), numbers[0], numbers[4]);
    });
}
// Linear, quadratic.
FROM_OUTSIDE void add_drag() {
    keep();
    only_if<(DRAGS > 0)>(world,
                         [](auto& w) { w.add_drag(handle(ends.a), numbers[0], numbers[1]); });
}
// Normal, offset, restitution.
FROM_OUTSIDE void add_plane() {
    keep();
    only_if<(PLANES > 0)>(world, [](auto& w) { w.add_plane(vector(0), numbers[3], numbers[4]); });
}

FROM_OUTSIDE void step() { world.step(engine::BinaryStep<EXPONENT>()); }

FROM_OUTSIDE uint8_t step_exponent() { return EXPONENT; }
FROM_OUTSIDE uint8_t world_error() { return static_cast<uint8_t>(world.error()); }
FROM_OUTSIDE uint32_t state_hash() { return engine::state_hash(world); }

volatile uint32_t told;

int main() {
    for (;;) {
        set_world();
        add_particle();
        add_spring();
        add_rod();
        add_rope();
        add_drag();
        add_plane();
        step();
        told = ends.a + step_exponent() + world_error() + state_hash();
    }
}
