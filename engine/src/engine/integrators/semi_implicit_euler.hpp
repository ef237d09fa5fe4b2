// SPDX-License-Identifier: MIT
/// \file
/// SemiImplicitEuler: integrates velocities, then positions by the new velocities. First order and
/// symplectic: the energy of an oscillation stays bounded up to omega h = 2.
#pragma once

namespace engine {

/// First order, keeps the energy of oscillations: the default.
struct SemiImplicitEuler {
    /// Whether it moves springs itself, instead of accumulating their forces.
    static constexpr bool implicit_springs = false;
    /// \cond internal
    template <class World>
    struct Memory {
        FIXEDPOINT_CONSTEXPR void restart() const {}
    };
    /// \endcond

    /// Moves the world on by dt. Called by World::step.
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
