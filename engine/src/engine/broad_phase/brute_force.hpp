// SPDX-License-Identifier: MIT
/// \file
/// BruteForce: tests every pair of particles, N (N - 1) / 2 tests a step, and takes no RAM.
#pragma once

#include <engine/constraints.hpp>

namespace engine {

/// The broad phase of few particles: tests every pair.
struct BruteForce {
    /// \cond internal
    template <class World>
    struct Memory {};

    template <class World, class TimeStep>
    static void collide_all(World& world, TimeStep dt) {
        using Index = typename World::Index;
        const Index count = world.step_particles().size();
        for (Index b = 1; b < count; ++b) {
            for (Index a = 0; a < b; ++a) collide(a, b, world, dt);
        }
    }
    /// \endcond
};

}  // namespace engine
