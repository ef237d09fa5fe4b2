// SPDX-License-Identifier: MIT
// SemiImplicitEuler: velocities first, positions by the new velocities. First order and
// symplectic: the energy of an oscillation stays bounded up to omega h = 2.
#pragma once

namespace engine {

struct SemiImplicitEuler {
    static constexpr bool implicit_springs = false;
    template <class World>
    struct Memory {};

    template <class World, class TimeStep>
    static void step(World& world, TimeStep dt) {
        world.accumulate_forces();
        world.kick(dt);
        world.damp();
        world.gather(dt);
        world.resolve();
        world.drift(dt);
    }
};

}  // namespace engine
