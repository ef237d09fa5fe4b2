// SPDX-License-Identifier: MIT
/// \file
/// ImplicitSprings: SemiImplicitEuler in which each spring pulls with the force that it will have
/// at the end of the step. Stable for every stiffness: oscillations of omega h < 1 are resolved,
/// faster ones are damped out. First order. Springs are solved one after the other. (D. Baraff, A.
/// Witkin, Large Steps in Cloth Simulation, 1998, for the implicit step; the closed form of a
/// single spring is its solution in one dimension.)
#pragma once

#include <engine/integrators/implicit_response.hpp>
#include <engine/observe.hpp>
#include <engine/shared_change.hpp>

namespace engine {

/// First order, stable for springs of every stiffness.
struct ImplicitSprings {
    /// Whether the integrator applies springs itself instead of accumulating their forces.
    static constexpr bool implicit_springs = true;
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
        const Pull<World, TimeStep> pull_it = {world, dt};
        world.anchored_springs().for_each(pull_it);
        world.springs().for_each(pull_it);
        world.damp();
        world.collect_constraints(dt);
        world.solve_constraints();
        world.integrate_positions(dt);
    }

  private:
    template <class World, class TimeStep>
    struct Pull {
        World& world;
        const TimeStep& dt;
        template <class Spring>
        void operator()(const Spring& spring) const {
            pull(spring, world, dt);
        }
    };

    template <class Spring, class World, class TimeStep>
    static void pull(const Spring& spring, World& world, TimeStep dt) {
        using Scalar = typename World::Scalar;
        observe<Scalar>(Quantity::spring_force);
        const auto a = spring.ends.a;
        const auto b = spring.ends.second();
        if (!either_moves(world, a, b)) return;
        const auto difference = spring.ends.difference(world);
        const Scalar distance = length(difference);
        if (distance == Scalar()) return;
        const auto direction = divided(difference, distance);
        const Scalar velocity = velocity_along(world, a, b, direction);
        const auto of = implicit_response(spring, inverse_mass_sum(world, a, b), dt);
        const Scalar pulled =
            engine::multiply_add(of.s / of.d, spring.rest_length - distance, velocity / of.d);
        apply_shared(world, a, b, direction, pulled - velocity, mass_share(world, a, b),
                     &World::Particle::velocity);
    }
};

}  // namespace engine
