// SPDX-License-Identifier: MIT
/// \file
/// DirectRods: the solver of scenes whose rods form chains, without contacts or ropes. It solves
/// the velocities of all rods together, in time linear in their number. ProjectedGaussSeidel needs
/// iterations in proportion to the length of a chain and to the ratio of its masses. Rows are
/// found, and positions corrected, as by ProjectedGaussSeidel.
///
/// Let x_i be the change that row i makes to its own velocity, and c_ij x_i the change that it
/// makes to that of row j (elimination.hpp). The x_i solve x_j + sum_i c_ij x_i = the change that
/// the velocity of row j needs. Each rod may share particles with one rod added before it, but not
/// with two. Anchored rods count as added before the others.
///
/// Where a light particle holds a mass R times its own, a pivot shrinks to 1 / (R + 1). Across two
/// rods of length L under such a tension the light particle oscillates with omega^2 = 4 R g / L at
/// most, and no step h with omega h above 2 is stable.
#pragma once

#include <engine/solvers/elimination.hpp>
#include <engine/solvers/projected_gauss_seidel.hpp>

namespace engine {

/// The solver of chains of rods.
struct DirectRods : ProjectedGaussSeidel<1> {
    /// \cond internal
    template <class World>
    struct Row : ProjectedGaussSeidel<1>::Row<World>,
                 EliminationRow<typename World::Scalar, static_cast<unsigned>(World::max_rows)> {
        static_assert(!World::bounces, "DirectRods solves rods: not ropes and not contacts.");
    };

    template <class World>
    static void solve(World& world) {
        auto& rows = world.step_rows();
        for (auto& row : rows) {
            // The length of a direction is not exactly 1, which matters where masses differ much.
            row.pivot = dot(row.normal, row.normal);
            row.change = row.target - velocity_along(world, row.a, row.b, row.normal);
            Elimination::couple(world, rows, row);
        }
        Elimination::solve(world, rows);
    }
    /// \endcond
};

}  // namespace engine
