// SPDX-License-Identifier: GPL-3.0-or-later
// The box of N particles with a pair search of one's choice, for the chip and the host alike.
#pragma once

#include <scenes/box_of_particles.hpp>

namespace growth {

template <unsigned N, class Search>
struct Uses : scenes::BoxOf<N>::template Uses<scenes::SemiImplicit> {
    // So few touch at once that the particles, and not their contacts, fill the chip's memory.
    static constexpr unsigned contacts = N / 4 + 6;
    using PairSearch = Search;
};

template <unsigned N, class Search>
using World = engine::World<fixedpoint::Q16_16, Uses<N, Search>>;

template <unsigned N, class Search>
void build(World<N, Search>& world) {
    typename scenes::BoxOf<N>::template Parameters<fixedpoint::Q16_16> numbers;
    scenes::BoxOf<N>::build(world, numbers);
}

}  // namespace growth
