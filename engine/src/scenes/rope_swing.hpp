// SPDX-License-Identifier: MIT
// A rope swing: a point falls freely next to the rope's fixed end until the rope of 2 m is taut, at
// (1.2, -1.6) m. There it loses its velocity along the rope, and swings. Truth: the parabola until
// the rope is taut (an event), then the equation of the angle. The swing stays below the fixed end,
// so that the rope stays taut. Conserved: the energy before and after the event.
#pragma once

#include <scenes/methods.hpp>

namespace scenes {

struct RopeSwing {
    static constexpr const char* name = "rope_swing";
    static constexpr unsigned duration = 3;  // s

    template <class Method>
    struct Uses : UsesWith<Method> {
        static constexpr unsigned particles = 1, anchored_ropes = 1;
        static constexpr bool gravity = true;
    };

    template <class Scalar>
    struct Parameters {
        Scalar gravity = engine::Decimal<981, 2>();  // m/s^2
        Scalar x = engine::Decimal<12, 1>();         // m, at the start; the fixed end is 0
        Scalar y = engine::Decimal<0, 0>();          // m
        Scalar length = engine::Decimal<2, 0>();     // m
    };

    template <class World>
    static void build(World& world, const Parameters<typename World::Scalar>& with) {
        using namespace engine::literals;
        world.gravity = {0_d, -with.gravity};
        typename World::Body point;
        point.position = {with.x, with.y};
        point.inverse_mass = 1_d;
        world.add_anchored_rope(world.add_particle(point), {0_d, 0_d}, with.length, 0_d);
    }
};

}  // namespace scenes
