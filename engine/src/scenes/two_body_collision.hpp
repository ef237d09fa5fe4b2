// SPDX-License-Identifier: MIT
// Two discs of 1 kg and 0.5 kg that meet off centre: at that moment the line between their centres
// has slope 3/4. Truth: straight lines before and after, in closed form. Conserved: the momentum;
// the energy before and after; of the energy along the line of centres, restitution^2 is left.
#pragma once

#include <scenes/methods.hpp>

namespace scenes {

struct TwoBodyCollision {
    static constexpr const char* name = "two_body_collision";
    static constexpr unsigned duration = 2;  // s

    template <class Method>
    struct Uses : UsesWith<Method> {
        static constexpr unsigned particles = 2, contacts = 1;
        static constexpr bool radii = true, collisions = true;
    };

    template <class Scalar>
    struct Parameters {
        Scalar velocity = engine::Decimal<2, 0>();  // m/s along x, of the first, which starts at 0
        Scalar other_x = engine::Decimal<2, 0>();   // m, of the second at the start
        Scalar other_y = engine::Decimal<3, 1>();   // m
        Scalar other_velocity = engine::Decimal<-1, 0>();  // m/s along x
        Scalar inverse_mass = engine::Decimal<1, 0>();     // 1/kg
        Scalar other_inverse_mass = engine::Decimal<2, 0>();
        Scalar radius = engine::Decimal<25, 2>();  // m, of each
        Scalar restitution = engine::Decimal<5, 1>();
    };

    template <class World>
    static void build(World& world, const Parameters<typename World::Scalar>& with) {
        using namespace engine::literals;
        world.set_restitution(with.restitution);
        typename World::Body disc;
        disc.radius = with.radius;
        disc.velocity = {with.velocity, 0_d};
        disc.inverse_mass = with.inverse_mass;
        world.add_particle(disc);
        disc.position = {with.other_x, with.other_y};
        disc.velocity = {with.other_velocity, 0_d};
        disc.inverse_mass = with.other_inverse_mass;
        world.add_particle(disc);
    }
};

}  // namespace scenes
