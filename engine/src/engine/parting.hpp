// SPDX-License-Identifier: MIT
// How a change along a line is shared by the two at its ends: in proportion to inverse mass.
#pragma once

#include <engine/links.hpp>
#include <engine/particle.hpp>

namespace engine {

// i_a / (i_a + i_b) of the inverse masses, where both can move; else 0, which part() does not read.
template <class World, class Index>
typename World::Scalar share_of(const World& world, Index a, Index b) {
    using Scalar = typename World::Scalar;
    if (!is_particle(world, b)) return Scalar();
    const Scalar of_a = world.particles()[a].inverse_mass;
    const Scalar of_b = world.particles()[b].inverse_mass;
    if (of_a == Scalar() || of_b == Scalar()) return Scalar();
    const Scalar sum = clamped_sum(of_a, of_b);
    if (sum - of_a == of_b) return of_a / sum;
    return half(of_a) / (half(of_a) + half(of_b));  // of masses too light for their sum
}

template <class World, class Index, class Vector, class Scalar>
void part_two(World& world, Index a, Index b, const Vector& direction, Scalar change, Scalar share,
              Vector World::Particle::*quantity) {
    auto& first = world.particles()[a];
    const bool moves_first = movable(first);
    if (is_particle(world, b) && movable(world.particles()[b])) {
        const Scalar of_first = moves_first ? change * share : Scalar();
        (world.particles()[b].*quantity).add_scaled(direction, of_first - change);
        change = of_first;
    }
    if (moves_first) (first.*quantity).add_scaled(direction, change);
}

// Parts a from b, which may be nothing, by `change` along the direction from b to a, in `quantity`,
// &Particle::position or &Particle::velocity. `share` is share_of(world, a, b).
template <class World, class Index, class Vector, class Scalar>
ENGINE_INLINE void part(World& world, Index a, Index b, const Vector& direction, Scalar change,
                        Scalar share, Vector World::Particle::*quantity) {
    auto& first = world.particles()[a];
    if (World::has_pairs) {
        part_two(world, a, b, direction, change, share, quantity);
    } else if (movable(first)) {
        (first.*quantity).add_scaled(direction, change);
    }
}

}  // namespace engine
