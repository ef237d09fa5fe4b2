// SPDX-License-Identifier: MIT
// What can go wrong in a world. A world keeps the first error, until it is cleared.
#pragma once

namespace engine {

enum class Error : unsigned char {
    none,
    pool_full,         // more particles, forces or constraints than the scene's type states
    no_such_particle,  // a handle that no particle of this world belongs to
    same_particle,     // both ends of a spring, rod or rope are one particle
    bad_mass,          // a negative inverse mass
    bad_radius,        // a negative radius
    bad_length,        // a rod or rope of no or negative length, a spring of negative length
    bad_stiffness,     // a negative stiffness, damping or drag
    bad_normal,        // a plane whose normal has no length
    contacts_full,     // in a step: more contacts at once than the scene's type states
    no_direction,      // in a step: both ends of a rod are at one place
};

// The error in words, for hosts.
constexpr const char* describe(Error error) {
    switch (error) {
        case Error::none:
            return "no error";
        case Error::pool_full:
            return "a pool is full: raise the capacity that the scene states";
        case Error::no_such_particle:
            return "a handle belongs to no particle of this world";
        case Error::same_particle:
            return "both ends of a link are the same particle";
        case Error::bad_mass:
            return "an inverse mass is negative";
        case Error::bad_radius:
            return "a radius is negative";
        case Error::bad_length:
            return "a rod or rope needs a positive length, a spring no negative one";
        case Error::bad_stiffness:
            return "a stiffness, damping or drag is negative";
        case Error::bad_normal:
            return "the normal of a plane has no length";
        case Error::contacts_full:
            return "more contacts in a step than the scene states";
        case Error::no_direction:
            return "both ends of a rod are at one place, where it has no direction";
    }
    return "unknown error";
}

}  // namespace engine
