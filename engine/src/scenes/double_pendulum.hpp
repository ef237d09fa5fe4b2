// SPDX-License-Identifier: MIT
// A double pendulum: two points of 1 kg on rods of 1 m, released at rest 37 and 53 degrees from the
// vertical. Truth: the equations of the two angles, integrated. Conserved: the energy.
#pragma once

#include <scenes/methods.hpp>

namespace scenes {

struct DoublePendulum {
    static constexpr const char* name = "double_pendulum";
    static constexpr unsigned duration = 3;  // s

    template <class Method>
    struct Uses : UsesWith<Method> {
        static constexpr unsigned particles = 2, anchored_rods = 1, rods = 1;
        static constexpr bool gravity = true;
    };

    template <class Scalar>
    struct Parameters {
        Scalar gravity = engine::Decimal<981, 2>();  // m/s^2
        Scalar x = engine::Decimal<6, 1>();          // m, of the upper point at the start
        Scalar y = engine::Decimal<-8, 1>();         // m
        Scalar lower_x = engine::Decimal<14, 1>();   // m, of the lower point
        Scalar lower_y = engine::Decimal<-14, 1>();  // m
        Scalar length = engine::Decimal<1, 0>();     // m, of each rod
    };

    template <class World>
    static void build(World& world, const Parameters<typename World::Scalar>& with) {
        using namespace engine::literals;
        world.gravity = {0_d, -with.gravity};
        typename World::Body point;
        point.inverse_mass = 1_d;
        point.position = {with.x, with.y};
        const auto upper = world.add_particle(point);
        point.position = {with.lower_x, with.lower_y};
        const auto lower = world.add_particle(point);
        world.add_anchored_rod(upper, {0_d, 0_d}, with.length);
        world.add_rod(lower, upper, with.length);
    }
};

}  // namespace scenes
