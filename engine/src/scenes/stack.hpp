// SPDX-License-Identifier: MIT
// A stack: four balls above each other over a floor, each with a gap below it. They fall onto each
// other without bouncing and come to rest. Truth: each ball falls freely until the gaps below it
// are closed, and rests from then on, in closed form. At the end the centres are at radius (2 k +
// 1).
#pragma once

#include <scenes/methods.hpp>

namespace scenes {

struct Stack {
    static constexpr const char* name = "stack";
    static constexpr unsigned duration = 2;  // s
    static constexpr unsigned balls = 4;

    template <class Method>
    struct Uses : UsesWith<Method> {
        static constexpr unsigned particles = balls, planes = 1, contacts = balls;
        static constexpr bool gravity = true, radii = true, collisions = true;
    };

    template <class Scalar>
    struct Parameters {
        Scalar gravity = engine::Decimal<981, 2>();              // m/s^2
        Scalar radius = engine::Decimal<25, 2>();                // m
        Scalar gap = engine::Decimal<125, 3>();                  // m, below each at the start
        Scalar restitution_threshold = engine::Decimal<5, 1>();  // m/s
    };

    template <class World>
    static void build(World& world, const Parameters<typename World::Scalar>& with) {
        using namespace engine::literals;
        world.gravity = {0_d, -with.gravity};
        world.set_restitution(0_d);
        world.set_restitution_threshold(with.restitution_threshold);
        world.add_plane({0_d, 1_d}, 0_d, 0_d);
        typename World::Body ball;
        ball.inverse_mass = 1_d;
        ball.radius = with.radius;
        ball.position[1] = with.gap + with.radius;
        for (unsigned char i = 0; i < balls; ++i) {
            world.add_particle(ball);
            ball.position[1] += with.gap + with.radius + with.radius;
        }
    }
};

}  // namespace scenes
