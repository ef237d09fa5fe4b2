// SPDX-License-Identifier: MIT
/// \file
/// Continuous contacts: a particle that would move further than half its radius in a step moves
/// until it first overlaps something by a quarter of its radius (of the sum of both radii), and no
/// further. The next step finds the contact there, solves it like every other, and the particle
/// moves on. Slower particles move as they do without continuous contacts.
///
/// Particles move one after the other, in the order in which they were added, each against the
/// current positions of all others, so that none passes through another. The price is time: a fast
/// particle loses the rest of the step in which it touches something, and in a close row of fast
/// particles each one behind the first may lose the motion of one step. A fast particle is tested
/// against each plane and each other particle.
#pragma once

#include <engine/choice.hpp>
#include <engine/particle.hpp>
#include <engine/time_step.hpp>

namespace engine {

/// \cond internal
template <class World>
class Flight {
  public:
    using Scalar = typename World::Scalar;
    using Vector = typename World::Vector;
    using Index = typename World::Index;

    template <class TimeStep>
    static void move(World& world, Index moving, TimeStep dt) {
        auto& particle = world.step_particles()[moving];
        Vector way(particle.velocity);
        way *= dt;
        if (!is_far(way, half(particle.radius))) {
            return particle.move(particle.position, particle.velocity, dt);
        }
        const Scalar whole = length(way);
        Flight flight{world, moving, divided(way, whole), whole};
        if (flight.reaches_its_end()) {
            particle.move(particle.position, particle.velocity, dt);
        }
    }

  private:
    World& world;
    const Index moving;
    const Vector direction;
    Scalar left;  // of the path

    Flight(World& of_world, Index of_particle, const Vector& towards, Scalar way)
        : world(of_world), moving(of_particle), direction(towards), left(way) {}

    static bool is_far(const Vector& way, Scalar most) {
        for (unsigned char i = 0; i < World::dimensions; ++i) {
            if (absolute(way[i]) > most) return true;
        }
        return false;
    }

    // Moves the particle if something is in its way. Returns true, and moves nothing, if nothing
    // is. The direction is rounded, so that a long path ends beside its true end: the particle goes
    // 255/256 of the free path and looks again. Each look is more accurate by that factor, and a
    // few suffice; a particle that has not arrived after all of them stops short of the obstacle.
    bool reaches_its_end() {
        auto& particle = world.step_particles()[moving];
        const Scalar near = particle.radius * BinaryStep<3>();
        for (unsigned char looks = 0; looks < 16; ++looks) {
            const Scalar free = free_way();
            if (!(free < left)) {
                if (looks == 0) return true;
                particle.position.add_scaled(direction, left);
                return false;
            }
            if (!(free > near)) return false;
            const Scalar part = free - free * BinaryStep<8>();
            particle.position.add_scaled(direction, part);
            left -= part;
        }
        return false;
    }

    // How far it may go: at most what is left of the path.
    Scalar free_way() const {
        Scalar free = left;
        world.planes().for_each([&](const typename World::Plane& plane) { to_plane(plane, free); });
        only_if<World::Uses::collisions>(*this, [&](const Flight& flight) {
            for (Index other = 0; other < flight.world.particles().size(); ++other) {
                if (other != flight.moving) flight.to_particle(other, free);
            }
        });
        return free;
    }

    // A point would stop on the plane and not in it; it needs no such test, since a plane holds
    // half of space.
    void to_plane(const typename World::Plane& plane, Scalar& free) const {
        const auto& particle = world.particles()[moving];
        const Scalar approach = -plane.along_normal(direction);
        if (!(approach > Scalar()) || !(particle.radius > Scalar())) return;
        const Scalar height =
            plane.along_normal(particle.position) - plane.offset - less_a_quarter(particle.radius);
        if (height < free * approach) shorten(free, height / approach);
    }

    // With d the offset from the other particle, the path passes it closest after b = -d .
    // direction, at the distance c = |d + b direction|, and touches it half a chord earlier. From
    // far away the rounding of the direction makes c uncertain: then the particle goes near and
    // looks again.
    void to_particle(Index other, Scalar& free) const {
        const auto& first = world.particles()[moving];
        const auto& second = world.particles()[other];
        const Scalar reach = less_a_quarter(first.radius + second.radius);
        auto offset = first.position - second.position;
        const Scalar closest = -dot(offset, direction);
        if (!(closest > Scalar()) || !(closest - reach < free)) return;
        const bool is_from_afar = closest * BinaryStep<5>() > reach;
        const Scalar bound = is_from_afar ? reach + closest * BinaryStep<7>() : reach;
        offset.add_scaled(direction, closest);
        for (unsigned char i = 0; i < World::dimensions; ++i) {
            if (!(absolute(offset[i]) < bound)) return;
        }
        const Scalar distance = length(offset);
        if (!(distance < bound)) return;
        // Two roots: the square of a large radius leaves a format where the product of the roots
        // does not.
        shorten(free, is_from_afar ? closest - reach - reach
                                   : closest - root(reach - distance) * root(reach + distance));
    }

    static void shorten(Scalar& free, Scalar to) {
        if (to < Scalar()) to = Scalar();
        if (to < free) free = to;
    }
    static Scalar less_a_quarter(Scalar a) { return a - a * BinaryStep<2>(); }
    static Scalar root(Scalar a) {
        using ::sqrt;
        return sqrt(a);
    }
};
/// \endcond

}  // namespace engine
