// SPDX-License-Identifier: MIT
// ExplicitEuler: the published order of a step, the baseline: forces, contacts, then positions by
// the old velocities, velocities, damping. First order; the energy of an oscillation grows by the
// factor 1 + (omega h)^2 a step.
#pragma once

namespace engine {

struct ExplicitEuler {
    static constexpr bool implicit_springs = false;
    template <class World>
    struct Memory {
        constexpr void restart() const {}
    };

    template <class World, class TimeStep>
    static void step(World& world, TimeStep dt) {
        world.accumulate_forces();
        world.collect_constraints(dt);
        world.solve_constraints();
        world.integrate_positions(dt);
        world.integrate_velocities(dt);
        world.damp();
    }
};

}  // namespace engine
