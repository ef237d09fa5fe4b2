// SPDX-License-Identifier: MIT
// Elimination without fill-in: what DirectRods and DirectSprings have in common.
//
// Row j asks for a change x_j of its own velocity. Let s be a particle that rows i and j share. It
// takes its share of x_i along the normal n_i, which changes the velocity of row j by c_ij x_i with
// c_ij = +- share_i(s) n_i . n_j. Each row may share particles with one row before it, its parent,
// but not with two: then elimination from the last row to the first creates no fill-in, and its
// time is linear in the number of rows. (R. Featherstone, Rigid Body Dynamics Algorithms, 2008,
// chapter 6.) All c_ij lie in -1..1, whatever the masses are.
#pragma once

#include <engine/pool.hpp>
#include <engine/shared_change.hpp>

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

// What a row needs besides its ends, normal and share.
template <class Scalar, unsigned rows>
struct EliminationRow {
    using RowIndex = typename CountTo<rows>::Type;
    constexpr bool has_parent() const { return parent != nothing<RowIndex>(); }
    RowIndex parent = {};     // the earlier row that shares a particle, or nothing
    Scalar to_parent = {};    // the part of this row's change that enters the parent's velocity
    Scalar from_parent = {};  // the part of the parent's change that enters this row's velocity
    Scalar pivot = {};
    Scalar change = {};  // of the velocity along the row; at first the change needed
};

struct Elimination {
    // Finds the row's parent among the rows before it. A second one sets error() to no_chain.
    template <class World, class Rows, class Row>
    static void couple(World& world, Rows& rows, Row& row) {
        using Scalar = typename World::Scalar;
        using Index = typename World::Index;
        using RowIndex = typename Row::RowIndex;
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

    // Gives each row the change that it makes to its own velocity, and applies it.
    template <class World, class Rows>
    static ENGINE_INLINE void solve(World& world, Rows& rows) {
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

    // Whether a row acts on the particle and the particle is movable.
    template <class World, class Row, class Index>
    static bool is_at(const World& world, const Row& row, Index particle) {
        return movable(world.particles()[particle]) &&
               (row.a == particle || (is_particle(world, row.b) && row.b == particle));
    }

    // From the last row to the first: subtracts each row from its parent's equation.
    template <class Rows>
    static ENGINE_INLINE void eliminate(Rows& rows) {
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
/// \endcond

}  // namespace engine
