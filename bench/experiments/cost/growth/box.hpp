// SPDX-License-Identifier: GPL-3.0-or-later
// The box of N particles with a selectable broad phase, for the chip and the host.
#pragma once

#include <scenes/box_of_particles.hpp>

namespace growth {

template <unsigned N, class Search>
struct Uses : scenes::BoxOf<N>::template Uses<scenes::SemiImplicit> {
    // On the chip, the particles and not their contacts fill the memory. Worlds that fit only on
    // the host get room for all contacts of a long run.
    static constexpr unsigned contacts = N < 64 ? N / 4 + 6 : 2 * N;
    using BroadPhase = Search;
};

template <unsigned N, class Search>
using World = engine::World<fixedpoint::Q16_16, Uses<N, Search>>;

template <unsigned N, class Search>
void build(World<N, Search>& world) {
    typename scenes::BoxOf<N>::template Parameters<fixedpoint::Q16_16> numbers;
    scenes::BoxOf<N>::build(world, numbers);
}

template <class World>
void step(World& world) {
    world.step(engine::BinaryStep<8>());
}

}  // namespace growth
