// SPDX-License-Identifier: MIT
/// \file
/// state_hash: the FNV-1a hash of the positions and velocities of all particles, in the order in
/// which they were added. Equal worlds of one scalar have equal hashes on every little-endian
/// machine. (G. Fowler, L. C. Noll, K.-P. Vo, The FNV Non-Cryptographic Hash Algorithm, 1991.)
#pragma once

#include <stdint.h>

namespace engine {

/// The hash continued with the bytes of a vector.
template <class Vector>
uint32_t hash_into(uint32_t hash, const Vector& vector) {
    const unsigned char* bytes = reinterpret_cast<const unsigned char*>(&vector);
    for (unsigned char i = 0; i < sizeof vector; ++i) hash = (hash ^ bytes[i]) * 16777619u;
    return hash;
}

/// The hash of all positions and velocities of a world.
template <class World>
uint32_t state_hash(const World& world) {
    uint32_t hash = 2166136261u;
    for (const auto& particle : world.particles()) {
        hash = hash_into(hash, particle.position);
        hash = hash_into(hash, particle.velocity);
    }
    return hash;
}

}  // namespace engine
