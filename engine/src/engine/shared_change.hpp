// SPDX-License-Identifier: MIT
// A change along a line, shared by the two particles at its ends in proportion to inverse mass.
#pragma once

#include <engine/links.hpp>
#include <engine/particle.hpp>

namespace engine {

// i_a / (i_a + i_b) of the inverse masses, where both can move; else 0, which apply_shared() does
// not read.
template <class World, class Index>
typename World::Scalar mass_share(const World& world, Index a, Index b) {
    using Scalar = typename World::Scalar;
    if (!is_particle(world, b)) return Scalar();
    const Scalar of_a = world.particles()[a].inverse_mass;
    const Scalar of_b = world.particles()[b].inverse_mass;
    if (of_a == Scalar() || of_b == Scalar()) return Scalar();
    if (of_a == of_b) return Decimal<5, 1>();  // as the quotient, without a division
    const Scalar sum = saturating_sum(of_a, of_b);
    if (sum - of_a == of_b) return of_a / sum;
    return half(of_a) / (half(of_a) + half(of_b));  // where the sum leaves the format
}

template <class World, class Index, class Vector, class Scalar>
void apply_shared_to_two(World& world, Index a, Index b, const Vector& direction, Scalar change,
                         Scalar share, Vector World::Particle::*quantity) {
    auto& first = world.step_particles()[a];
    const bool moves_first = movable(first);
    if (is_particle(world, b) && movable(world.step_particles()[b])) {
        const Scalar of_first = moves_first ? change * share : Scalar();
        (world.step_particles()[b].*quantity).add_scaled(direction, of_first - change);
        change = of_first;
    }
    if (moves_first) (first.*quantity).add_scaled(direction, change);
}

// Changes `quantity`, &Particle::position or &Particle::velocity, of a relative to b by `change`
// along `direction`, which points from b to a; b may be nothing. `share` must be mass_share(world,
// a, b).
template <class World, class Index, class Vector, class Scalar>
ENGINE_INLINE void apply_shared(World& world, Index a, Index b, const Vector& direction,
                                Scalar change, Scalar share, Vector World::Particle::*quantity) {
    auto& first = world.step_particles()[a];
    if (World::has_pairs) {
        apply_shared_to_two(world, a, b, direction, change, share, quantity);
    } else if (movable(first)) {
        (first.*quantity).add_scaled(direction, change);
    }
}

}  // namespace engine
