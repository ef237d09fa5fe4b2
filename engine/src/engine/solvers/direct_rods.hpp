// SPDX-License-Identifier: MIT
/// \file
/// DirectRods: the solver of scenes whose rods form chains, without contacts or ropes. It solves
/// the velocities of all rods together, in time linear in their number. ProjectedGaussSeidel needs
/// iterations in proportion to the length of a chain and to the ratio of its masses. Rows are
/// found, and positions corrected, as by ProjectedGaussSeidel.
///
/// Let x_i be the change that row i makes to its own velocity, and s the particle that it shares
/// with row j. The particle s takes its share of x_i along the normal n_i, which changes the
/// velocity of row j by c_ij x_i with c_ij = +- share_i(s) n_i . n_j. The x_i solve x_j + sum_i
/// c_ij x_i = the change that the velocity of row j needs. Each rod may share particles with one
/// rod added before it, its parent, but not with two: then elimination from the last row to the
/// first creates no fill-in. (R. Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 6.)
/// Anchored rods count as added before the others.
///
/// All c_ij lie in -1..1, whatever the masses are. Where a light particle holds a mass R times its
/// own, a pivot shrinks to 1 / (R + 1). Across two rods of length L under such a tension the light
/// particle oscillates with omega^2 = 4 R g / L at most, and no step h with omega h above 2 is
/// stable.
#pragma once

#include <engine/pool.hpp>
#include <engine/solvers/projected_gauss_seidel.hpp>

namespace engine {

/// \cond internal
// The smallest pivot: below it, rounding would decide the result.
template <class Scalar>
struct LeastPivot {
    static constexpr Scalar value() { return Decimal<1, 6>(); }
};
template <int I, int F, class A>
struct LeastPivot<Fixed<I, F, A>> {
    static constexpr Fixed<I, F, A> value() { return Fixed<I, F, A>::from_raw(F >= 8 ? 8 : 1); }
};
/// \endcond

/// The solver of chains of rods.
struct DirectRods : ProjectedGaussSeidel<1> {
    /// \cond internal
    template <class World>
    struct Row : ProjectedGaussSeidel<1>::Row<World> {
        using Scalar = typename World::Scalar;
        using RowIndex = typename CountTo<static_cast<unsigned>(World::max_rows)>::Type;
        static_assert(!World::bounces, "DirectRods solves rods: not ropes and not contacts.");
        constexpr bool has_parent() const { return parent != nothing<RowIndex>(); }
        RowIndex parent = {};     // the earlier row that shares a particle, or nothing
        Scalar to_parent = {};    // the part of this row's change that enters the parent's velocity
        Scalar from_parent = {};  // the part of the parent's change that enters this row's velocity
        Scalar pivot = {};
        Scalar change = {};  // of the velocity along the rod; at first the change needed
    };

    template <class World>
    static void solve(World& world) {
        auto& rows = world.step_rows();
        for (auto& row : rows) {
            // The length of a direction is not exactly 1, which matters where masses differ much.
            row.pivot = dot(row.normal, row.normal);
            row.change = row.target - velocity_along(world, row.a, row.b, row.normal);
            couple(world, row);
        }
        eliminate(rows);
        for (auto& row : rows) {
            if (row.has_parent()) row.change -= row.from_parent * rows[row.parent].change;
            row.change /= row.pivot;
        }
        for (const auto& row : rows) {
            apply_shared(world, row.a, row.b, row.normal, row.change, row.share(),
                         &World::Particle::velocity);
        }
    }
    /// \endcond

  private:
    // The part of a row's change that the particle takes. It must be movable.
    template <class World, class Row, class Index>
    static typename World::Scalar part(const World& world, const Row& row, Index particle) {
        using Scalar = typename World::Scalar;
        const Scalar one = Decimal<1, 0>();
        const auto other = particle == row.a ? row.b : row.a;
        if (!is_particle(world, other) || !movable(world.particles()[other])) return one;
        return particle == row.a ? row.share() : one - row.share();
    }

    template <class World, class Row>
    static void couple(World& world, Row& row) {
        using Scalar = typename World::Scalar;
        using Index = typename World::Index;
        using RowIndex = typename Row::RowIndex;
        auto& rows = world.step_rows();
        row.parent = nothing<RowIndex>();
        for (RowIndex i = 0; &rows[i] != &row; ++i) {
            const Row& earlier = rows[i];
            const bool by_a = is_at(world, earlier, row.a);
            const bool by_b = is_particle(world, row.b) && is_at(world, earlier, row.b);
            if (!by_a && !by_b) continue;
            if (row.has_parent() || (by_a && by_b)) {
                world.report(Error::no_chain);
                continue;
            }
            const Index shared = by_a ? row.a : row.b;
            Scalar cosine = dot(row.normal, earlier.normal);
            if (by_a != (earlier.a == shared)) cosine = -cosine;
            row.parent = i;
            row.to_parent = part(world, row, shared) * cosine;
            row.from_parent = part(world, earlier, shared) * cosine;
        }
    }
    // Whether a row acts on the particle and the particle is movable.
    template <class World, class Row, class Index>
    static bool is_at(const World& world, const Row& row, Index particle) {
        return movable(world.particles()[particle]) &&
               (row.a == particle || (is_particle(world, row.b) && row.b == particle));
    }

    // From the last row to the first: subtracts each row from its parent's equation.
    template <class Rows>
    static void eliminate(Rows& rows) {
        for (auto i = rows.size(); i-- > 0;) {
            auto& row = rows[i];
            const auto least = LeastPivot<decltype(row.pivot)>::value();
            if (row.pivot < least) row.pivot = least;
            if (!row.has_parent()) continue;
            const auto factor = row.to_parent / row.pivot;
            auto& parent = rows[row.parent];
            parent.pivot -= factor * row.from_parent;
            parent.change -= factor * row.change;
        }
    }
};

}  // namespace engine
