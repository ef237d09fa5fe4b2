// SPDX-License-Identifier: MIT
/// \file
/// ProjectedGaussSeidel<max_iterations>: the default solver. Positions are corrected once, where a
/// constraint is found. Velocities are corrected row by row, in at most `max_iterations` iterations
/// over all rows, which end when one changes nothing. A single row is solved once.
///
/// A rod is one two-sided row. Its end moves along the chord of its arc, not the tangent: the
/// velocity along the rod becomes -h w^2 / 2L (w is the relative velocity, h the step, L the
/// length), which conserves the speed to second order. A velocity of 0 would conserve it to first
/// order only.
///
/// A bounce began when the surfaces met, a time t = penetration / closing velocity ago. The
/// particle is placed where it would be by now, restitution * penetration beyond the surface, and
/// receives the velocity that gravity has given it since. A particle that closes no faster than the
/// restitution threshold does not bounce.
#pragma once

#include <engine/choice.hpp>
#include <engine/shared_change.hpp>
#include <engine/time_step.hpp>

namespace engine {

/// \cond internal
// The part of a row that only scenes with contacts or ropes need: their rows only push.
template <class Scalar, bool used>
struct Pushing {
    FIXEDPOINT_CONSTEXPR void set_pushing(bool, Scalar) {}
    constexpr bool only_pushes() const { return false; }
    template <class World>
    constexpr bool bounces(const World&, Scalar) const {
        return false;
    }
    template <class World>
    static FIXEDPOINT_CONSTEXPR bool acts(const World&, Scalar, Scalar&) {
        return true;
    }
};
template <class Scalar>
struct Pushing<Scalar, true> {
    bool pushes_only = {};
    Scalar restitution = {};  // of closing velocities

    FIXEDPOINT_CONSTEXPR void set_pushing(bool pushes, Scalar of_closing_velocities) {
        pushes_only = pushes;
        restitution = of_closing_velocities;
    }
    constexpr bool only_pushes() const { return pushes_only; }
    // Whether a row that closes at the velocity bounces.
    template <class World>
    constexpr bool bounces(const World& world, Scalar velocity) const {
        return pushes_only && -velocity > world.restitution_threshold() && restitution > Scalar();
    }
    // Whether the row acts on a velocity; `goal` becomes the velocity that it requires.
    template <class World>
    FIXEDPOINT_CONSTEXPR bool acts(const World& world, Scalar velocity, Scalar& goal) const {
        if (!pushes_only) return true;
        if (!(velocity < Scalar()) && !(velocity < goal)) return false;
        if (-velocity > world.restitution_threshold()) {
            goal = engine::multiply_add(restitution, -velocity, goal);
        } else if (goal < Scalar()) {
            goal = Scalar();
        }
        return true;
    }
};

// The part of a row that is needed only where two particles share a correction.
template <class Scalar, bool used>
struct Sharing {
    FIXEDPOINT_CONSTEXPR void set_share(Scalar) {}
    constexpr Scalar share() const { return Scalar(); }
};
template <class Scalar>
struct Sharing<Scalar, true> {
    FIXEDPOINT_CONSTEXPR void set_share(Scalar share) { share_ = share; }
    constexpr Scalar share() const { return share_; }

  private:
    Scalar share_ = Scalar();  // a's part of each correction; b takes the rest
};

// Whether a world with that solver stores the rows of a step. A single rod is solved where it is
// found.
template <class Solver>
constexpr bool keeps_rows_of(const Solver*, bool) {
    return true;
}
template <unsigned char max_iterations>
struct ProjectedGaussSeidel;
template <unsigned char max_iterations>
constexpr bool keeps_rows_of(const ProjectedGaussSeidel<max_iterations>*, bool is_single_rod) {
    return !is_single_rod;
}
/// \endcond

/// The default solver: at most max_iterations iterations over all constraint rows in a step.
template <unsigned char max_iterations>
struct ProjectedGaussSeidel {
    /// \cond internal
    static constexpr bool keeps_way_back = false;
    static constexpr unsigned rows_per_rod = 1;

    template <class World>
    struct Row : Pushing<typename World::Scalar, World::bounces>,
                 Sharing<typename World::Scalar, World::has_pairs> {
        typename World::Index a = {}, b = {};  // b may be nothing
        typename World::Vector normal;         // from b to a
        typename World::Scalar target = {};    // velocity of a against b along the normal
    };

    template <class World, class Index, class Vector, class Scalar, class TimeStep>
    static void rod(World& world, Index a, Index b, const Vector& direction, Scalar excess,
                    const Inverse<Scalar>& inverse, TimeStep dt) {
        bind(world, a, b, false, direction, -excess, -chord_velocity(world, a, b, inverse, dt),
             Scalar());
    }

    template <class World, class Index, class Vector, class Scalar, class TimeStep>
    static void rope(World& world, Index a, Index b, const Vector& direction, Scalar excess,
                     const Inverse<Scalar>& inverse, Scalar restitution, TimeStep dt) {
        bind(world, a, b, true, -direction, excess, chord_velocity(world, a, b, inverse, dt),
             restitution);
    }

