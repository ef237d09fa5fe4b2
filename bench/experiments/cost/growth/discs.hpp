// SPDX-License-Identifier: GPL-3.0-or-later
// N discs that start on a square lattice in a box in the plane and bounce off each other and the
// walls without loss: the scene for timing the engine and Box2D on this machine. N must be a square
// number. The box grows with N at constant density. Conserved: the kinetic energy.
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

// MurmurHash3's finaliser (A. Appleby): consecutive numbers become unrelated ones.
constexpr unsigned mixed(unsigned x) {
    x = (x ^ x >> 16) * 0x85ebca6b;
    x = (x ^ x >> 13) * 0xc2b2ae35;
    return x ^ x >> 16;
}

// Disc i of n, relative to the middle of the box. All numbers are multiples of 1/2, exact in all
// formats.
constexpr Disc disc(unsigned i, unsigned n) {
    const unsigned edge = edge_of(n);
    const auto start = [&](unsigned cell) {
        return static_cast<float>(cell) + 0.5f - static_cast<float>(edge) / 2;
    };
    // Neighbours in a row or a column must not move alike, or the motion would depend on the number
    // of columns.
    const auto speed = [&](unsigned axis) {
        return static_cast<float>(mixed(2 * i + axis + 1) % 9) - 4;
    };
    return {{start(i % edge), start(i / edge)}, {speed(0), speed(1)}};
}

// One program for every number of discs: if each had its own, the layout of the loops by the
// compiler would change the time of a test by up to a quarter from one to the next.
constexpr unsigned max_discs = 16384;

template <class Search>
struct DiscUses : scenes::UsesWith<scenes::SemiImplicit> {
    static constexpr unsigned char dimensions = 2;
    static constexpr unsigned particles = max_discs, planes = 4, contacts = 2 * max_discs;
    static constexpr bool radii = true, collisions = true;
    using BroadPhase = Search;
};

template <class Search>
using DiscWorld = engine::World<fixedpoint::Q16_16, DiscUses<Search>>;

// n must be a square number, so that the lattice has no gaps.
template <class Search>
void build(DiscWorld<Search>& world, unsigned n) {
    using Scalar = fixedpoint::Q16_16;
    const auto number = [](float x) { return fixedpoint::from_float<Scalar>(x); };
    world.set_restitution(number(1));
    for (unsigned char axis = 0; axis < 2; ++axis) {
        typename DiscWorld<Search>::Vector normal;
        normal[axis] = number(1);
        world.add_plane(normal, number(-half_edge(n)), number(1));
        world.add_plane(-normal, number(-half_edge(n)), number(1));
    }
    typename DiscWorld<Search>::Body body;
    body.inverse_mass = number(1);
    body.radius = number(disc_radius);
    for (unsigned i = 0; i < n; ++i) {
        const Disc start = disc(i, n);
        for (unsigned char axis = 0; axis < 2; ++axis) {
            body.position[axis] = number(start.position[axis]);
            body.velocity[axis] = number(start.velocity[axis]);
        }
        world.add_particle(body);
    }
}

}  // namespace growth
