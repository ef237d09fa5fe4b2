// SPDX-License-Identifier: MIT
/// \file
/// ExplicitEuler: the step of the published design, kept as the baseline: forces, constraints,
/// positions by the old velocities, velocities, damping. First order. Each step multiplies the
/// energy of an oscillation by 1 + (omega h)^2.
#pragma once

namespace engine {

/// First order, unstable without damping: the integrator of the published design.
struct ExplicitEuler {
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
        world.collect_constraints(dt);
        world.solve_constraints();
        world.integrate_positions(dt);
        world.integrate_velocities(dt);
        world.damp();
    }
};

}  // namespace engine
