// SPDX-License-Identifier: MIT
// ExplicitEuler: the published order of a step, the baseline: forces, contacts, then positions by
// the old velocities, velocities, damping. First order; the energy of an oscillation grows by the
// factor 1 + (omega h)^2 a step.
#pragma once

namespace engine {

struct ExplicitEuler {
    static constexpr bool implicit_springs = false;
    template <class World>
    struct Memory {};

    template <class World, class TimeStep>
    static void step(World& world, TimeStep dt) {
        world.accumulate_forces();
        world.gather(dt);
        world.resolve();
        world.drift(dt);
        world.kick(dt);
        world.damp();
    }
};

}  // namespace engine
