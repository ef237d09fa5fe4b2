// SPDX-License-Identifier: MIT
/// \file
/// World<Scalar, Uses>: particles, what acts between them, and the step. The scalar is any
/// fixed-point format, float, double or a wide type; Uses states what the scene uses (uses.hpp).
///
///     World<Q16_16, Pendulum> world;
///     world.gravity = {0_d, -9.81_d};
///     auto bob = world.add_particle(body);            // body.position, .velocity, .inverse_mass
///     world.add_anchored_rod(bob, {0_d, 0_d}, 1_d);   // to a fixed point, 1 m long
///     if (world.error() != Error::none) ...           // the first thing that went wrong
///     world.step(BinaryStep<10>());                   // 2^-10 s
///     world[bob].position
///
/// Handles stay valid as long as the world: nothing is moved or removed. Nothing allocates. SI
/// units.
#pragma once

#include <engine/choice.hpp>
#include <engine/constraints.hpp>
#include <engine/continuous.hpp>
#include <engine/error.hpp>
#include <engine/forces.hpp>
#include <engine/observe.hpp>
#include <engine/particle.hpp>
#include <engine/pool.hpp>
#include <engine/time_step.hpp>
#include <engine/uses.hpp>
#include <engine/validity.hpp>

namespace engine {

/// \cond internal
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
    Scalar restitution_ = Scalar(), restitution_threshold_ = Scalar();
};
/// \endcond

/// Says which particle of a World is meant. One that was not made by add_particle means none; those
/// of another type of world do not compile.
template <class World, class Index>
struct ParticleHandle {
    /// The index of the particle.
    Index index;
    /// Means no particle.
    constexpr ParticleHandle() : index(nothing<Index>()) {}
    /// Means the particle of that index.
    constexpr ParticleHandle(Index of_particle) : index(of_particle) {}
    /// Whether it means a particle.
    constexpr explicit operator bool() const { return index != nothing<Index>(); }
};

