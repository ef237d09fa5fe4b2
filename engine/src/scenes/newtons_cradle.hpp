// SPDX-License-Identifier: MIT
// Newton's cradle: five balls that hang side by side and just touch, on rods of 1 m. The first is
// released 37 degrees from the vertical. Truth: the first and the last swing in turn, half a
// pendulum's period each, in closed form by elliptic functions. Conserved: the energy.
#pragma once

#include <scenes/methods.hpp>

namespace scenes {

struct NewtonsCradle {
    static constexpr const char* name = "newtons_cradle";
    static constexpr unsigned duration = 4;  // s
    static constexpr unsigned balls = 5;

    template <class Method>
    struct Uses : UsesWith<Method> {
        static constexpr unsigned particles = balls, anchored_rods = balls, contacts = balls - 1;
        static constexpr bool gravity = true, radii = true, collisions = true;
    };

    template <class Scalar>
    struct Parameters {
        Scalar gravity = engine::Decimal<981, 2>();  // m/s^2
        Scalar x = engine::Decimal<-6, 1>();         // m, of the first ball, from its rest position
        Scalar y = engine::Decimal<-8, 1>();         // m
        Scalar length = engine::Decimal<1, 0>();     // m, of each rod
        Scalar radius = engine::Decimal<125, 3>();   // m
        Scalar restitution = engine::Decimal<1, 0>();
    };

    template <class World>
    static void build(World& world, const Parameters<typename World::Scalar>& with) {
        using namespace engine::literals;
        world.gravity = {0_d, -with.gravity};
        world.set_restitution(with.restitution);
        typename World::Body ball;
        ball.position = {with.x, with.y};
        ball.inverse_mass = 1_d;
        ball.radius = with.radius;
        typename World::Vector anchor;
        for (unsigned char i = 0; i < balls; ++i) {
            world.add_anchored_rod(world.add_particle(ball), anchor, with.length);
            anchor[0] += with.radius + with.radius;
            ball.position = {anchor[0], -with.length};
        }
    }
};

}  // namespace scenes
