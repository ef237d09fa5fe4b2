// SPDX-License-Identifier: MIT
// The virtual side of the haptic lever: 0.1 kg at the end of an arm of 0.25 m that turns about a
// fixed pivot, under gravity and a constant force of the user, released at rest. Truth: a pendulum
// under the sum of both forces, in closed form by elliptic functions. Conserved: the energy,
// including that of the user's force.
#pragma once

#include <scenes/methods.hpp>
#include <scenes/user_force.hpp>

namespace scenes {

struct Lever {
    static constexpr const char* name = "lever";
    static constexpr unsigned duration = 4;  // s

    template <class Method>
    struct Uses : UsesWith<Method> {
        static constexpr unsigned particles = 1, anchored_rods = 1;
        static constexpr bool gravity = true, custom_force = true;
        template <class World>
        using CustomForce = UserForce<World, 0>;
    };

    template <class Scalar>
    struct Parameters {
        Scalar gravity = engine::Decimal<981, 2>();      // m/s^2
        Scalar pivot_x = engine::Decimal<38, 2>();       // m
        Scalar pivot_y = engine::Decimal<15, 2>();       // m
        Scalar end_x = engine::Decimal<14, 2>();         // m, at the start
        Scalar end_y = engine::Decimal<8, 2>();          // m
        Scalar length = engine::Decimal<25, 2>();        // m, of the arm
        Scalar inverse_mass = engine::Decimal<10, 0>();  // 1/kg
        Scalar force_x = engine::Decimal<3, 1>();        // N, by the user
        Scalar force_y = engine::Decimal<5, 1>();        // N
    };

    template <class World>
    static void build(World& world, const Parameters<typename World::Scalar>& with) {
        using namespace engine::literals;
        world.gravity = {0_d, -with.gravity};
        typename World::Body end;
        end.position = {with.end_x, with.end_y};
        end.inverse_mass = with.inverse_mass;
        world.add_anchored_rod(world.add_particle(end), {with.pivot_x, with.pivot_y}, with.length);
        world.custom_force().force = {with.force_x, with.force_y};
    }
};

}  // namespace scenes
