// SPDX-License-Identifier: GPL-3.0-or-later
// A scene whose features come from the command line: -DGRAVITY=1 -DSPRINGS=0 ... -DDIMENSIONS=2
// -DINTEGRATOR=SemiImplicitEuler -DINTEGRATION=RoundedIntegration -DSOLVER=ProjectedGaussSeidel<10>
// -DCONTACTS=DiscreteContacts -DBROAD_PHASE=BruteForce -DARITHMETIC=Nearest. Every feature that is
// in acts in every step. The first particle is the lever's end; features that need two particles
// have another next to it.
#include <engine.h>

#include <fixedpoint/arithmetic/small.hpp>

using namespace engine;
using namespace engine::literals;
using Q16_16 = fixedpoint::Fixed<16, 16, fixedpoint::ARITHMETIC>;

constexpr bool DiscreteContacts = false, ContinuousContacts = true;
constexpr bool RoundedIntegration = false, CompensatedIntegration = true;
constexpr bool two = SPRINGS || RODS || ROPES || COLLISIONS;

template <class World>
struct Push {
    typename World::Vector force;  // N
    void apply(World& world) const { world.step_particles()[0].force += force; }
};

struct Scene : Uses {
    static constexpr unsigned char dimensions = DIMENSIONS;
    static constexpr unsigned particles = two ? 2 : 1, springs = SPRINGS,
                              anchored_springs = ANCHORED_SPRINGS, drags = DRAG, rods = RODS,
                              anchored_rods = ANCHORED_RODS, ropes = ROPES,
                              anchored_ropes = ANCHORED_ROPES, planes = PLANES,
                              contacts = 2 * PLANES + COLLISIONS;
    static constexpr bool gravity = GRAVITY, damping = DAMPING, collisions = COLLISIONS,
                          radii = COLLISIONS || PLANES, custom_force = CUSTOM_FORCE,
                          continuous_contacts = CONTACTS, compensated_integration = INTEGRATION;
#if CUSTOM_FORCE
    template <class World>
    using CustomForce = Push<World>;
#endif
    using Integrator = INTEGRATOR;
    using Solver = SOLVER;
    using BroadPhase = BROAD_PHASE;
};

using SceneWorld = World<Q16_16, Scene>;
SceneWorld world;

SceneWorld::Vector point(Q16_16 x, Q16_16 y) {
    SceneWorld::Vector v;
    v[0] = x;
    v[1] = y;
    return v;
}

extern "C" {

__attribute__((noinline)) unsigned char build() {
    SceneWorld::Body body;
    body.position = point(0.14_d, 0.08_d);
    body.inverse_mass = 10_d;
    body.radius = 0.01_d;
    const auto first = world.add_particle(body);
    const auto pivot = point(0.38_d, 0.15_d);
    only_if<GRAVITY>(world, [](auto& w) { w.gravity = point(0_d, -9.81_d); });
    only_if<CUSTOM_FORCE>(world, [](auto& w) { w.custom_force().force = point(0.3_d, 0.5_d); });
    only_if<ANCHORED_RODS>(world, [&](auto& w) { w.add_anchored_rod(first, pivot, 0.25_d); });
    only_if<ANCHORED_SPRINGS>(world, [&](auto& w) {
        w.add_anchored_spring(first, point(0.1_d, 0.4_d), 5_d, 0.1_d, 0.2_d);
    });
    only_if<ANCHORED_ROPES>(world,
                            [&](auto& w) { w.add_anchored_rope(first, pivot, 0.25_d, 0_d); });
    only_if<DRAG>(world, [&](auto& w) { w.add_drag(first, 0.1_d, 0.1_d); });
    only_if<PLANES>(world, [](auto& w) { w.add_plane(point(0_d, 1_d), 0.05_d, 0.5_d); });
    only_if<two>(world, [&](auto& w) {
        body.position = point(0.15_d, 0.08_d);
        const auto second = w.add_particle(body);
        only_if<RODS>(w, [&](auto& x) { x.add_rod(first, second, 0.015_d); });
        only_if<SPRINGS>(w, [&](auto& x) { x.add_spring(first, second, 5_d, 0.1_d, 0.05_d); });
        only_if<ROPES>(w, [&](auto& x) { x.add_rope(first, second, 0.015_d, 0_d); });
    });
    return static_cast<unsigned char>(world.error());
}

__attribute__((noinline)) void step() { world.step(BinaryStep<10>()); }

#if STOWAWAY
// No scene uses this: it is linked so that the test of what is linked has something to find.
volatile float metres = 1;
__attribute__((noinline)) void stowaway() {
    metres = metres * 3;
    world.particles()[0].position[0] = sqrt(world.particles()[0].position[0]);
}
#endif
}

int main() {
    build();
#if STOWAWAY
    stowaway();
#endif
    for (;;) step();
}
