// SPDX-License-Identifier: MIT
/// \file
/// DirectSprings: the implicit step of ImplicitSprings for chains of springs, whose velocities it
/// solves together, in time linear in their number. ImplicitSprings solves them one after the
/// other: where springs are stiff, each undoes what the one before it has reached.
///
/// Each spring may share particles with one spring added before it, but not with two: then
/// elimination creates no fill-in (solvers/elimination.hpp). Anchored springs count as added before
/// the others. The directions are those at the start of the step: a light particle that swings
/// across two springs of length L under the tension R m g is stable up to omega h = 2, with omega^2
/// = 4 R g / L, as between rods.
#pragma once

#include <engine/integrators/coupled_springs.hpp>
#include <engine/solvers/elimination.hpp>

namespace engine {

/// First order, stable for chains of springs of every stiffness.
struct DirectSprings : CoupledSprings<DirectSprings> {
    /// \cond internal
    template <class World>
    struct Row : SpringRow<World>,
                 EliminationRow<typename World::Scalar,
                                World::Uses::springs + World::Uses::anchored_springs> {};

    template <class World, class Rows>
    static void solve(World& world, Rows& rows) {
        solve(world, rows, If<(World::Uses::springs + World::Uses::anchored_springs > 1)>());
    }
    /// \endcond

  private:
    template <class World, class Rows>
    static void solve(World& world, Rows& rows, If<true>) {
        for (auto& row : rows) {
            alone(world, row);
            row.pivot = Decimal<1, 0>();
            Elimination::couple(world, rows, row);
            if (!row.has_parent()) continue;
            row.to_parent *= rows[row.parent].gain;
            row.from_parent *= row.gain;
        }
        Elimination::solve(world, rows);
    }
    // A single spring takes neither elimination nor quotient.
    template <class World, class Rows>
    static void solve(World& world, Rows& rows, If<false>) {
        rows.for_each([&](Row<World>& row) {
            alone(world, row);
            apply_shared(world, row.a, row.b, row.normal, row.change, row.share(),
                         &World::Particle::velocity);
        });
    }
    // The change that the spring would make if there were no others.
    template <class World, class Row>
    static void alone(const World& world, Row& row) {
        row.change = engine::multiply_add(
            -row.gain, velocity_along(world, row.a, row.b, row.normal), row.change);
    }
};

}  // namespace engine