/// Particles, what acts between them, and the step. `gravity`, in m/s^2, is a member where the
/// scene uses it.
template <class ScalarType, class SceneUses>
class World : public Gravity<Vector<ScalarType, SceneUses::dimensions>, SceneUses::gravity>,
              Bounce<ScalarType, may_bounce<SceneUses>()>,
              LastReach<ScalarType, SceneUses::collisions> {
  public:
    /// The type of every number of the world.
    using Scalar = ScalarType;
    /// What the scene uses.
    using Uses = SceneUses;
    /// The integrator that the scene chose.
    using Integrator = typename Uses::Integrator;
    /// The solver that the scene chose.
    using Solver = typename Uses::Solver;
    /// The broad phase that the scene chose.
    using BroadPhase = typename Uses::BroadPhase;

    /// 2 or 3.
    static constexpr unsigned char dimensions = Uses::dimensions;
    /// How many particles there can be.
    static constexpr unsigned capacity = Uses::particles;
    /// Whether anything can bounce: contacts and ropes.
    static constexpr bool bounces = may_bounce<Uses>();
    /// Whether anything acts between two particles.
    static constexpr bool has_pairs =
        Uses::springs > 0 || Uses::rods > 0 || Uses::ropes > 0 || Uses::collisions;
    /// Whether there can be springs.
    static constexpr bool has_springs = Uses::springs > 0 || Uses::anchored_springs > 0;
    /// Whether particles accumulate forces.
    static constexpr bool has_forces =
        (has_springs && !Integrator::implicit_springs) || Uses::drags > 0 || Uses::custom_force;
    /// How many constraint rows there can be in a step; in more bits than an unsigned of the device
    /// has.
    static constexpr unsigned long max_rows =
        Solver::rows_per_rod * (0ul + Uses::rods + Uses::anchored_rods) + Uses::ropes +
        Uses::anchored_ropes + Uses::contacts;
    static_assert(Uses::radii || !Uses::continuous_contacts,
                  "continuous_contacts are of particles with radii.");
    static_assert(max_rows <= 65535,
                  "Rods, ropes and contacts make at most 65535 rows: Uses states more.");

    /// A vector of the world's dimensions.
    using Vector = engine::Vector<Scalar, dimensions>;
    /// What add_particle takes.
    using Body = engine::Body<Scalar, dimensions>;
    /// The type of a particle's index.
    using Index = typename CountTo<capacity>::Type;
    /// What add_particle returns.
    using Handle = ParticleHandle<World, Index>;
    /// What the world holds of a particle.
    using Particle = engine::Particle<Scalar, Uses, has_forces, Solver::needs_displacement>;
    /// \cond internal
    using Particles = Pool<Particle, Uses::particles>;
    using Ends = Between<Vector, Index>;
    using Anchor = Anchored<Vector, Index>;
    using Spring = engine::Spring<Scalar, Ends>;
    using AnchoredSpring = engine::Spring<Scalar, Anchor>;
    using Rod = engine::Rod<Scalar, Ends>;
    using AnchoredRod = engine::Rod<Scalar, Anchor>;
    using Rope = engine::Rope<Scalar, Ends>;
    using AnchoredRope = engine::Rope<Scalar, Anchor>;
    using Drag = engine::Drag<Scalar, Index>;
    using Plane = engine::Plane<Scalar, Vector>;
    static constexpr bool keeps_rows =
        keeps_rows_of(static_cast<const Solver*>(nullptr), max_rows == 1 && !bounces);
    using Row = typename Solver::template Row<World>;
    using Rows = Pool<Row, keeps_rows ? static_cast<unsigned>(max_rows) : 0>;
    using PairMemory = typename BroadPhase::template Memory<World>;
    using IntegratorMemory = typename Integrator::template Memory<World>;
    /// \endcond
    /// The scene's own force.
    using CustomForce = typename Uses::template CustomForce<World>;

    /// Adds a particle and returns its handle. What cannot be added leaves the world as it was,
    /// sets error() and returns a handle that is false; the other add_ functions return false. What
    /// the scene does not use of a body is ignored.
    Handle add_particle(const Body& body) {
        if (!is_finite(body.position) || !is_finite(body.velocity)) {
            return refuse(Error::not_finite);
        }
        if (!is_at_least_0(body.inverse_mass)) return refuse(Error::bad_mass);
        if (Uses::radii && !is_at_least_0(body.radius)) return refuse(Error::bad_radius);
        if (Uses::damping && !is_between_0_and_1(body.damping)) return refuse(Error::bad_damping);
        if (particles_.full()) return refuse(Error::pool_full);
        Particle& particle = particles_.append();
        particle.position = body.position;
        particle.velocity = body.velocity;
        particle.inverse_mass = body.inverse_mass;
        only_if<Uses::radii>(particle, [&](Particle& p) { radius_of(p) = body.radius; });
        only_if<Uses::damping>(particle, [&](Particle& p) { damping_of(p) = body.damping; });
        integrator_memory_.restart();
        return Handle(static_cast<Index>(particles_.size() - 1));
    }
    /// A spring between two particles: stiffness in N/m, damping in N s/m, length in m, none
    /// negative.
    bool add_spring(Handle a, Handle b, Scalar stiffness, Scalar damping, Scalar rest_length) {
        return add(springs_, {{a.index, b.index}, stiffness, damping, rest_length});
    }
    /// A spring between a particle and a fixed point: units as of add_spring.
    bool add_anchored_spring(Handle a, const Vector& anchor, Scalar stiffness, Scalar damping,
                             Scalar rest_length) {
        return add(anchored_springs_, {{a.index, anchor}, stiffness, damping, rest_length});
    }
    /// Holds two particles at a distance, in m, above 0.
    bool add_rod(Handle a, Handle b, Scalar length) {
        return add(rods_, {{a.index, b.index}, length, inverse_of(length)});
    }
    /// Holds a particle at a distance, in m, above 0, from a fixed point.
    bool add_anchored_rod(Handle a, const Vector& anchor, Scalar length) {
        return add(anchored_rods_, {{a.index, anchor}, length, inverse_of(length)});
    }
    /// Keeps two particles within a distance, in m, above 0; restitution, in 0..1, of the velocity
    /// at which it becomes taut.
    bool add_rope(Handle a, Handle b, Scalar length, Scalar restitution) {
        return add(ropes_, {{a.index, b.index}, length, restitution, inverse_of(length)});
    }
    /// Keeps a particle within a distance of a fixed point: units as of add_rope.
    bool add_anchored_rope(Handle a, const Vector& anchor, Scalar length, Scalar restitution) {
        return add(anchored_ropes_, {{a.index, anchor}, length, restitution, inverse_of(length)});
    }
    /// Slows a particle: linear in N s/m, quadratic in N s^2/m^2, none negative.
    bool add_drag(Handle a, Scalar linear, Scalar quadratic) {
        return add(drags_, {a.index, linear, quadratic});
    }
    /// Adds a solid plane: the half space of the points x with normal . x >= offset is free. The
    /// normal must be of length 1 (within 2^-9), as normalise() makes it.
    bool add_plane(const Vector& normal, Scalar offset, Scalar restitution) {
        return add(planes_, {normal, offset, restitution, axis_of(normal)});
    }

    /// Between steps: another length of a rod, a rope or a spring of this world, as in
    /// set_length(world.rods()[0], 0.3_d). It is refused as the add_ functions refuse it.
    template <class Link>
    bool set_length(const Link& link, Scalar length) {
        auto& pool = pool_of(link);
        if (&link < pool.begin() || !(&link < pool.end())) return fail(Error::no_such_link);
        if (!takes_length(link, length)) return fail(Error::bad_length);
        give_length(const_cast<Link&>(link), length);  // an element of this world, which may change
        integrator_memory_.restart();
        return true;
    }

    /// Of particles that meet: 0 (no bounce) to 1 (as fast as before). Anything else is refused: it
    /// sets error() and returns false.
    bool set_restitution(Scalar restitution) {
        if (!is_between_0_and_1(restitution)) return fail(Error::bad_restitution);
        this->restitution_ = restitution;
        return true;
    }
    /// In m/s: what meets no faster does not bounce. A negative one is refused, as above.
    bool set_restitution_threshold(Scalar threshold) {
        if (!is_at_least_0(threshold)) return fail(Error::bad_restitution);
        this->restitution_threshold_ = threshold;
        return true;
    }
    /// Of particles that meet, in 0..1.
    const Scalar& restitution() const { return this->restitution_; }
    /// In m/s: what meets no faster does not bounce.
    const Scalar& restitution_threshold() const { return this->restitution_threshold_; }

    /// The first error since the world was made or the error was cleared.
    Error error() const { return error_; }
    /// Forgets the error, so that the next one is seen.
    void clear_error() { error_ = Error::none; }

    /// Particles and the custom force may be changed between steps. What is written there is not
    /// checked. A handle of no particle is reported, and gives the first.
    Particle& operator[](Handle handle) { return particles()[known(handle)]; }
    /// The particle of a handle. A handle of no particle is reported, and gives the first.
    const Particle& operator[](Handle handle) const { return particles_[known(handle)]; }
    /// All particles, to be changed between steps. What is written there is not checked.
    Elements<Particle, Uses::particles>& particles() {
        integrator_memory_.restart();
        return particles_;
    }
    /// The scene's own force, to be changed between steps.
    CustomForce& custom_force() {
        integrator_memory_.restart();
        return custom_force_;
    }

    /// All particles, in the order in which they were added.
    const Elements<Particle, Uses::particles>& particles() const { return particles_; }
    /// Of their kind, in the order in which they were added.
    /// @{
    const Pool<Spring, Uses::springs>& springs() const { return springs_; }
    const Pool<AnchoredSpring, Uses::anchored_springs>& anchored_springs() const {
        return anchored_springs_;
    }
    const Pool<Rod, Uses::rods>& rods() const { return rods_; }
    const Pool<AnchoredRod, Uses::anchored_rods>& anchored_rods() const { return anchored_rods_; }
    const Pool<Rope, Uses::ropes>& ropes() const { return ropes_; }
    const Pool<AnchoredRope, Uses::anchored_ropes>& anchored_ropes() const {
        return anchored_ropes_;
    }
    const Pool<Drag, Uses::drags>& drags() const { return drags_; }
    const Pool<Plane, Uses::planes>& planes() const { return planes_; }
    /// @}
    /// The scene's own force.
    const CustomForce& custom_force() const { return custom_force_; }

    /// Moves the world on by a step of 2^-K s, or of another type of time steps.
    template <class TimeStep>
    typename OnlyIf<IsTimeStep<TimeStep>::value, void>::Type step(TimeStep dt) {
        Integrator::step(*this, dt);
    }
    /// Moves the world on by dt seconds, which must be positive; others are reported and do
    /// nothing.
    void step(Scalar dt) {
        if (!is_finite(dt) || !(dt > Scalar())) return report(Error::bad_time_step);
        Integrator::step(*this, dt);
    }

    // The parts of a step, for integrators, solvers and custom forces.

    /// The particles, to be changed by a step: the integrator is not told.
    Elements<Particle, Uses::particles>& step_particles() { return particles_; }

    /// The force of each particle anew.
    void accumulate_forces() {
        only_if<has_forces>(*this, [](World& world) {
            world.for_each_particle([](Particle& particle) { force_of(particle) = Vector(); });
            world.apply_springs(If<!Integrator::implicit_springs>());
            world.drags_.for_each(Apply{world});
            observe<Scalar>(Quantity::custom_force);
            world.custom_force_.apply(world);
        });
    }

    /// Velocities by forces and gravity.
    template <class TimeStep>
    void integrate_velocities(TimeStep dt) {
        observe<Scalar>(Quantity::velocity);
        if (!Uses::gravity && !has_forces) return;
        for_each_particle([&](Particle& particle) {
            if (!movable(particle)) return;
            Vector acceleration = this->fall();
            only_if<has_forces>(particle, [&](Particle& p) {
                acceleration.add_scaled(force_of(p), p.inverse_mass);
            });
            particle.accelerate(particle.velocity, acceleration, dt);
        });
    }

    /// Positions by velocities.
    template <class TimeStep>
    void integrate_positions(TimeStep dt) {
        observe<Scalar>(Quantity::position);
        integrate_positions(dt, If<Uses::continuous_contacts>());
    }

    /// Multiplies each velocity by its particle's damping factor.
    void damp() {
        observe<Scalar>(Quantity::damping);
        only_if<Uses::damping>(*this, [](World& world) {
            world.for_each_particle(
                [](Particle& particle) { particle.velocity *= damping_of(particle); });
        });
    }

    /// Finds the rows that bound velocities and positions in this step.
    template <class TimeStep>
    void collect_constraints(TimeStep dt) {
        rows_.clear();
        const Constrain<TimeStep> constrain_by = {*this, dt};
        anchored_rods_.for_each(constrain_by);
        rods_.for_each(constrain_by);
        anchored_ropes_.for_each(constrain_by);
        ropes_.for_each(constrain_by);
        planes_.for_each(ConstrainAll<TimeStep>{*this, dt});
        collide_all(dt, If<Uses::collisions>());
    }
    /// Another row, in which fill(row) writes; an error where the scene has not stated that many.
    template <class Function>
    ENGINE_INLINE void append_row(Function fill) {
        if (rows_.full()) {
            fail(Error::contacts_full);
        } else {
            fill(rows_.append());
        }
    }
    /// The constraint rows of this step; none of a single rod, which is solved where it is found.
    const Rows& rows() const { return rows_; }
    /// The constraint rows of this step, to be changed by a solver.
    Rows& step_rows() { return rows_; }
    /// Gives the particles velocities that the rows of this step allow.
    void solve_constraints() {
        observe<Scalar>(Quantity::resolution);
        solve(If<(keeps_rows && max_rows > 0)>());
    }

    /// The acceleration of a against b by gravity.
    Vector relative_gravity(Index a, Index b) const {
        Vector relative;
        only_if<Uses::gravity>(*this, [&](const World& world) {
            const bool falls = movable(world.particles_[a]);
            const bool other_falls = is_particle(*this, b) && movable(world.particles_[b]);
            if (falls && !other_falls) relative = world.fall();
            if (other_falls && !falls) relative = -world.fall();
        });
        return relative;
    }

    /// Sets error(), where it is none.
    void report(Error error) { fail(error); }

    /// \cond internal
    LastReach<Scalar, Uses::collisions>& last_reach() { return *this; }
    PairMemory& pair_memory() { return pair_memory_; }
    IntegratorMemory& integrator_memory() { return integrator_memory_; }
    /// \endcond

  private:
    // The parts of a step that a scene may do without: If<false> is the overload that does nothing,
    // and then the other one, which names what there is not, is not compiled.
    struct Apply {
        World& world;
        template <class Force>
        void operator()(const Force& force) const {
            apply(force, world);
        }
    };
    // How many particles a step looks at. Where there is one, it need not have been added: until
    // then its inverse mass is 0, unless somebody writes to it, and nothing moves it.
    constexpr Index count() const { return capacity == 1 ? 1 : particles_.size(); }
    template <class Function>
    ENGINE_INLINE void for_each_particle(Function function) {
        if (capacity == 1) {
            function(*particles_.begin());
        } else {
            particles_.for_each(function);
        }
    }
    void apply_springs(If<true>) {
        springs_.for_each(Apply{*this});
        anchored_springs_.for_each(Apply{*this});
    }
    void apply_springs(If<false>) {}

    template <class TimeStep>
    struct Constrain {
        World& world;
        const TimeStep& dt;
        template <class Link>
        void operator()(const Link& link) const {
            constrain(link, world, dt);
        }
    };
    template <class TimeStep>
    struct ConstrainAll {
        World& world;
        const TimeStep& dt;
        template <class Obstacle>
        void operator()(const Obstacle& obstacle) const {
            for (Index i = 0; i < world.count(); ++i) constrain(obstacle, i, world, dt);
        }
    };
    template <class TimeStep>
    void integrate_positions(TimeStep dt, If<true>) {
        for (Index i = 0; i < count(); ++i) {
            if (movable(particles_[i])) Flight<World>::move(*this, i, dt);
        }
    }
    template <class TimeStep>
    void integrate_positions(TimeStep dt, If<false>) {
        for_each_particle([&](Particle& particle) {
            if (!movable(particle)) return;
            particle.move(particle.position, particle.velocity, dt);
        });
    }
    template <class TimeStep>
    void collide_all(TimeStep dt, If<true>) {
        BroadPhase::collide_all(*this, dt);
    }
    template <class TimeStep>
    void collide_all(TimeStep, If<false>) {}
    void solve(If<true>) { Solver::solve(*this); }
    void solve(If<false>) {}

    __attribute__((cold)) inline bool fail(Error error) {
        if (error_ == Error::none) error_ = error;
        return false;
    }
    Handle refuse(Error error) {
        fail(error);
        // Else the caller's code would be compiled once more for this handle.
        return Handle(unknown(nothing<Index>()));
    }
    // The index that a handle means, and 0 where it means none.
    Index known(Handle handle) const {
        if (handle.index < particles_.size()) return handle.index;
        if (error_ == Error::none) error_ = Error::no_such_particle;
        return 0;
    }
    template <class Link, unsigned capacity>
    bool add(Pool<Link, capacity>& pool, const Link& link) {
        static_assert(capacity > 0, "The scene's Uses does not state this force or constraint.");
        const Error fault = fault_in(link, particles_.size());
        if (fault != Error::none) return fail(fault);
        if (pool.full()) return fail(Error::pool_full);
        pool.append(link);
        integrator_memory_.restart();
        return true;
    }

    Pool<Spring, Uses::springs>& pool_of(const Spring&) { return springs_; }
    Pool<AnchoredSpring, Uses::anchored_springs>& pool_of(const AnchoredSpring&) {
        return anchored_springs_;
    }
    Pool<Rod, Uses::rods>& pool_of(const Rod&) { return rods_; }
    Pool<AnchoredRod, Uses::anchored_rods>& pool_of(const AnchoredRod&) { return anchored_rods_; }
    Pool<Rope, Uses::ropes>& pool_of(const Rope&) { return ropes_; }
    Pool<AnchoredRope, Uses::anchored_ropes>& pool_of(const AnchoredRope&) {
        return anchored_ropes_;
    }

    Particles particles_;
    Pool<Spring, Uses::springs> springs_;
    Pool<AnchoredSpring, Uses::anchored_springs> anchored_springs_;
    Pool<Drag, Uses::drags> drags_;
    Pool<Rod, Uses::rods> rods_;
    Pool<AnchoredRod, Uses::anchored_rods> anchored_rods_;
    Pool<Rope, Uses::ropes> ropes_;
    Pool<AnchoredRope, Uses::anchored_ropes> anchored_ropes_;
    Pool<Plane, Uses::planes> planes_;
    Rows rows_;  // of the step under way
    PairMemory pair_memory_;
    IntegratorMemory integrator_memory_;
    CustomForce custom_force_;
    mutable Error error_ = Error::none;
};

}  // namespace engine
