// SPDX-License-Identifier: GPL-3.0-or-later
// A broad phase that counts the pairs that it tests. The engine's own broad phase runs on a world
// that forwards its calls and counts.
#pragma once

#include <engine/broad_phase/cached_sort_and_sweep.hpp>
#include <engine/constraints.hpp>

namespace growth {

template <class World>
struct Watched {
    using Index = typename World::Index;
    using Scalar = typename World::Scalar;
    World& world;
    auto& step_particles() { return world.step_particles(); }
    auto& pair_memory() { return world.pair_memory().of_search; }
};

template <class World, class Index, class TimeStep>
void collide(Index a, Index b, Watched<World>& watched, TimeStep dt) {
    ++watched.world.pair_memory().pairs;
    engine::collide(a, b, watched.world, dt);
}

// A pair that a search rejects by its copies counts as tested, too.
template <class Ordered, class World>
bool are_apart(const Ordered& a, const Ordered& b, Watched<World>& watched) {
    const bool apart = engine::are_apart(a, b, watched.world);
    if (apart) ++watched.world.pair_memory().pairs;
    return apart;
}

template <class Search>
struct Counted {
    template <class World>
    struct Memory {
        typename Search::template Memory<World> of_search;
        unsigned long pairs = 0;  // tested so far
    };
    template <class World, class TimeStep>
    static void collide_all(World& world, TimeStep dt) {
        Watched<World> watched{world};
        Search::collide_all(watched, dt);
    }
};

}  // namespace growth
