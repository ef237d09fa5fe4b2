// SPDX-License-Identifier: MIT
/// \file
/// CachedSortAndSweep: finds the pairs of SortAndSweep in the same order, where RAM is plentiful.
/// Neighbours along the axis may be anywhere in memory, and a sweep reads a particle once for each
/// of them. So the numbers it compares are copied to one array: three numbers and an index per
/// particle. (Not one template for both: on the AVR, small pools would take more flash.)
#pragma once

#include <engine/constraints.hpp>

namespace engine {

/// \cond internal
// A particle in the order, with copies of the numbers that the search compares.
template <class World>
struct Cached {
    typename World::Scalar lower_edge, across, radius;
    typename World::Index index;

    template <class Particles>
    ENGINE_INLINE void read(const Particles& particles) {
        const auto& particle = particles[index];
        lower_edge = particle.position[0] - particle.radius;
        across = particle.position[1];
        radius = particle.radius;
    }
};

// Whether two particles are apart along the second axis, by the same test as in collide(). Takes
// the world so that a search can be watched.
template <class Ordered, class World>
ENGINE_INLINE bool are_apart(const Ordered& a, const Ordered& b, World&) {
    return !(absolute(a.across - b.across) < a.radius + b.radius);
}
/// \endcond

/// The broad phase for many particles where RAM is plentiful.
struct CachedSortAndSweep {
    /// \cond internal
    template <class World>
    struct Memory {
        Cached<World> order[World::capacity] = {};
        typename World::Index count = 0;  // of particles in the order
    };

    template <class World, class TimeStep>
    static void collide_all(World& world, TimeStep dt) {
        auto& memory = world.pair_memory();
        const auto& particles = world.step_particles();
        for (; memory.count < particles.size(); ++memory.count) {
            memory.order[memory.count].index = memory.count;
        }
        auto* const begin = memory.order;
        auto* const end = begin + memory.count;
        for (auto* next = begin; next != end; ++next) {
            auto moving = *next;
            moving.read(particles);
            auto* place = next;
            for (; place != begin && moving.lower_edge < place[-1].lower_edge; --place) {
                *place = place[-1];
            }
            *place = moving;
        }
        for (auto* next = begin; next != end; ++next) {
            auto a = *next;
            const auto upper_edge = particles[a.index].position[0] + a.radius;
            for (auto* b = next + 1; b != end && b->lower_edge < upper_edge; ++b) {
                if (are_apart(a, *b, world)) continue;
                collide(a.index, b->index, world, dt);
                // If they overlap, both have moved.
                a.read(particles);
                b->read(particles);
            }
        }
    }
    /// \endcond
};

}  // namespace engine
