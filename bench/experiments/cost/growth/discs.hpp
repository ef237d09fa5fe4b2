// SPDX-License-Identifier: GPL-3.0-or-later
// N discs that start on a square lattice in a box in the plane and bounce off each other and the
// walls without loss. This is what the engine and Box2D are timed with on this machine. The box
// grows with N, a square number; its density does not. Conserved: the kinetic energy.
#pragma once

#include <scenes/methods.hpp>

namespace growth {

struct Disc {
    float position[2], velocity[2];  // m, m/s
};

constexpr unsigned edge_of(unsigned n) {
    unsigned edge = 0;
    while (edge * edge < n) ++edge;
    return edge;
}

constexpr unsigned exponent_of_step = 8;  // 2^-8 s
constexpr float disc_radius = 0.25f;      // m, a quarter of the lattice's spacing
constexpr float half_edge(unsigned n) { return static_cast<float>(edge_of(n)) / 2; }  // m

// Disc i of n, relative to the middle of the box. Every number is a multiple of 1/2: exact in all
// formats.
constexpr Disc disc(unsigned i, unsigned n) {
    const unsigned edge = edge_of(n);
    const auto start = [&](unsigned cell) {
        return static_cast<float>(cell) + 0.5f - static_cast<float>(edge) / 2;
    };
    // Mixed, so that no number of columns makes all speeds alike, and every box is a similar crowd.
    const auto speed = [&](unsigned axis) {
        return static_cast<float>(((2 * i + axis) * 2654435761u >> 16) % 9) - 4;
    };
    return {{start(i % edge), start(i / edge)}, {speed(0), speed(1)}};
}

template <unsigned N, class Search>
struct DiscUses : scenes::UsesWith<scenes::SemiImplicit> {
    static_assert(edge_of(N) * edge_of(N) == N, "The lattice has no gaps: N is a square.");
    static constexpr unsigned char dimensions = 2;
    static constexpr unsigned particles = N, planes = 4, contacts = 2 * N;
    static constexpr bool radii = true, collisions = true;
    using BroadPhase = Search;
};

template <unsigned N, class Search>
using DiscWorld = engine::World<fixedpoint::Q16_16, DiscUses<N, Search>>;

template <unsigned N, class Search>
void build(DiscWorld<N, Search>& world) {
    using Scalar = fixedpoint::Q16_16;
    const auto number = [](float x) { return fixedpoint::from_float<Scalar>(x); };
    world.set_restitution(number(1));
    for (unsigned char axis = 0; axis < 2; ++axis) {
        typename DiscWorld<N, Search>::Vector normal;
        normal[axis] = number(1);
        world.add_plane(normal, number(-half_edge(N)), number(1));
        world.add_plane(-normal, number(-half_edge(N)), number(1));
    }
    typename DiscWorld<N, Search>::Body body;
    body.inverse_mass = number(1);
    body.radius = number(disc_radius);
    for (unsigned i = 0; i < N; ++i) {
        const Disc start = disc(i, N);
        for (unsigned char axis = 0; axis < 2; ++axis) {
            body.position[axis] = number(start.position[axis]);
            body.velocity[axis] = number(start.velocity[axis]);
        }
        world.add_particle(body);
    }
}

}  // namespace growth
