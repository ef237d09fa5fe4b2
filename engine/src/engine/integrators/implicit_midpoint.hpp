// SPDX-License-Identifier: MIT
/// \file
/// ImplicitMidpoint: the implicit midpoint rule for springs. Half a step of the other forces and of
/// the motion; then the springs, with the forces that they have in the middle of the step; then the
/// other halves. Second order, also for damped springs, and stable for every stiffness: it keeps
/// the energy of undamped oscillations, and what the step cannot resolve goes on swinging in place
/// of being damped out. Chains of springs are solved together, as by DirectSprings, whose
/// requirements are those of this integrator, too. (E. Hairer, C. Lubich, G. Wanner, Geometric
/// Numerical Integration, 2006, chapters II and VI.)
///
/// Let e be the extension after half a step by the velocity u. The change x of the velocity along a
/// spring adds h x / 4 to the extension and x / 2 to the velocity in the middle of the step:
///   x = -h i (k (e + h x / 4) + c (u + x / 2)).
#pragma once

#include <engine/integrators/direct_springs.hpp>

namespace engine {

/// \cond internal
// The response of a spring whose force is that in the middle of the step. In the equation that
// SpringSolver solves, x = p - g (u + ...), the velocity u enters by g, and not by h i c / d: p
// contains the difference.
struct InTheMiddle {
    template <class Spring, class World, class Row, class Scalar, class TimeStep>
    static ENGINE_INLINE void respond(const Spring& spring, const World& world, Row& row,
                                      Scalar mobility, Scalar slack, TimeStep dt) {
        const Scalar s = saturating_product(mobility, spring.stiffness * dt);
        const Scalar one = Decimal<1, 0>();
        const Scalar velocity = velocity_along(world, row.a, row.b, row.normal);
        Scalar d = saturating_sum(one, s * half(half(dt)));
        if (spring.damping == Scalar()) {
            const Scalar rate = s / d;
            row.gain = rate * half(half(dt));
            row.change = engine::multiply_add(row.gain, velocity, rate * slack);
            return;
        }
        const Scalar friction = saturating_product(mobility, spring.damping);
        d = saturating_sum(d, friction * half(dt));
        const Scalar rate = s / d;
        const Scalar by_stiffness = rate * half(half(dt)), by_damping = friction / d * half(dt);
        row.gain = by_stiffness + by_damping;
        row.change = engine::multiply_add(by_stiffness - by_damping, velocity, rate * slack);
    }
};
/// \endcond

/// Second order, stable for chains of springs of every stiffness, and keeps their energy.
struct ImplicitMidpoint : CoupledSprings<DirectSprings, InTheMiddle> {
    /// \cond internal
    template <class World>
    struct Memory : DirectSprings::Memory<World> {
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
        world.integrate_positions(half(dt));
        pull(world, dt);
        world.collect_constraints(dt);
        world.solve_constraints();
        world.integrate_positions(half(dt));
        world.accumulate_forces();
        world.integrate_velocities(half(dt));
        world.damp();
        memory.forces_are_current = true;
    }
};

}  // namespace engine
