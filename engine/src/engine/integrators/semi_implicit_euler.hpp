// SPDX-License-Identifier: MIT
/// \file
/// SemiImplicitEuler: integrates velocities, then positions by the new velocities. First order and
/// symplectic: the energy of an oscillation stays bounded up to omega h = 2.
#pragma once

namespace engine {

/// First order, conserves the energy of oscillations on average: the default.
struct SemiImplicitEuler {
    /// Whether the integrator applies springs itself instead of accumulating their forces.
    static constexpr bool implicit_springs = false;
    /// \cond internal
    template <class World>
    struct Memory {
        FIXEDPOINT_CONSTEXPR void restart() const {}
    };
    /// \endcond

    /// Advances the world by dt. Called by World::step, which checks dt.
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
