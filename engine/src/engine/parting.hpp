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
    if (b == nothing<Index>) return Scalar();
    const Scalar of_a = world.particles()[a].inverse_mass;
    const Scalar of_b = world.particles()[b].inverse_mass;
    if (of_a == Scalar() || of_b == Scalar()) return Scalar();
    return of_a / (of_a + of_b);
}

struct VelocityOf {
    template <class Particle>
    ENGINE_INLINE auto& operator()(Particle& particle) const {
        return particle.velocity;
    }
};
struct PositionOf {
    template <class Particle>
    ENGINE_INLINE auto& operator()(Particle& particle) const {
        return particle.position;
    }
};

// Parts a from b, which may be nothing, by `change` along the direction from b to a, in position
// or velocity. `share` is share_of(world, a, b).
template <class World, class Index, class Vector, class Scalar, class Quantity>
void part(World& world, Index a, Index b, const Vector& direction, Scalar change, Scalar share,
          Quantity quantity) {
    auto& particles = world.particles();
    if (b == nothing<Index> || !movable(particles[b])) {
        quantity(particles[a]).add_scaled(direction, change);
    } else if (!movable(particles[a])) {
        quantity(particles[b]).add_scaled(direction, -change);
    } else {
        const Scalar of_a = change * share;
        quantity(particles[a]).add_scaled(direction, of_a);
        quantity(particles[b]).add_scaled(direction, of_a - change);
    }
}

}  // namespace engine
