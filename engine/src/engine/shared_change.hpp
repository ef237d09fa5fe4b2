// SPDX-License-Identifier: MIT
// A change along a line, shared by the two particles at its ends in proportion to inverse mass.
#pragma once

#include <engine/links.hpp>
#include <engine/particle.hpp>

namespace engine {

// Whether the particle a can move, or b, which may be nothing.
template <class World, class Index>
bool either_moves(const World& world, Index a, Index b) {
    return movable(world.particles()[a]) ||
           (is_particle(world, b) && movable(world.particles()[b]));
}

// The part of a change that a takes: i_a / (i_a + i_b) of the inverse masses. b takes the rest. At
// least one of the two must be movable.
template <class World, class Index>
typename World::Scalar mass_share(const World& world, Index a, Index b) {
    using Scalar = typename World::Scalar;
    const Scalar one = Decimal<1, 0>();
    if (!World::has_pairs) return one;  // known at compile time, so that no quotient is linked
    if (!is_particle(world, b)) return one;
    const Scalar of_a = world.particles()[a].inverse_mass;
    const Scalar of_b = world.particles()[b].inverse_mass;
    if (of_b == Scalar()) return one;
    if (of_a == Scalar()) return Scalar();
    if (of_a == of_b) return Decimal<5, 1>();  // equal to the quotient, without a division
    const Scalar sum = saturating_sum(of_a, of_b);
    if (sum - of_a == of_b) return brief_quotient(of_a, sum);
    return brief_quotient(half(of_a), half(of_a) + half(of_b));  // where the sum does not fit
}

// For two particles of different mass. The share of an immovable one is 0, and takes no product.
template <class Vector, class Scalar>
void share_between(Vector& of_a, Vector& of_b, const Vector& direction, Scalar change,
                   Scalar share) {
    Scalar part = Scalar();
    if (!(share == Scalar())) {
        part = change * share;
        of_a.add_scaled(direction, part);
    }
    if (!(part == change)) of_b.add_scaled(direction, part - change);
}

// Half of a change, rounded toward zero: of an odd change one ulp is left. So a particle at rest on
// another stays in touch with it; half an ulp too much would lift it off.
template <class Scalar>
Scalar half_toward_zero(Scalar change) {
    const Scalar half_up = change * BinaryStep<1>();
    return half_up > Scalar() ? change - half_up : half_up;
}

// Changes `quantity`, &Particle::position or &Particle::velocity, of a relative to b by `change`
// along `direction`, which points from b to a; b may be nothing. `share` must be mass_share(world,
// a, b), and at least one of the two must be movable. Two particles of equal mass take the same
// product, so that the sum of their momenta is unchanged to the last bit: a change of one ulp then
// has no effect. Returns whether anything changed.
template <class Vector, class Scalar>
ENGINE_INLINE bool apply_shared(Vector& of_a, Vector* of_b, const Vector& direction, Scalar change,
                                Scalar share) {
    if (of_b == nullptr) {
        of_a.add_scaled(direction, change);
        return true;
    }
    const Scalar one_half = Decimal<5, 1>();
    if (!(share == one_half)) {
        share_between(of_a, *of_b, direction, change, share);
        return true;
    }
    const Scalar part = half_toward_zero(change);
    if (part == Scalar()) return false;
    exchange(of_a, *of_b, direction, part);
    return true;
}
template <class World, class Index, class Vector, class Scalar>
ENGINE_INLINE bool apply_shared(World& world, Index a, Index b, const Vector& direction,
                                Scalar change, Scalar share, Vector World::Particle::*quantity) {
    auto& particles = world.step_particles();
    return apply_shared(particles[a].*quantity,
                        is_particle(world, b) ? &(particles[b].*quantity) : nullptr, direction,
                        change, share);
}

}  // namespace engine
