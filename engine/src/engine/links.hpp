// SPDX-License-Identifier: MIT
/// \file
/// Springs, rods and ropes, which act between two particles or between a particle and a fixed
/// point. Drag and planes, which act on one particle.
#pragma once

#include <engine/decimal.hpp>
#include <engine/distance.hpp>
#include <engine/vector.hpp>

namespace engine {

/// The index that stands for no second particle.
template <class Index>
constexpr Index nothing() {
    return static_cast<Index>(-1);
}

/// \cond internal
// The index, which must not be nothing: the compiler drops the code for that case.
template <class Index>
constexpr Index certain(Index index) {
    return index != nothing<Index>() ? index : (__builtin_unreachable(), index);
}
/// \endcond

/// The ends are the particles a and b.
template <class Vector, class Index>
struct Between {
    /// The index of a particle.
    /// @{
    Index a, b;
    /// @}

    /// \cond internal
    constexpr Index second() const { return certain(b); }
    template <class World>
    constexpr const Vector& second_position(const World& world) const {
        return world.particles()[b].position;
    }
    template <class World>
    constexpr Vector difference(const World& world) const {
        return world.particles()[a].position - second_position(world);
    }
    /// \endcond
};

/// The ends are the particle a and the fixed point `anchor`.
template <class Vector, class Index>
struct Anchored {
    /// The index of the particle.
    Index a;
    Vector anchor;  ///< m

    /// \cond internal
    constexpr Index second() const { return nothing<Index>(); }
    template <class World>
    constexpr const Vector& second_position(const World&) const {
        return anchor;
    }
    template <class World>
    constexpr Vector difference(const World& world) const {
        return world.particles()[a].position - anchor;
    }
    /// \endcond
};

/// A massless spring with damping along its length.
template <class Scalar, class Ends>
struct Spring {
    /// The two ends.
    Ends ends;
    Scalar stiffness;    ///< N/m
    Scalar damping;      ///< N s/m
    Scalar rest_length;  ///< m
};

/// Holds its ends at a fixed distance.
template <class Scalar, class Ends>
struct Rod {
    /// The two ends.
    Ends ends;
    Scalar length;  ///< m
    /// \cond internal
    Inverse<Scalar> inverse;  // of the length
    /// \endcond
};

/// Keeps its ends no further apart than its length.
template <class Scalar, class Ends>
struct Rope {
    /// The two ends.
    Ends ends;
    Scalar length;       ///< m
    Scalar restitution;  ///< rebound velocity / velocity at which it becomes taut, 0..1
    /// \cond internal
    Inverse<Scalar> inverse;  // of the length
    /// \endcond
};

/// \cond internal
template <class Link, class Scalar>
void give_length(Link& link, Scalar length) {
    link.length = length;
    link.inverse = inverse_of(length);
}
template <class Scalar, class Ends>
void give_length(Spring<Scalar, Ends>& spring, Scalar length) {
    spring.rest_length = length;
}
/// \endcond

/// Slows a particle: force = -velocity (linear + quadratic |velocity|).
template <class Scalar, class Index>
struct Drag {
    /// The index of the particle.
    Index particle;
    Scalar linear;     ///< N s/m
    Scalar quadratic;  ///< N s^2/m^2
};

/// The half space of the points x with normal . x >= offset is free. The rest is solid.
template <class Scalar, class Vector>
struct Plane {
    Vector normal;       ///< of length 1
    Scalar offset;       ///< m
    Scalar restitution;  ///< 0..1

    /// \cond internal
    // For a normal along an axis, as of floors and walls: the axis + 1, negative where the normal
    // points backwards. 0 for every other normal.
    signed char axis;
    // normal . v. Along an axis that is exactly one component: a product costs as much as
    // everything else that a plane takes for a particle that is far away.
    Scalar along_normal(const Vector& v) const {
        if (axis == 0) return dot(normal, v);
        return axis > 0 ? v[static_cast<unsigned char>(axis - 1)]
                        : -v[static_cast<unsigned char>(-axis - 1)];
    }
    /// \endcond
};
/// \cond internal
template <class Scalar, int N>
signed char axis_of(const Vector<Scalar, N>& normal) {
    const Scalar one = Decimal<1, 0>();
    signed char axis = 0;
    for (unsigned char i = 0; i < N; ++i) {
        if (normal[i] == Scalar()) continue;
        if (axis != 0 || !(absolute(normal[i]) == one)) return 0;
        // Not `normal[i] < one`: next to that comparison avr-gcc 5.4 turns it into <=, of 64 bits.
        axis = static_cast<signed char>(normal[i] < Scalar() ? -i - 1 : i + 1);
    }
    return axis;
}
/// \endcond

/// Whether the second end is a particle. Known at compile time for a world in which nothing acts
/// between two particles.
template <class World, class Index>
constexpr bool is_particle(const World&, Index second) {
    return World::has_pairs && second != nothing<Index>();
}

/// The velocity of a relative to b. b may be nothing.
template <class World, class Index>
ENGINE_INLINE typename World::Vector relative_velocity(const World& world, Index a, Index b) {
    typename World::Vector velocity = world.particles()[a].velocity;
    if (is_particle(world, b)) velocity -= world.particles()[b].velocity;
    return velocity;
}

/// The velocity of a relative to b along a direction. b may be nothing.
template <class World, class Index, class Vector>
ENGINE_INLINE typename World::Scalar velocity_along(const World& world, Index a, Index b,
                                                    const Vector& direction) {
    const Vector& velocity = world.particles()[a].velocity;
    if (!is_particle(world, b)) return dot(direction, velocity);
    return dot_difference(direction, velocity, world.particles()[b].velocity);
}

}  // namespace engine
