// SPDX-License-Identifier: MIT
/// \file
/// ImplicitSprings: SemiImplicitEuler in which each spring pulls with the force that it will have
/// at the end of the step. Stable for every stiffness: oscillations of omega h < 1 are resolved,
/// faster ones are damped out. First order. Springs are solved one after the other. (D. Baraff, A.
/// Witkin, Large Steps in Cloth Simulation, 1998, for the implicit step; the closed form of a
/// single spring is its solution in one dimension.)
#pragma once

#include <engine/decimal.hpp>
#include <engine/observe.hpp>
#include <engine/shared_change.hpp>
#include <engine/time_step.hpp>

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

    // Let i be the sum of the inverse masses, x the extension, u the velocity along the spring, k
    // the stiffness and c the damping. The velocity along the spring at the end of the step solves
    //   u' = u - h i (k (x + h u') + c u'),  so  u' = u / d - (s / d) x
    // with s = i h k and d = 1 + h i (h k + c). s / d is at most 1 / h, so that only s itself and i
    // (h k + c) can leave a format, where very stiff springs pull very light masses. Both saturate
    // alike, which makes such a spring softer but no less stable. h k is formed before it is
    // multiplied by i, since h i vanishes for heavy masses.
    template <class Spring, class World, class TimeStep>
    static void pull(const Spring& spring, World& world, TimeStep dt) {
        using namespace literals;
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
        const Scalar mobility = inverse_mass_sum(world, a, b);
        const Scalar push = spring.stiffness * dt;
        const Scalar s = saturating_product(mobility, push);
        const Scalar slowing =
            spring.damping == Scalar()
                ? s
                : saturating_product(mobility, saturating_sum(push, spring.damping));
        const Scalar one = 1_d;
        const Scalar d = saturating_sum(one, slowing * dt);
        const Scalar pulled =
            engine::multiply_add(s / d, spring.rest_length - distance, velocity / d);
        apply_shared(world, a, b, direction, pulled - velocity, mass_share(world, a, b),
                     &World::Particle::velocity);
    }

    template <class World, class Index>
    static typename World::Scalar inverse_mass_sum(const World& world, Index a, Index b) {
        auto sum = world.particles()[a].inverse_mass;
        if (is_particle(world, b)) sum = saturating_sum(sum, world.particles()[b].inverse_mass);
        return sum;
    }
};

}  // namespace engine
