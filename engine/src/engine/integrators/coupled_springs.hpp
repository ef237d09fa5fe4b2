// SPDX-License-Identifier: MIT
/// \file
/// CoupledSprings: the implicit step of springs that share particles, which DirectSprings,
/// GaussSeidelSprings and ImplicitMidpoint solve.
///
/// Let x_j be the change that spring j makes to its own velocity, and c_ij x_i the change that
/// spring i makes to it. In the notation of implicit_response.hpp, with the velocity u and the
/// extension e from before any spring is applied,
///   x_j = -s_j e_j - q_j (u_j + x_j + sum_i c_ij x_i)  with  q = h i (h k + c).
/// Divided by d = 1 + q, all coefficients lie in -1..1:
///   x_j = p_j - g_j (u_j + sum_i c_ij x_i)  with  p = -(s / d) e  and  g = q / d.
#pragma once

#include <engine/choice.hpp>
#include <engine/integrators/implicit_response.hpp>
#include <engine/observe.hpp>
#include <engine/pool.hpp>
#include <engine/shared_change.hpp>
#include <engine/solvers/projected_gauss_seidel.hpp>

namespace engine {

/// \cond internal
// SpringSolver::Row<World> derives from SpringRow<World> and has a member `change`, which is p at
// first. SpringSolver::solve(world, rows) applies all changes.
template <class World>
struct SpringRow : Sharing<typename World::Scalar, World::has_pairs> {
    typename World::Index a = {}, b = {};  // b may be nothing
    typename World::Vector normal;         // from b to a
    typename World::Scalar gain = {};      // g
};

// The response of a spring whose force is that at the end of the step. `slack` is -e.
struct AtTheEnd {
    template <class Spring, class World, class Row, class Scalar, class TimeStep>
    static ENGINE_INLINE void respond(const Spring& spring, const World&, Row& row, Scalar mobility,
                                      Scalar slack, TimeStep dt) {
        const auto of = implicit_response(spring, mobility, dt);
        const Scalar rate = of.s / of.d;
        row.gain = (spring.damping == Scalar() ? rate : of.slowing / of.d) * dt;
        row.change = rate * slack;
    }
};
/// \endcond

/// What DirectSprings, GaussSeidelSprings and ImplicitMidpoint have in common. SpringSolver solves
/// the equations of all springs; Response gives the coefficients of each.
template <class SpringSolver, class Response = AtTheEnd>
struct CoupledSprings {
    /// Whether the integrator applies springs itself instead of accumulating their forces.
    static constexpr bool implicit_springs = true;
    /// \cond internal
    template <class World>
    struct Memory {
        Pool<typename SpringSolver::template Row<World>,
             World::Uses::springs + World::Uses::anchored_springs>
            rows;
        FIXEDPOINT_CONSTEXPR void restart() const {}
    };
    /// \endcond

    /// Advances the world by dt. Called by World::step, which checks dt.
    template <class World, class TimeStep>
    static void step(World& world, TimeStep dt) {
        world.accumulate_forces();
        world.integrate_velocities(dt);
        pull(world, dt);
        world.damp();
        world.collect_constraints(dt);
        world.solve_constraints();
        world.integrate_positions(dt);
    }

  protected:
    /// \cond internal
    template <class World, class TimeStep>
    static void pull(World& world, TimeStep dt) {
        pull(world, dt, If<World::has_springs>());
    }
    /// \endcond

  private:
    template <class World, class TimeStep>
    static void pull(World& world, TimeStep dt, If<true>) {
        auto& rows = world.integrator_memory().rows;
        rows.clear();
        const Collect<World, TimeStep> collect_it = {world, dt};
        world.anchored_springs().for_each(collect_it);
        world.springs().for_each(collect_it);
        SpringSolver::solve(world, rows);
    }
    template <class World, class TimeStep>
    static void pull(World&, TimeStep, If<false>) {}

    template <class World, class TimeStep>
    struct Collect {
        World& world;
        const TimeStep& dt;
        template <class Spring>
        void operator()(const Spring& spring) const {
            collect(spring, world, dt);
        }
    };

    // Appends the row of a spring. There is none if neither end can move, or where the ends
    // coincide, since there is no direction then.
    template <class Spring, class World, class TimeStep>
    static void collect(const Spring& spring, World& world, TimeStep dt) {
        using Scalar = typename World::Scalar;
        observe<Scalar>(Quantity::spring_force);
        const auto a = spring.ends.a;
        const auto b = spring.ends.second();
        if (!either_moves(world, a, b)) return;
        const auto difference = spring.ends.difference(world);
        const Scalar distance = length(difference);
        if (distance == Scalar()) return;
        auto& row = world.integrator_memory().rows.append();
        row.a = a;
        row.b = b;
        row.normal = divided(difference, distance);
        row.set_share(mass_share(world, a, b));
        Response::respond(spring, world, row, inverse_mass_sum(world, a, b),
                          spring.rest_length - distance, dt);
    }
};

}  // namespace engine
