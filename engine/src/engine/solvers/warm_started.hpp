// SPDX-License-Identifier: MIT
/// \file
/// WarmStartedGaussSeidel<max_iterations>: ProjectedGaussSeidel that starts each step from the
/// changes its rows made in the previous one. In a tall stack or a heavy chain at rest these are
/// the same in every step, so the iterations of many steps add up where those of one do not
/// suffice. (E. Catto, Iterative Dynamics with Temporal Coherence, 2005.)
///
/// A row accumulates the change that it makes to its velocity over all iterations. A row that only
/// pushes may take back what it pushed, and no more. A row continues one of the previous step if it
/// has the same place in the order and the same ends. A bounce starts from zero. An overlap of a
/// few ulp is left, so that a contact at rest is found in every step and not in every other.
///
/// A bounce uses the velocities before the step's first iteration: in a row of touching balls it is
/// not passed on within the step, as it is in ProjectedGaussSeidel. Each row takes another scalar
/// and two indices of RAM.
#pragma once

#include <engine/distance.hpp>
#include <engine/solvers/projected_gauss_seidel.hpp>

namespace engine {

/// The solver of tall stacks and heavy chains: at most max_iterations iterations in a step, which
/// start where the previous step ended.
template <unsigned char max_iterations>
struct WarmStartedGaussSeidel : ProjectedGaussSeidel<max_iterations> {
    /// \cond internal
    using Cold = ProjectedGaussSeidel<max_iterations>;

    template <class World>
    struct Row : Cold::template Row<World> {
        typename World::Scalar change = {};          // of its velocity, over all iterations
        typename World::Index of_a = {}, of_b = {};  // the ends that `change` belongs to
    };

    template <class World, class Index, class Vector, class Scalar, class TimeStep>
    static void contact(World& world, Index a, Index b, const Vector& normal, Scalar penetration,
                        Scalar restitution, TimeStep dt) {
        const Scalar stays = RestingGap<Scalar>::value();
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

    // Before anything is applied in the step: the velocity that the row requires, and the change
    // that it starts from.
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
