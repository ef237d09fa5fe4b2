// SPDX-License-Identifier: MIT
// A spring and a mass: 1 kg on a spring of 25 N/m from a fixed point, stretched along a line of
// slope 4/3 and released; no gravity. Truth: the (damped) oscillation along that line, in closed
// form. Conserved: the energy if the damping is 0.
#pragma once

#include <scenes/methods.hpp>

namespace scenes {

struct SpringAndMass {
    static constexpr const char* name = "spring_and_mass";
    static constexpr unsigned duration = 4;  // s

    template <class Method>
    struct Uses : UsesWith<Method> {
        static constexpr unsigned particles = 1, anchored_springs = 1;
    };

    template <class Scalar>
    struct Parameters {
        Scalar x = engine::Decimal<9, 1>();             // m, at the start; the fixed point is 0
        Scalar y = engine::Decimal<12, 1>();            // m
        Scalar stiffness = engine::Decimal<25, 0>();    // N/m
        Scalar damping = engine::Decimal<0, 0>();       // N s/m
        Scalar rest_length = engine::Decimal<1, 0>();   // m
        Scalar inverse_mass = engine::Decimal<1, 0>();  // 1/kg
    };

    template <class World>
    static void build(World& world, const Parameters<typename World::Scalar>& with) {
        using namespace engine::literals;
        typename World::Body mass;
        mass.position = {with.x, with.y};
        mass.inverse_mass = with.inverse_mass;
        world.add_anchored_spring(world.add_particle(mass), {0_d, 0_d}, with.stiffness,
                                  with.damping, with.rest_length);
    }
};

}  // namespace scenes
