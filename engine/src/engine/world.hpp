// SPDX-License-Identifier: MIT
// World<Scalar, Uses>: particles, what acts between them, and the step. The scalar is any
// fixed-point format, float, double or a wide type; Uses states what the scene uses (uses.hpp).
//
//     World<Q16_16, Pendulum> world;
//     world.gravity = {0_d, -9.81_d};
//     auto bob = world.add_particle(body);            // body.position, .velocity, .inverse_mass
//     world.add_anchored_rod(bob, {0_d, 0_d}, 1_d);   // to a fixed point, 1 m long
//     if (world.error() != Error::none) ...           // the first thing that went wrong
//     world.step(BinaryStep<10>());                   // 2^-10 s
//     world[bob].position
//
// Handles stay valid as long as the world: nothing is moved or removed. Nothing allocates. SI
// units.
#pragma once

#include <engine/choice.hpp>
#include <engine/constraints.hpp>
#include <engine/error.hpp>
#include <engine/forces.hpp>
#include <engine/observe.hpp>
#include <engine/particle.hpp>
#include <engine/pool.hpp>
#include <engine/time_step.hpp>
#include <engine/uses.hpp>

namespace engine {

// Members that a scene does not use take no room.
template <class Vector, bool used>
struct Gravity {
    constexpr Vector fall() const { return Vector(); }
};
template <class Vector>
struct Gravity<Vector, true> {
    Vector gravity;  // m/s^2, of every movable particle
    constexpr const Vector& fall() const { return gravity; }
};

template <class Scalar, bool used>
struct Bounce {};
template <class Scalar>
struct Bounce<Scalar, true> {
    Scalar restitution = Scalar();    // of particles that meet: 0 (none) to 1 (all)
    Scalar restitution_threshold = Scalar();  // m/s; what meets no faster does not bounce
};

template <class Index>
struct ParticleHandle {
    Index index;
    constexpr explicit operator bool() const { return index != nothing<Index>; }
};

template <class ScalarType, class SceneUses>
class World : public Gravity<Vector<ScalarType, SceneUses::dimensions>, SceneUses::gravity>,
              public Bounce<ScalarType, may_bounce<SceneUses>()> {
  public:
    using Scalar = ScalarType;
    using Uses = SceneUses;
    using Integrator = typename Uses::Integrator;
    using Solver = typename Uses::Solver;
    using BroadPhase = typename Uses::BroadPhase;

    static constexpr unsigned char dimensions = Uses::dimensions;
    static constexpr unsigned capacity = Uses::particles;
    static constexpr bool bounces = may_bounce<Uses>();
    static constexpr bool has_pairs =
        Uses::springs + Uses::rods + Uses::ropes > 0 || Uses::collisions;
    static constexpr bool has_springs = Uses::springs + Uses::anchored_springs > 0;
    static constexpr bool has_forces =
        (has_springs && !Integrator::implicit_springs) || Uses::drags > 0 || Uses::custom_force;
    static constexpr unsigned most_rows =
        Solver::rows_per_rod * (Uses::rods + Uses::anchored_rods) + Uses::ropes +
        Uses::anchored_ropes + Uses::contacts;

    using Vector = engine::Vector<Scalar, dimensions>;
    using Body = engine::Body<Scalar, dimensions>;
    using Index = typename Either<(capacity < 255), uint8_t, uint16_t>::Type;
    using Handle = ParticleHandle<Index>;
    using Particle = engine::Particle<Scalar, Uses, has_forces, Solver::needs_displacement>;
    using Ends = Between<Vector, Index>;
    using Anchor = Anchored<Vector, Index>;
    using Row = typename Solver::template Row<World>;
    using CustomForce = typename Uses::template CustomForce<World>;

    // Building. What cannot be added leaves the world as it was, sets error() and returns false;
    // of particles, a handle that is false.
    Handle add_particle(const Body& body) {
        if (body.inverse_mass < Scalar()) return refuse(Error::bad_mass);
        if (body.radius < Scalar()) return refuse(Error::bad_radius);
        if (particles_.full()) return refuse(Error::pool_full);
        Particle particle;
        particle.position = body.position;
        particle.velocity = body.velocity;
        particle.inverse_mass = body.inverse_mass;
        only_if<Uses::radii>(particle, [&](auto& p) { p.radius = body.radius; });
        only_if<Uses::damping>(particle, [&](auto& p) { p.damping = body.damping; });
        particles_.append(particle);
        return {static_cast<Index>(particles_.size() - 1)};
    }
    bool add_spring(Handle a, Handle b, Scalar stiffness, Scalar damping, Scalar rest_length) {
        return spring(springs_, Ends{a.index, b.index}, stiffness, damping, rest_length);
    }
    bool add_anchored_spring(Handle a, const Vector& anchor, Scalar stiffness, Scalar damping,
                             Scalar rest_length) {
        return spring(anchored_springs_, Anchor{a.index, anchor}, stiffness, damping, rest_length);
    }
    bool add_rod(Handle a, Handle b, Scalar length) {
        return limited(rods_, {{a.index, b.index}, length});
    }
    bool add_anchored_rod(Handle a, const Vector& anchor, Scalar length) {
        return limited(anchored_rods_, {{a.index, anchor}, length});
    }
    bool add_rope(Handle a, Handle b, Scalar length, Scalar restitution) {
        return limited(ropes_, {{a.index, b.index}, length, restitution});
    }
    bool add_anchored_rope(Handle a, const Vector& anchor, Scalar length, Scalar restitution) {
        return limited(anchored_ropes_, {{a.index, anchor}, length, restitution});
    }
    bool add_drag(Handle a, Scalar linear, Scalar quadratic) {
        if (linear < Scalar() || quadratic < Scalar()) return fail(Error::bad_stiffness);
        if (!(a.index < particles_.size())) return fail(Error::no_such_particle);
        return append_to(drags_, {a.index, linear, quadratic});
    }
    // The normal points out of the solid and is taken to have length 1.
    bool add_plane(const Vector& normal, Scalar offset, Scalar restitution) {
        if (normal == Vector()) return fail(Error::bad_normal);
        return append_to(planes_, {normal, offset, restitution});
    }

    // The first error since the world was made or the error was cleared.
    Error error() const { return error_; }
    void clear_error() { error_ = Error::none; }

    Particle& operator[](Handle handle) { return particles_[handle.index]; }
    const Particle& operator[](Handle handle) const { return particles_[handle.index]; }

    // For those who draw, or change lengths between steps. In the order in which they were added.
    auto& particles() { return particles_; }
    const auto& particles() const { return particles_; }
    auto& springs() { return springs_; }
    auto& anchored_springs() { return anchored_springs_; }
    auto& rods() { return rods_; }
    auto& anchored_rods() { return anchored_rods_; }
    auto& ropes() { return ropes_; }
    auto& anchored_ropes() { return anchored_ropes_; }
    auto& drags() { return drags_; }
    auto& planes() { return planes_; }
    auto& custom_force() { return custom_force_; }

    // Moves the world on by dt: a BinaryStep, or a Scalar in seconds.
    template <class TimeStep>
    void step(TimeStep dt) {
        Integrator::step(*this, dt);
    }

    // The parts of a step, for integrators and solvers.

    // The force of each particle anew.
    void accumulate_forces() {
        only_if<has_forces>(*this, [](auto& world) {
            world.particles_.for_each([](auto& particle) { particle.force = Vector(); });
            const auto apply_it = [&](const auto& each) { apply(each, world); };
            only_if<!Integrator::implicit_springs>(world, [&](auto& w) {
                w.springs_.for_each(apply_it);
                w.anchored_springs_.for_each(apply_it);
            });
            world.drags_.for_each(apply_it);
            observe<Scalar>(Quantity::custom_force);
            world.custom_force_.apply(world);
        });
    }

    // Velocities by forces and gravity.
    template <class TimeStep>
    void integrate_velocities(TimeStep dt) {
        observe<Scalar>(Quantity::velocity);
        only_if<Uses::gravity || has_forces>(particles_, [&](auto& particles) {
            particles.for_each([&](auto& particle) {
                if (!movable(particle)) return;
                Vector acceleration = this->fall();
                only_if<has_forces>(
                    particle, [&](auto& p) { acceleration.add_scaled(p.force, p.inverse_mass); });
                particle.accelerate(particle.velocity, acceleration, dt);
            });
        });
    }

    // Positions by velocities.
    template <class TimeStep>
    void integrate_positions(TimeStep dt) {
        observe<Scalar>(Quantity::position);
        particles_.for_each([&](auto& particle) {
            if (!movable(particle)) return;
            particle.move(particle.position, particle.velocity, dt);
        });
    }

    void damp() {
        observe<Scalar>(Quantity::damping);
        only_if<Uses::damping>(particles_, [](auto& particles) {
            particles.for_each([](auto& particle) { particle.velocity *= particle.damping; });
        });
    }

    // Finds the rows that bound velocities and positions in this step.
    template <class TimeStep>
    void collect_constraints(TimeStep dt) {
        rows_.clear();
        const auto constrain_by = [&](const auto& each) { constrain(each, *this, dt); };
        anchored_rods_.for_each(constrain_by);
        rods_.for_each(constrain_by);
        anchored_ropes_.for_each(constrain_by);
        ropes_.for_each(constrain_by);
        planes_.for_each([&](const auto& plane) {
            for (Index i = 0; i < particles_.size(); ++i) constrain(plane, i, *this, dt);
        });
        only_if<Uses::collisions>(*this, [&](auto& world) { BroadPhase::collide_all(world, dt); });
    }
    // Another row, in which fill(row) writes; an error where the scene has not stated that many.
    template <class Function>
    ENGINE_INLINE void append_row(Function fill) {
        if (rows_.full()) {
            fail(Error::contacts_full);
        } else {
            fill(rows_.append());
        }
    }
    const auto& rows() const { return rows_; }
    void solve_constraints() {
        observe<Scalar>(Quantity::resolution);
        only_if<(most_rows > 0)>(*this, [](auto& world) { Solver::solve(world); });
    }

    // The acceleration of a against b by gravity.
    Vector relative_gravity(Index a, Index b) const {
        Vector gravity;
        only_if<Uses::gravity>(*this, [&](auto& world) {
            const bool falls = movable(world.particles_[a]);
            const bool other_falls = is_particle(*this, b) && movable(world.particles_[b]);
            if (falls && !other_falls) gravity = world.fall();
            if (other_falls && !falls) gravity = -world.fall();
        });
        return gravity;
    }

    void report(Error error) { fail(error); }

    auto& pair_memory() { return pair_memory_; }
    auto& integrator() { return integrator_; }

  private:
    bool fail(Error error) {
        if (error_ == Error::none) error_ = error;
        return false;
    }
    Handle refuse(Error error) {
        fail(error);
        return {nothing<Index>};
    }
    template <class T, unsigned size>
    bool append_to(Pool<T, size, Index>& pool, const T& element) {
        static_assert(size > 0, "The scene's Uses does not state this force or constraint.");
        if (pool.full()) return fail(Error::pool_full);
        pool.append(element);
        return true;
    }
    bool known(const Ends& ends) {
        if (ends.a < particles_.size() && ends.b < particles_.size()) {
            return ends.a != ends.b || fail(Error::same_particle);
        }
        return fail(Error::no_such_particle);
    }
    bool known(const Anchor& anchor) {
        return anchor.a < particles_.size() || fail(Error::no_such_particle);
    }
    template <class Pool, class E>
    bool spring(Pool& pool, const E& ends, Scalar stiffness, Scalar damping, Scalar rest_length) {
        if (stiffness < Scalar() || damping < Scalar()) return fail(Error::bad_stiffness);
        if (rest_length < Scalar()) return fail(Error::bad_length);
        return known(ends) && append_to(pool, {ends, stiffness, damping, rest_length});
    }
    template <class T, unsigned size>
    bool limited(Pool<T, size, Index>& pool, const T& link) {
        if (!(link.length > Scalar())) return fail(Error::bad_length);
        return known(link.ends) && append_to(pool, link);
    }

    Pool<Particle, Uses::particles, Index> particles_;
    Pool<Spring<Scalar, Ends>, Uses::springs, Index> springs_;
    Pool<Spring<Scalar, Anchor>, Uses::anchored_springs, Index> anchored_springs_;
    Pool<Drag<Scalar, Index>, Uses::drags, Index> drags_;
    Pool<Rod<Scalar, Ends>, Uses::rods, Index> rods_;
    Pool<Rod<Scalar, Anchor>, Uses::anchored_rods, Index> anchored_rods_;
    Pool<Rope<Scalar, Ends>, Uses::ropes, Index> ropes_;
    Pool<Rope<Scalar, Anchor>, Uses::anchored_ropes, Index> anchored_ropes_;
    Pool<Plane<Scalar, Vector>, Uses::planes, Index> planes_;
    Pool<Row, most_rows, Index> rows_;  // of the step under way
    typename BroadPhase::template Memory<World> pair_memory_;
    typename Integrator::template Memory<World> integrator_;
    CustomForce custom_force_;
    Error error_ = Error::none;
};

}  // namespace engine
