// SPDX-License-Identifier: MIT
// A chain of four points of 1 kg on rods of 0.5 m, released at rest as a straight line 37 degrees
// from the vertical. Truth: the equations of the four angles, integrated. Conserved: the energy.
#pragma once

#include <scenes/methods.hpp>

namespace scenes {

struct ChainOfRods {
    static constexpr const char* name = "chain_of_rods";
    static constexpr unsigned duration = 2;  // s
    static constexpr unsigned links = 4;

    template <class Method>
    struct Uses : UsesWith<Method> {
        static constexpr unsigned particles = links, anchored_rods = 1, rods = links - 1;
        static constexpr bool gravity = true;
    };

    template <class Scalar>
    struct Parameters {
        Scalar gravity = engine::Decimal<981, 2>();  // m/s^2
        Scalar x = engine::Decimal<3, 1>();          // m, from a point to the next at the start
        Scalar y = engine::Decimal<-4, 1>();         // m
        Scalar length = engine::Decimal<5, 1>();     // m, of each rod
    };

    template <class World>
    static void build(World& world, const Parameters<typename World::Scalar>& with) {
        using namespace engine::literals;
        world.gravity = {0_d, -with.gravity};
        typename World::Body point;
        point.inverse_mass = 1_d;
        const typename World::Vector link = {with.x, with.y};
        point.position = link;
        auto last = world.add_particle(point);
        world.add_anchored_rod(last, {0_d, 0_d}, with.length);
        for (unsigned char i = 1; i < links; ++i) {
            point.position += link;
            const auto next = world.add_particle(point);
            world.add_rod(next, last, with.length);
            last = next;
        }
    }
};

}  // namespace scenes
