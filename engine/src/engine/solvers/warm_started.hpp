// SPDX-License-Identifier: MIT
/// \file
/// WarmStartedGaussSeidel<max_iterations>: ProjectedGaussSeidel that begins each step with what its
/// rows did in the last one. In a tall stack or a heavy chain at rest they do the same in every
/// step, so that iterations of many steps add up where those of one do not suffice. (E. Catto,
/// Iterative Dynamics with Temporal Coherence, 2005.)
///
/// A row keeps the change that it made to its velocity over all iterations. One that only pushes
/// may take back what it pushed, and no more. A row counts as the last step's where it is the same
/// in the order and of the same ends. A bounce begins anew. So that a contact at rest is found in
/// every step, and not in every other, an overlap of some ulp stays.
///
/// A bounce is by the velocities before the step's first iteration: in a row of touching balls it
/// is not passed on within the step, as ProjectedGaussSeidel does. Takes a scalar and two indices
/// of RAM a row.
#pragma once

#include <engine/solvers/projected_gauss_seidel.hpp>

namespace engine {

/// \cond internal
// The overlap that stays, m: more than rounding moves a particle at rest.
template <class Scalar>
struct RestingOverlap {
    static constexpr Scalar value() { return Decimal<1, 5>(); }
};
template <int I, int F, class A>
struct RestingOverlap<Fixed<I, F, A>> {
    static constexpr Fixed<I, F, A> value() { return Fixed<I, F, A>::from_raw(F >= 12 ? 8 : 1); }
};
/// \endcond

/// The solver of tall stacks and heavy chains: at most max_iterations iterations in a step, which
/// begin where the last step ended.
template <unsigned char max_iterations>
struct WarmStartedGaussSeidel : ProjectedGaussSeidel<max_iterations> {
    /// \cond internal
    using Cold = ProjectedGaussSeidel<max_iterations>;

    template <class World>
    struct Row : Cold::template Row<World> {
        typename World::Scalar change = {};          // of its velocity, over all iterations
        typename World::Index of_a = {}, of_b = {};  // the ends that `change` is of
    };

    template <class World, class Index, class Vector, class Scalar, class TimeStep>
    static void contact(World& world, Index a, Index b, const Vector& normal, Scalar penetration,
                        Scalar restitution, TimeStep dt) {
        const Scalar stays = RestingOverlap<Scalar>::value();
        Cold::contact(world, a, b, normal, penetration > stays ? penetration - stays : Scalar(),
                      restitution, dt);
    }

    template <class World>
    static void solve(World& world) {
        for (auto& row : world.step_rows()) begin(world, row);
        for (const auto& row : world.rows()) apply(world, row, row.change);
        for (unsigned char i = 0; i < max_iterations; ++i) {
            bool changed = false;
            for (auto& row : world.step_rows()) {
                if (solve_row(world, row)) changed = true;
            }
            if (!changed || world.rows().size() == 1) break;
        }
    }
    /// \endcond

  private:
    template <class World, class Row>
    static typename World::Scalar velocity_of(const World& world, const Row& row) {
        return velocity_along(world, row.a, row.b, row.normal);
    }
    template <class World, class Row, class Scalar>
    static bool apply(World& world, const Row& row, Scalar change) {
        return apply_shared(world, row.a, row.b, row.normal, change, row.share(),
                            &World::Particle::velocity);
    }

    // Before anything of the step is applied: the velocity that the row asks for, and what it
    // begins with.
    template <class World, class Row>
    static void begin(const World& world, Row& row) {
        using Scalar = typename World::Scalar;
        using Index = typename World::Index;
        const Scalar velocity = velocity_of(world, row);
        if (!row.acts(world, velocity, row.target) && row.target < Scalar()) row.target = Scalar();
        const bool bounces = row.bounces(world, velocity);
        if (bounces || row.a != row.of_a || row.b != row.of_b) row.change = Scalar();
        row.of_a = bounces ? nothing<Index>() : row.a;
        row.of_b = row.b;
    }

    template <class World, class Row>
    static bool solve_row(World& world, Row& row) {
        using Scalar = typename World::Scalar;
        const Scalar before = row.change;
        row.change += row.target - velocity_of(world, row);
        if (row.only_pushes() && row.change < Scalar()) row.change = Scalar();
        if (row.change == before) return false;
        if (apply(world, row, row.change - before)) return true;
        row.change = before;
        return false;
    }
};

}  // namespace engine
