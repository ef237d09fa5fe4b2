// SPDX-License-Identifier: MIT
/// \file
/// WorstFirst<max_iterations>: the solver of the published design, kept as the baseline. Each
/// iteration computes every contact's separating velocity and penetration again (the penetration as
/// found, less the displacement of its particles since). The contact that closes fastest receives
/// an impulse by its restitution, and a correction of positions in proportion to inverse mass. The
/// solver stops when no contact closes or overlaps. A rod is a pair of opposed contacts where its
/// length is off, since later corrections may change which side is wrong. A rope is one contact
/// where it is taut.
#pragma once

#include <engine/decimal.hpp>
#include <engine/links.hpp>

namespace engine {

/// The published solver: solves at most max_iterations contacts in a step, the fastest closing
/// first.
template <unsigned char max_iterations>
struct WorstFirst {
    /// \cond internal
    static constexpr bool keeps_way_back = true;
    static constexpr unsigned rows_per_rod = 2;

    template <class World>
    struct Row {
        using Scalar = typename World::Scalar;
        typename World::Index a = {}, b = {};  // b may be nothing
        typename World::Vector normal;         // from b to a
        Scalar penetration = Scalar();         // when the contact was found
        Scalar restitution = Scalar();
    };

    template <class World, class Index, class Vector, class Scalar, class TimeStep>
    static void rod(World& world, Index a, Index b, const Vector& direction, Scalar excess,
                    const Inverse<Scalar>&, TimeStep) {
        if (excess == Scalar()) return;
        append(world, a, b, direction, -excess, Scalar());
        append(world, a, b, -direction, excess, Scalar());
    }

    template <class World, class Index, class Vector, class Scalar, class TimeStep>
    static void rope(World& world, Index a, Index b, const Vector& direction, Scalar excess,
                     const Inverse<Scalar>&, Scalar restitution, TimeStep) {
        append(world, a, b, -direction, excess, restitution);
    }

    template <class World, class Index, class Vector, class Scalar, class TimeStep>
    static void contact(World& world, Index a, Index b, const Vector& normal, Scalar penetration,
                        Scalar restitution, TimeStep) {
        append(world, a, b, normal, penetration, restitution);
    }

    template <class World>
    static void solve(World& world) {
        using Scalar = typename World::Scalar;
        // A contact that rounding leaves open by a few ulp would use up all iterations.
        const Scalar closing_epsilon = Decimal<1, 2>();  // m/s
        const Scalar slop = Decimal<1, 4>();             // m
        if (world.rows().size() == 0) return;
        for (auto& particle : world.step_particles()) particle.way_back = {};
        for (unsigned char i = 0; i < max_iterations; ++i) {
            const Row<World>* worst = nullptr;
            Scalar worst_velocity = Scalar();
            Scalar worst_penetration = Scalar();
            for (const auto& row : world.rows()) {
                const Scalar velocity = velocity_along(world, row.a, row.b, row.normal);
                Scalar penetration = row.penetration;
                if (i > 0) penetration -= moved_along(world, row.a, row.b, row.normal);
                if (!(velocity < -closing_epsilon) && !(penetration > slop)) continue;
                if (worst == nullptr || velocity < worst_velocity) {
                    worst = &row;
                    worst_velocity = velocity;
                    worst_penetration = penetration;
                }
            }
            if (worst == nullptr) return;
            push(world, *worst, worst_velocity, worst_penetration);
        }
    }
    /// \endcond

  private:
    // How far a has moved away from b along a direction.
    template <class World, class Index, class Vector>
    static ENGINE_INLINE typename World::Scalar moved_along(const World& world, Index a, Index b,
                                                            const Vector& direction) {
        const Vector& way_back = world.particles()[a].way_back;
        if (!is_particle(world, b)) return dot(direction, -way_back);
        return dot_difference(direction, world.particles()[b].way_back, way_back);
    }

    template <class World, class Index, class Vector, class Scalar>
    static void append(World& world, Index a, Index b, const Vector& normal, Scalar penetration,
                       Scalar restitution) {
        world.append_row([&](Row<World>& row) ENGINE_INLINE_LAMBDA {
            row.a = a;
            row.b = b;
            row.normal = normal;
            row.penetration = penetration;
            row.restitution = restitution;
        });
    }

    template <class World, class Scalar>
    static void push(World& world, const Row<World>& row, Scalar velocity, Scalar penetration) {
        auto& a = world.step_particles()[row.a];
        auto* b = is_particle(world, row.b) ? &world.step_particles()[row.b] : nullptr;
        const Scalar total = b == nullptr ? a.inverse_mass : a.inverse_mass + b->inverse_mass;
        if (!(total > Scalar())) return;
        if (velocity < Scalar()) {
            const Scalar impulse = (-row.restitution * velocity - velocity) / total;
            a.velocity.add_scaled(row.normal, impulse * a.inverse_mass);
            if (b != nullptr) b->velocity -= row.normal * (impulse * b->inverse_mass);
        }
        if (penetration > Scalar()) {
            const Scalar part = penetration / total;
            exchange(a.position, a.way_back, row.normal, part * a.inverse_mass);
            if (b != nullptr) {
                exchange(b->way_back, b->position, row.normal, part * b->inverse_mass);
            }
        }
    }
};

}  // namespace engine
