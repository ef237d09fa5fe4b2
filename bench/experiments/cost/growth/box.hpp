// SPDX-License-Identifier: GPL-3.0-or-later
// The box of N particles with a broad phase of one's choice, for the chip and the host alike.
#pragma once

#include <scenes/box_of_particles.hpp>

namespace growth {

template <unsigned N, class Search>
struct Uses : scenes::BoxOf<N>::template Uses<scenes::SemiImplicit> {
    // On the chip few enough that the particles, and not their contacts, fill its memory; crowds
    // that only the host holds get room for all that may touch in a long run.
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
