// SPDX-License-Identifier: MIT
// Sweeps<most>: the resolver of choice. Positions are put right once, where a contact is found;
// velocities in at most `most` sweeps over all rows, which end when a sweep changes nothing.
//
// A rod is one two-sided row. Its end moves along the chord of its arc, not the tangent: the
// velocity along the rod becomes -h w^2 / 2L (w the relative velocity, h the step), which keeps the
// speed to second order where a velocity of 0 would lose it to first.
//
// A bounce began where the surfaces met, a time t = penetration / closing velocity ago: the
// particle is put where it would be by now, restitution x penetration beyond the surface, and has
// the velocity that gravity gave it since. At most `rest_velocity` fast, it does not bounce.
#pragma once

#include <engine/choice.hpp>
#include <engine/parting.hpp>
#include <engine/time_step.hpp>

namespace engine {

template <unsigned char most>
struct Sweeps {
    static constexpr bool needs_displacement = false;
    static constexpr unsigned rows_per_rod = 1;

    template <class World>
    struct Row {
        using Scalar = typename World::Scalar;
        typename World::Index a, b;  // b may be nothing
        bool two_sided;
        typename World::Vector normal;  // from b to a
        Scalar target;                  // velocity of a against b along the normal
        Scalar restitution;             // of closing velocities, where not two-sided
        Scalar share;                   // a's part of each correction, b's being the rest
    };

    template <class World, class Index, class Vector, class Scalar, class TimeStep>
    static void rod(World& world, Index a, Index b, const Vector& direction, Scalar excess,
                    Scalar length, TimeStep dt) {
        const Scalar share = share_of(world, a, b);
        displace(world, a, b, direction, -excess, share);
        world.append(
            {a, b, true, direction, -chord_velocity(world, a, b, length, dt), Scalar(), share});
    }

    template <class World, class Index, class Vector, class Scalar, class TimeStep>
    static void rope(World& world, Index a, Index b, const Vector& direction, Scalar excess,
                     Scalar length, Scalar restitution, TimeStep dt) {
        const Scalar share = share_of(world, a, b);
        displace(world, a, b, direction, -excess, share);
        world.append(
            {a, b, false, -direction, chord_velocity(world, a, b, length, dt), restitution, share});
    }

    template <class World, class Index, class Vector, class Scalar, class TimeStep>
    static void contact(World& world, Index a, Index b, const Vector& normal, Scalar penetration,
                        Scalar restitution, TimeStep dt) {
        const Scalar share = share_of(world, a, b);
        const Scalar closing = -dot(relative_velocity(world, a, b), normal);
        Scalar target = Scalar();
        Scalar correction = penetration;
        if (closing > world.rest_velocity) {
            correction = product_plus(restitution, penetration, penetration);
            target = dot(world.relative_gravity(a, b), normal) *
                     (penetration / closing + seconds<Scalar>(half(dt)));
            target = product_plus(restitution, target, target);
        }
        displace(world, a, b, normal, correction, share);
        world.append({a, b, false, normal, target, restitution, share});
    }

    template <class World>
    static void resolve(World& world) {
        for (unsigned char sweep = 0; sweep < most; ++sweep) {
            bool changed = false;
            for (const auto& row : world.rows()) {
                if (solve(world, row)) changed = true;
            }
            if (!changed || world.rows().size() == 1) break;
        }
    }

  private:
    // Gives the two of a row the velocity that it asks for; whether that changed anything.
    template <class World, class Row>
    static bool solve(World& world, const Row& row) {
        using Scalar = typename World::Scalar;
        const Scalar velocity = dot(relative_velocity(world, row.a, row.b), row.normal);
        Scalar goal = row.target;
        bool pushes = true;
        only_if<World::bounces>(world, [&](auto& w) {
            if (!row.two_sided) pushes = bounce(w.rest_velocity, velocity, row.restitution, goal);
        });
        if (!pushes) return false;
        const Scalar change = goal - velocity;
        if (change == Scalar()) return false;
        part(world, row.a, row.b, row.normal, change, row.share, VelocityOf());
        return true;
    }

    // Of a row that only pushes: whether it does, and to what velocity.
    template <class Scalar>
    static bool bounce(Scalar rest_velocity, Scalar velocity, Scalar restitution, Scalar& goal) {
        if (!(velocity < Scalar()) && !(velocity < goal)) return false;
        if (-velocity > rest_velocity) {
            goal = product_plus(restitution, -velocity, goal);
        } else if (goal < Scalar()) {
            goal = Scalar();
        }
        return true;
    }

    template <class World, class Index, class Vector, class Scalar>
    static void displace(World& world, Index a, Index b, const Vector& direction, Scalar distance,
                         Scalar share) {
        if (distance == Scalar()) return;
        part(world, a, b, direction, distance, share, PositionOf());
    }

    // h w^2 / 2L, by way of the way that w makes in half a step: that stays in range where w^2
    // does not.
    template <class World, class Index, class Scalar, class TimeStep>
    static Scalar chord_velocity(const World& world, Index a, Index b, Scalar length, TimeStep dt) {
        const auto velocity = relative_velocity(world, a, b);
        auto way = velocity;
        way *= half(dt);
        return dot(way, velocity) / length;
    }
};

}  // namespace engine
