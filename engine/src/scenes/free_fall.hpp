// SPDX-License-Identifier: MIT
// Free fall: a point thrown upwards and to the side. Truth: the parabola, in closed form.
// Conserved: the energy, and the momentum along the ground.
#pragma once

#include <scenes/methods.hpp>

namespace scenes {

struct FreeFall {
    static constexpr const char* name = "free_fall";
    static constexpr unsigned duration = 2;  // s

    template <class Method>
    struct Uses : UsesWith<Method> {
        static constexpr unsigned particles = 1;
        static constexpr bool gravity = true;
    };

    template <class Scalar>
    struct Parameters {
        Scalar gravity = engine::Decimal<981, 2>();   // m/s^2
        Scalar height = engine::Decimal<20, 0>();     // m, at the start
        Scalar velocity_x = engine::Decimal<3, 0>();  // m/s, at the start
        Scalar velocity_y = engine::Decimal<4, 0>();  // m/s
    };

    template <class World>
    static void build(World& world, const Parameters<typename World::Scalar>& with) {
        using namespace engine::literals;
        world.gravity = {0_d, -with.gravity};
        typename World::Body point;
        point.position = {0_d, with.height};
        point.velocity = {with.velocity_x, with.velocity_y};
        point.inverse_mass = 1_d;
        world.add_particle(point);
    }
};

}  // namespace scenes
