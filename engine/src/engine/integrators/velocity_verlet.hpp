// SPDX-License-Identifier: MIT
/// \file
/// VelocityVerlet: integrates velocities over half a step by the old forces, then positions, then
/// velocities over the other half by the new forces. The next step reuses these, unless something
/// was changed in between: a step evaluates the forces once. Second order and symplectic, stable up
/// to omega h = 2. (L. Verlet, Computer experiments on classical fluids I, 1967.)
#pragma once

#include <engine/time_step.hpp>

namespace engine {

/// Second order, for smooth forces.
struct VelocityVerlet {
    /// Whether the integrator applies springs itself instead of accumulating their forces.
    static constexpr bool implicit_springs = false;
    /// \cond internal
    template <class World>
    struct Memory {
        bool forces_are_current = {};  // the forces belong to the present positions and velocities
        FIXEDPOINT_CONSTEXPR void restart() { forces_are_current = false; }
    };
    /// \endcond

    /// Advances the world by dt. Called by World::step, which checks dt.
    template <class World, class TimeStep>
    static void step(World& world, TimeStep dt) {
        auto& memory = world.integrator_memory();
        if (!memory.forces_are_current) world.accumulate_forces();
        world.integrate_velocities(half(dt));
        world.collect_constraints(dt);
        world.solve_constraints();
        world.integrate_positions(dt);
        world.accumulate_forces();
        world.integrate_velocities(half(dt));
        world.damp();
        memory.forces_are_current = true;
    }
};

}  // namespace engine
