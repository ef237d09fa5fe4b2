// SPDX-License-Identifier: MIT
// A bouncing ball: dropped on a floor, moving sideways; each bounce is 0.8 times as fast as the one
// before. Truth: parabolas between bounces, whose times are a geometric series, in closed form.
// Conserved: the momentum along the floor; the energy between bounces.
#pragma once

#include <scenes/methods.hpp>

namespace scenes {

struct BouncingBall {
    static constexpr const char* name = "bouncing_ball";
    static constexpr unsigned duration = 4;  // s

    template <class Method>
    struct Uses : UsesWith<Method> {
        static constexpr unsigned particles = 1, planes = 1, contacts = 1;
        static constexpr bool gravity = true, radii = true;
    };

    template <class Scalar>
    struct Parameters {
        Scalar gravity = engine::Decimal<981, 2>();   // m/s^2
        Scalar height = engine::Decimal<2, 0>();      // m, of the centre at the start
        Scalar velocity_x = engine::Decimal<5, 1>();  // m/s
        Scalar radius = engine::Decimal<125, 3>();    // m
        Scalar restitution = engine::Decimal<8, 1>();
        Scalar restitution_threshold = engine::Decimal<25, 2>();  // m/s; slower: no bounce
    };

    template <class World>
    static void build(World& world, const Parameters<typename World::Scalar>& with) {
        using namespace engine::literals;
        world.gravity = {0_d, -with.gravity};
        world.set_restitution_threshold(with.restitution_threshold);
        world.add_plane({0_d, 1_d}, 0_d, with.restitution);
        typename World::Body ball;
        ball.position = {0_d, with.height};
        ball.velocity = {with.velocity_x, 0_d};
        ball.inverse_mass = 1_d;
        ball.radius = with.radius;
        world.add_particle(ball);
    }
};

}  // namespace scenes
