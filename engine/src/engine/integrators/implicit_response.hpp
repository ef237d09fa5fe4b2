// SPDX-License-Identifier: MIT
// How a single spring responds in an implicit step: shared by the integrators that solve springs.
//
// Let i be the sum of the inverse masses, x the extension, u the velocity along the spring, k the
// stiffness and c the damping. The velocity along the spring at the end of the step solves
//   u' = u - h i (k (x + h u') + c u'),  so  u' = u / d - (s / d) x
// with s = i h k and d = 1 + h i (h k + c). s / d is at most 1 / h, so that only s itself and i (h
// k + c) can leave a format, where very stiff springs pull very light masses. Both saturate alike,
// which makes such a spring softer but no less stable. h k is formed before it is multiplied by i,
// since h i vanishes for heavy masses.
#pragma once

#include <engine/decimal.hpp>
#include <engine/links.hpp>
#include <engine/time_step.hpp>

namespace engine {

/// \cond internal
template <class Scalar>
struct ImplicitResponse {
    Scalar s, slowing, d;  // slowing is i (h k + c)
};

template <class World, class Index>
typename World::Scalar inverse_mass_sum(const World& world, Index a, Index b) {
    auto sum = world.particles()[a].inverse_mass;
    if (is_particle(world, b)) sum = saturating_sum(sum, world.particles()[b].inverse_mass);
    return sum;
}

// `mobility` must be the inverse_mass_sum of the spring's ends.
template <class Spring, class Scalar, class TimeStep>
ENGINE_INLINE ImplicitResponse<Scalar> implicit_response(const Spring& spring, Scalar mobility,
                                                         TimeStep dt) {
    const Scalar push = spring.stiffness * dt;
    const Scalar s = saturating_product(mobility, push);
    const Scalar slowing = spring.damping == Scalar()
                               ? s
                               : saturating_product(mobility, saturating_sum(push, spring.damping));
    const Scalar one = Decimal<1, 0>();
    return {s, slowing, saturating_sum(one, slowing * dt)};
}
/// \endcond

}  // namespace engine
