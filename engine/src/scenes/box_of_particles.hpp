// SPDX-License-Identifier: MIT
// N balls in a three-dimensional box. They start on a lattice with velocities in all directions,
// and bounce off each other and the walls for ever. The box grows with N; its density does not.
// Truth: conserved quantities, since the motion is chaotic. Conserved: the kinetic energy; the
// momentum as long as no ball meets a wall. No two balls overlap, and none leaves the box, by more
// than the motion of one step.
#pragma once

#include <scenes/methods.hpp>

namespace scenes {

template <unsigned N>
struct BoxOf {
    static constexpr const char* name = "box_of_particles";
    static constexpr unsigned duration = 4;  // s
    static constexpr unsigned balls = N;

    // Balls along an edge of the lattice: the smallest number whose cube is at least N.
    static constexpr unsigned edge(unsigned n = 1) { return n * n * n < N ? edge(n + 1) : n; }

    template <class Method>
    struct Uses : UsesWith<Method> {
        static constexpr unsigned char dimensions = 3;
        static constexpr unsigned particles = balls, planes = 6, contacts = 2 * balls;
        static constexpr bool radii = true, collisions = true;
    };

    template <class Scalar>
    struct Parameters {
        Scalar half_spacing = engine::Decimal<5, 1>();  // m, between a ball and its wall
        Scalar radius = engine::Decimal<125, 3>();      // m
        Scalar velocity = engine::Decimal<25, 2>();     // m/s; components are -4 to 4 times this
        Scalar restitution = engine::Decimal<1, 0>();
    };

    template <class World>
    static void build(World& world, const Parameters<typename World::Scalar>& with) {
        using namespace engine::literals;
        using Scalar = typename World::Scalar;
        world.set_restitution(with.restitution);
        const Scalar wall = times(edge(), with.half_spacing);
        for (unsigned char axis = 0; axis < 3; ++axis) {
            typename World::Vector normal;
            normal[axis] = 1_d;
            world.add_plane(normal, -wall, with.restitution);
            world.add_plane(-normal, -wall, with.restitution);
        }
        typename World::Body ball;
        ball.inverse_mass = 1_d;
        ball.radius = with.radius;
        for (unsigned i = 0; i < N; ++i) {
            const unsigned cell[3] = {i % edge(), i / edge() % edge(), i / edge() / edge()};
            for (unsigned char axis = 0; axis < 3; ++axis) {
                ball.position[axis] = times(2 * cell[axis] + 1, with.half_spacing) - wall;
                ball.velocity[axis] = times((5 * i + 7 * axis + i * axis) % 9, with.velocity) -
                                      times(4, with.velocity);
            }
            world.add_particle(ball);
        }
    }

  private:
    template <class Scalar>
    static Scalar times(unsigned count, Scalar x) {
        Scalar sum = Scalar();
        for (; count > 0; --count) sum += x;
        return sum;
    }
};

using BoxOfParticles = BoxOf<8>;

}  // namespace scenes
