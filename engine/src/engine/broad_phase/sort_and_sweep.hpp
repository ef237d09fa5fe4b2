// SPDX-License-Identifier: MIT
/// \file
/// SortAndSweep: keeps the particles sorted by their lower edges along the first axis, by
/// insertion, from one step to the next. Only pairs that overlap along this axis are tested. Takes
/// one index of RAM per particle. (D. Baraff, Dynamic Simulation of Non-Penetrating Rigid Bodies,
/// 1992.)
#pragma once

#include <engine/constraints.hpp>

namespace engine {

/// The broad phase of many particles: tests the pairs that overlap along the first axis.
struct SortAndSweep {
    /// \cond internal
    template <class World>
    struct Memory {
        typename World::Index order[World::capacity] = {};
        typename World::Index count = 0;  // of particles in the order
    };

    template <class World, class TimeStep>
    static void collide_all(World& world, TimeStep dt) {
        using Index = typename World::Index;
        using Scalar = typename World::Scalar;
        auto& memory = world.pair_memory();
        const auto& particles = world.step_particles();
        const auto left = [&](Index i) { return particles[i].position[0] - particles[i].radius; };
        while (memory.count < particles.size()) {
            memory.order[memory.count] = memory.count;
            ++memory.count;
        }
        for (Index i = 1; i < memory.count; ++i) {
            const Index moving = memory.order[i];
            const Scalar edge = left(moving);
            Index j = i;
            for (; j > 0 && edge < left(memory.order[j - 1]); --j) {
                memory.order[j] = memory.order[j - 1];
            }
            memory.order[j] = moving;
        }
        for (Index i = 0; i < memory.count; ++i) {
            const Index a = memory.order[i];
            const Scalar right = particles[a].position[0] + particles[a].radius;
            for (Index j = static_cast<Index>(i + 1);
                 j < memory.count && left(memory.order[j]) < right; ++j) {
                collide(a, memory.order[j], world, dt);
            }
        }
    }
    /// \endcond
};

}  // namespace engine
