// SPDX-License-Identifier: MIT
// SemiImplicitEuler: integrates velocities, then positions by the new velocities. First order and
// symplectic: the energy of an oscillation stays bounded up to omega h = 2.
#pragma once

namespace engine {

struct SemiImplicitEuler {
    static constexpr bool implicit_springs = false;
    template <class World>
    struct Memory {
        FIXEDPOINT_CONSTEXPR void restart() const {}
    };

    template <class World, class TimeStep>
    static void step(World& world, TimeStep dt) {
        world.accumulate_forces();
        world.integrate_velocities(dt);
        world.damp();
        world.collect_constraints(dt);
        world.solve_constraints();
        world.integrate_positions(dt);
    }
};

}  // namespace engine
