// SPDX-License-Identifier: MIT
/// \file
/// GaussSeidelSprings<max_iterations>: the implicit step of ImplicitSprings for springs that share
/// particles, in at most `max_iterations` iterations over all springs, which end when one changes
/// nothing. One iteration is that of ImplicitSprings. A spring takes back the change that it made
/// before and solves anew, with what the others have changed meanwhile. Serves every net of
/// springs; the stiffer they are and the longer their chains, the more iterations it needs.
#pragma once

#include <engine/integrators/coupled_springs.hpp>

namespace engine {

/// First order, stable for nets of springs of every stiffness.
template <unsigned char max_iterations>
struct GaussSeidelSprings : CoupledSprings<GaussSeidelSprings<max_iterations>> {
    /// \cond internal
    template <class World>
    struct Row : SpringRow<World> {
        typename World::Scalar pull = {};    // p
        typename World::Scalar change = {};  // of the velocity along the spring, so far
    };

    template <class World, class Rows>
    static void solve(World& world, Rows& rows) {
        for (auto& row : rows) {
            row.pull = row.change;
            row.change = typename World::Scalar();
        }
        for (unsigned char i = 0; i < max_iterations; ++i) {
            bool changed = false;
            for (auto& row : rows) {
                if (solve_row(world, row)) changed = true;
            }
            if (!changed || rows.size() == 1) break;
        }
    }
    /// \endcond

  private:
    template <class World, class Row>
    static bool solve_row(World& world, Row& row) {
        using Scalar = typename World::Scalar;
        const Scalar before = row.change;
        const Scalar others = velocity_along(world, row.a, row.b, row.normal) - before;
        row.change = engine::multiply_add(-row.gain, others, row.pull);
        if (row.change == before) return false;
        if (apply_shared(world, row.a, row.b, row.normal, row.change - before, row.share(),
                         &World::Particle::velocity))
            return true;
        row.change = before;
        return false;
    }
};

}  // namespace engine