    template <class World, class Index, class Vector, class Scalar, class TimeStep>
    static void contact(World& world, Index a, Index b, const Vector& normal, Scalar penetration,
                        Scalar restitution, TimeStep dt) {
        const Scalar closing = -velocity_along(world, a, b, normal);
        Scalar target = Scalar();
        Scalar correction = penetration;
        if (closing > world.restitution_threshold()) {
            correction = engine::multiply_add(restitution, penetration, penetration);
            const Scalar pull =
                World::Uses::gravity ? dot(world.relative_gravity(a, b), normal) : Scalar();
            if (!(pull == Scalar())) {
                target = pull * (brief_quotient(penetration, closing) + seconds<Scalar>(half(dt)));
                target = engine::multiply_add(restitution, target, target);
            }
        }
        bind(world, a, b, true, normal, correction, target, restitution);
    }

    template <class World>
    static void solve(World& world) {
        for (unsigned char i = 0; i < max_iterations; ++i) {
            bool changed = false;
            world.rows().for_each(SolveRow<World>{world, changed});
            if (!changed || World::max_rows == 1 || world.rows().size() == 1) break;
        }
    }

  protected:
    // Appends the row that constrains the velocities of a and b, and moves a relative to b by
    // `correction` immediately. Does nothing if neither can move; if there is no room for the row,
    // sets error().
    template <class World, class Index, class Vector, class Scalar>
    static void bind(World& world, Index a, Index b, bool pushes_only, const Vector& normal,
                     Scalar correction, Scalar target, Scalar restitution) {
        if (!either_moves(world, a, b)) return;
        const Scalar share = mass_share(world, a, b);
        bind(world, a, b, pushes_only, normal, correction, target, restitution, share,
             If<World::keeps_rows>());
    }
    /// \endcond

  private:
    template <class World, class Index, class Vector, class Scalar>
    static ENGINE_INLINE void bind(World& world, Index a, Index b, bool pushes_only,
                                   const Vector& normal, Scalar correction, Scalar target,
                                   Scalar restitution, Scalar share, If<true>) {
        world.append_row([&](Row<World>& row) ENGINE_INLINE_LAMBDA {
            row.a = a;
            row.b = b;
            row.normal = normal;
            row.target = target;
            row.set_share(share);
            row.set_pushing(pushes_only, restitution);
            if (correction == Scalar()) return;
            apply_shared(world, a, b, row.normal, correction, share, &World::Particle::position);
        });
    }
    template <class World>
    struct SingleRow : Pushing<typename World::Scalar, false> {
        using Index = typename World::Index;
        using Vector = typename World::Vector;
        using Scalar = typename World::Scalar;
        const Index a, b;
        const Vector& normal;
        const Scalar target, share_;
        SingleRow(Index first, Index second, const Vector& from_b_to_a, Scalar velocity,
                  Scalar of_a)
            : a(first), b(second), normal(from_b_to_a), target(velocity), share_(of_a) {}
        constexpr Scalar share() const { return share_; }
    };
    template <class World, class Index, class Vector, class Scalar>
    static void bind(World& world, Index a, Index b, bool, const Vector& normal, Scalar correction,
                     Scalar target, Scalar, Scalar share, If<false>) {
        if (!(correction == Scalar())) {
            apply_shared(world, a, b, normal, correction, share, &World::Particle::position);
        }
        solve_row(world, SingleRow<World>(a, b, normal, target, share));
    }
    template <class World>
    struct SolveRow {
        World& world;
        bool& changed;
        template <class Row>
        void operator()(const Row& row) const {
            if (solve_row(world, row)) changed = true;
        }
    };

    // Gives the ends of a row the velocity that it requires. Returns whether that changed anything.
    template <class World, class Row>
    static bool solve_row(World& world, const Row& row) {
        using Scalar = typename World::Scalar;
        auto& of_a = world.step_particles()[row.a].velocity;
        auto* const of_b =
            is_particle(world, row.b) ? &world.step_particles()[row.b].velocity : nullptr;
        const Scalar velocity =
            of_b == nullptr ? dot(row.normal, of_a) : dot_difference(row.normal, of_a, *of_b);
        Scalar goal = row.target;
        if (!row.acts(world, velocity, goal)) return false;
        const Scalar change = goal - velocity;
        if (change == Scalar()) return false;
        return apply_shared(of_a, of_b, row.normal, change, row.share());
    }

    // h w^2 / 2L, where w is the velocity of a relative to b.
    template <class World, class Index, class Scalar, class TimeStep>
    static Scalar chord_velocity(const World& world, Index a, Index b,
                                 const Inverse<Scalar>& of_length, TimeStep dt) {
        const auto& velocity = world.particles()[a].velocity;
        if (!is_particle(world, b)) return chord_velocity(velocity, of_length, dt);
        return chord_velocity(velocity - world.particles()[b].velocity, of_length, dt);
    }
    // Through the half-step displacement, which stays in range where w^2 does not.
    template <class Vector, class Scalar, class TimeStep>
    static Scalar chord_velocity(const Vector& velocity, const Inverse<Scalar>& of_length,
                                 TimeStep dt) {
        Vector displacement(velocity);
        displacement *= half(dt);
        return times(dot(displacement, velocity), of_length);
    }
};

}  // namespace engine
