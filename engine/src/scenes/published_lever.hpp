// SPDX-License-Identifier: MIT
// The lever as published, for comparison with its figures: three dimensions, the pivot a particle
// of infinite mass, spheres that could collide, damping (off), no force by the user. The published
// rod is too short at the start (0.15 m between points that are 0.32 m apart), and the first step
// pulls it to its length. Truth: the pendulum that starts there, in closed form by elliptic
// functions.
#pragma once

#include <scenes/methods.hpp>
#include <scenes/user_force.hpp>

namespace scenes {

struct PublishedLever {
    static constexpr const char* name = "published_lever";
    static constexpr unsigned duration = 4;  // s

    template <class Method>
    struct Uses : UsesWith<Method> {
        static constexpr unsigned char dimensions = 3;
        static constexpr unsigned particles = 2, rods = 1, contacts = 2;
        static constexpr bool gravity = true, custom_force = true, damping = true, radii = true,
                              collisions = true;
        template <class World>
        using CustomForce = UserForce<World, 1>;
    };

    template <class Scalar>
    struct Parameters {
        Scalar length = engine::Decimal<15, 2>();  // m, of the arm
        Scalar damping = engine::Decimal<1, 0>();
    };

    template <class World>
    static void build(World& world, const Parameters<typename World::Scalar>& with) {
        using namespace engine::literals;
        world.gravity = {0_d, -9.81_d, 0_d};
        world.set_restitution(0.5_d);
        typename World::Body pivot;
        pivot.position = {0.38_d, 0.15_d, 0_d};
        const auto fixed = world.add_particle(pivot);
        typename World::Body end;
        end.position = {0.1_d, 0_d, 0_d};
        end.inverse_mass = 10_d;
        end.radius = 0.01_d;
        end.damping = with.damping;
        world.add_rod(fixed, world.add_particle(end), with.length);
    }
};

}  // namespace scenes
