// SPDX-License-Identifier: MIT
// UserForce: a force on one particle, set from outside between steps.
#pragma once

namespace scenes {

template <class World, unsigned char particle>
struct UserForce {
    typename World::Vector force;  // N
    void apply(World& world) const { world.step_particles()[particle].force += force; }
};

}  // namespace scenes
