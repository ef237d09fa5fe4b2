// SPDX-License-Identifier: MIT
/// \file
/// What can go wrong in a world. A world keeps the first error until it is cleared. A number that
/// is NaN or infinite counts as out of range.
#pragma once

#include <fixedpoint/constexpr.hpp>

namespace engine {

/// The first error of a world. No error stops the world.
enum class Error : unsigned char {
    none,              ///< all is well
    pool_full,         ///< more particles, forces or constraints than Uses states
    no_such_particle,  ///< a handle that names no particle of this world
    same_particle,     ///< both ends of a spring, rod or rope are one particle
    bad_mass,          ///< a negative inverse mass
    bad_radius,        ///< a negative radius
    bad_length,        ///< a length (or its inverse) of 0 or less, a negative rest length
    bad_stiffness,     ///< a negative stiffness, damping or drag
    bad_normal,        ///< a plane whose normal is not of length 1
    contacts_full,     ///< in a step: more contacts than Uses states
    no_direction,      ///< in a step: both ends of a rod are in the same place
    bad_restitution,   ///< a restitution outside 0..1, or a negative restitution threshold
    bad_damping,       ///< a damping factor outside 0..1
    bad_time_step,     ///< a step of 0 s or less
    not_finite,        ///< a position, velocity, anchor, normal or offset that is NaN or infinite
    no_chain,          ///< in a step: a rod or spring shares particles with two added before it
    no_such_link,      ///< a spring, rod or rope that does not belong to this world
};

/// The error in words, for hosts.
FIXEDPOINT_CONSTEXPR const char* describe(Error error) {
    switch (error) {
        case Error::none:
            return "no error";
        case Error::pool_full:
            return "a pool is full: raise the capacity that the scene states";
        case Error::no_such_particle:
            return "a handle belongs to no particle of this world";
        case Error::no_such_link:
            return "a spring, rod or rope belongs to another world";
        case Error::same_particle:
            return "both ends of a link are the same particle";
        case Error::not_finite:
            return "a position, velocity, anchor, normal or offset is not finite";
        case Error::bad_mass:
            return "an inverse mass is negative";
        case Error::bad_radius:
            return "a radius is negative";
        case Error::bad_damping:
            return "a damping factor is not between 0 and 1";
        case Error::bad_length:
            return "a rod or rope needs a positive length, a spring no negative one";
        case Error::bad_stiffness:
            return "a stiffness, damping or drag is negative";
        case Error::bad_normal:
            return "the normal of a plane is not of length 1";
        case Error::bad_restitution:
            return "a restitution is not between 0 and 1, or its threshold is negative";
        case Error::bad_time_step:
            return "a time step is not positive";
        case Error::contacts_full:
            return "more contacts in a step than the scene states";
        case Error::no_chain:
            return "a rod or spring solved directly shares particles with two that were added "
                   "before it";
        case Error::no_direction:
            return "both ends of a rod are at one place, where it has no direction";
    }
    return "unknown error";
}

}  // namespace engine
