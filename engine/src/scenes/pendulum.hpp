// SPDX-License-Identifier: MIT
// A pendulum: a point of 1 kg on a rod of 1 m, released at rest with the rod 37 degrees from the
// vertical. Truth: the equation of the angle, which has a closed form by elliptic functions.
// Conserved: the energy.
#pragma once

#include <scenes/methods.hpp>

namespace scenes {

struct Pendulum {
    static constexpr const char* name = "pendulum";
    static constexpr unsigned duration = 4;  // s

    template <class Method>
    struct Uses : UsesWith<Method> {
        static constexpr unsigned particles = 1, anchored_rods = 1;
        static constexpr bool gravity = true;
    };

    template <class Scalar>
    struct Parameters {
        Scalar gravity = engine::Decimal<981, 2>();  // m/s^2
        Scalar x = engine::Decimal<6, 1>();          // m, of the bob at the start
        Scalar y = engine::Decimal<-8, 1>();         // m
        Scalar length = engine::Decimal<1, 0>();     // m
    };

    template <class World>
    static void build(World& world, const Parameters<typename World::Scalar>& with) {
        using namespace engine::literals;
        world.gravity = {0_d, -with.gravity};
        typename World::Body bob;
        bob.position = {with.x, with.y};
        bob.inverse_mass = 1_d;
        world.add_anchored_rod(world.add_particle(bob), {0_d, 0_d}, with.length);
    }
};

}  // namespace scenes
