// SPDX-License-Identifier: MIT
// A projectile of 1 kg at 20 m/s along a slope of 4/3, slowed by drag that is linear and quadratic
// in its speed. Truth: its equation of motion, integrated; without quadratic drag a closed form.
// The energy only falls, by the work of the drag.
#pragma once

#include <scenes/methods.hpp>

namespace scenes {

struct ProjectileWithDrag {
    static constexpr const char* name = "projectile_with_drag";
    static constexpr unsigned duration = 2;  // s

    template <class Method>
    struct Uses : UsesWith<Method> {
        static constexpr unsigned particles = 1, drags = 1;
        static constexpr bool gravity = true;
    };

    template <class Scalar>
    struct Parameters {
        Scalar gravity = engine::Decimal<981, 2>();    // m/s^2
        Scalar velocity_x = engine::Decimal<12, 0>();  // m/s, at the start, which is at 0
        Scalar velocity_y = engine::Decimal<16, 0>();  // m/s
        Scalar linear = engine::Decimal<125, 3>();     // N s/m
        Scalar quadratic = engine::Decimal<625, 4>();  // N s^2/m^2
    };

    template <class World>
    static void build(World& world, const Parameters<typename World::Scalar>& with) {
        using namespace engine::literals;
        world.gravity = {0_d, -with.gravity};
        typename World::Body projectile;
        projectile.velocity = {with.velocity_x, with.velocity_y};
        projectile.inverse_mass = 1_d;
        world.add_drag(world.add_particle(projectile), with.linear, with.quadratic);
    }
};

}  // namespace scenes
