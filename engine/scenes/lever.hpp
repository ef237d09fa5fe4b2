// SPDX-License-Identifier: MIT
// The haptic lever's virtual side: 0.1 kg at the end of an arm of 0.25 m that turns about a fixed
// pivot, under gravity and the user's force. Truth: the equation of the arm's angle.
#pragma once

#include <scenes/methods.hpp>

namespace scenes {

// The force that a user exerts on a particle, set from outside between steps.
template <class World, unsigned char particle>
struct UserForce {
    typename World::Vector force;  // N
    void apply(World& world) const { world.particles()[particle].force += force; }
};

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

// The same as published, for its figures: three dimensions, the pivot a particle of infinite mass,
// spheres that might collide, damping. The published rod is too short at the start (0.15 m between
// points that are 0.32 m apart), and is pulled to its length by the first steps.
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
        world.restitution = 0.5_d;
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
