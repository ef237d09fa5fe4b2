// SPDX-License-Identifier: MIT
/// \file
/// Finds the constraint rows of a step: of rods, of taut ropes, of particles inside planes and of
/// particles that overlap. A direction points from the second end to the first.
#pragma once

#include <engine/choice.hpp>
#include <engine/decimal.hpp>
#include <engine/distance.hpp>
#include <engine/error.hpp>
#include <engine/links.hpp>
#include <engine/observe.hpp>
#include <engine/overlap.hpp>
#include <engine/particle.hpp>

namespace engine {

/// \cond internal
// measure(), inline where the world has only one kind of such links: a call costs as much as a
// product.
template <bool may_be_slack, class World, class Link, class Vector, class Scalar>
ENGINE_INLINE bool measure(const World& world, const Link& link, Vector& direction, Scalar& excess,
                           If<true>) {
    return measure<may_be_slack>(world.particles()[link.ends.a].position,
                                 link.ends.second_position(world), link.length, link.inverse,
                                 direction, excess);
}
template <bool may_be_slack, class Scalar, int N>
bool measure_by_call(const Vector<Scalar, N>& first, const Vector<Scalar, N>& second,
                     const Scalar& length, const Inverse<Scalar>& inverse,
                     Vector<Scalar, N>& direction, Scalar& excess) {
    return measure<may_be_slack>(first, second, length, inverse, direction, excess);
}
template <bool may_be_slack, class World, class Link, class Vector, class Scalar>
ENGINE_INLINE bool measure(const World& world, const Link& link, Vector& direction, Scalar& excess,
                           If<false>) {
    return measure_by_call<may_be_slack>(world.particles()[link.ends.a].position,
                                         link.ends.second_position(world), link.length,
                                         link.inverse, direction, excess);
}
/// \endcond

/// A rod makes a row in every step, since it constrains the velocity even where its length is
/// right. If its ends coincide there is no direction: it sets error() to no_direction and makes no
/// row.
template <class World, class Scalar, class Ends, class TimeStep>
ENGINE_INLINE void constrain(const Rod<Scalar, Ends>& rod, World& world, TimeStep dt) {
    observe<Scalar>(Quantity::rod);
    typename World::Vector direction;
    Scalar excess;
    const If<World::Uses::rods == 0 || World::Uses::anchored_rods == 0> once = {};
    if (!measure<false>(world, rod, direction, excess, once)) {
        return world.report(Error::no_direction);
    }
    World::Solver::rod(world, rod.ends.a, rod.ends.second(), direction, excess, rod.inverse, dt);
}

/// \cond internal
// Whether a rope acts that lacks `slack` to be taut. A row leaves it as long as it should be, but
// for rounding and a remainder of fourth order in the step. If that counted as slack, a taut rope
// would act in every other step only. Its ends close that gap in a small part of the step; a rope
// that becomes taut at the end of a free motion is found a sixteenth of a step early at most.
template <class World, class Ends, class Vector, class Scalar, class TimeStep>
__attribute__((noinline)) bool nearly_taut(const World& world, const Ends& ends,
                                           const Vector& direction, Scalar slack, TimeStep dt) {
    if (!(slack > RestingGap<Scalar>::value())) return true;
    const Scalar apart = velocity_along(world, ends.a, ends.second(), direction) * dt;
    return half(half(half(half(apart)))) > slack;
}
/// \endcond

/// A rope makes a row where it is too long, taut, or so nearly taut that its ends make it so within
/// a sixteenth of the step. If its ends coincide it makes none.
template <class World, class Scalar, class Ends, class TimeStep>
ENGINE_INLINE void constrain(const Rope<Scalar, Ends>& rope, World& world, TimeStep dt) {
    observe<Scalar>(Quantity::rope);
    typename World::Vector direction;
    Scalar excess;
    const If<World::Uses::ropes == 0 || World::Uses::anchored_ropes == 0> once = {};
    if (!measure<true>(world, rope, direction, excess, once)) return;
    if (excess < Scalar()) {
        if (!nearly_taut(world, rope.ends, direction, -excess, dt)) return;
        excess = Scalar();
    }
    World::Solver::rope(world, rope.ends.a, rope.ends.second(), direction, excess, rope.inverse,
                        rope.restitution, dt);
}

/// A particle makes a row where it reaches into a plane. Inline, like collide(): most particles do
/// not touch the plane, and a call would cost more than finding that out.
template <class World, class Scalar, class Vector, class Index, class TimeStep>
ENGINE_INLINE void constrain(const Plane<Scalar, Vector>& plane, Index a, World& world,
                             TimeStep dt) {
    observe<Scalar>(Quantity::plane);
    const auto& particle = world.step_particles()[a];
    if (!movable(particle)) return;
    Scalar height = plane.along_normal(particle.position) - plane.offset;
    only_if<World::Uses::radii>(
        particle, [&](const typename World::Particle& sphere) { height -= radius_of(sphere); });
    if (height < Scalar()) {
        World::Solver::contact(world, a, nothing<Index>(), plane.normal, -height, plane.restitution,
                               dt);
    }
}

/// Two particles make a row where they overlap. Particles that are apart along one axis are apart:
/// that test takes no product, and no square of a distance beyond the radii is formed. Most pairs
/// are apart along the first axis.
template <class World, class Index, class TimeStep>
ENGINE_INLINE void collide(Index a, Index b, World& world, TimeStep dt) {
    using Scalar = typename World::Scalar;
    observe<Scalar>(Quantity::contact);
    const auto& first = world.step_particles()[a];
    const auto& second = world.step_particles()[b];
    const Scalar reach = first.radius + second.radius;
    for (unsigned char i = 0; i < World::dimensions; ++i) {
        if (!(absolute(first.position[i] - second.position[i]) < reach)) return;
    }
    if (!movable(first) && !movable(second)) return;
    auto normal = first.position - second.position;
    const Scalar depth =
        overlap(first.position, second.position, reach, world.last_reach(), normal);
    if (!(depth > Scalar())) return;
    World::Solver::contact(world, a, certain(b), normal, depth, world.restitution(), dt);
}

}  // namespace engine
