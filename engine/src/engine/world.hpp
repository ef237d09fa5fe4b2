// SPDX-License-Identifier: MIT
/// \file
/// World<Scalar, Uses>: particles, the forces and constraints on them, and the step. The scalar is
/// any fixed-point format, float, double or a wide type; Uses states what the scene uses
/// (uses.hpp).
///
///     World<Q16_16, Pendulum> world;
///     world.gravity = {0_d, -9.81_d};
///     auto bob = world.add_particle(body);            // body.position, .velocity, .inverse_mass
///     world.add_anchored_rod(bob, {0_d, 0_d}, 1_d);   // to a fixed point, 1 m long
///     if (world.error() != Error::none) ...           // the first thing that went wrong
///     world.step(BinaryStep<10>());                   // 2^-10 s
///     world[bob].position
///
/// Handles stay valid as long as the world: nothing is moved or removed. Nothing allocates. All
/// units are SI.
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

/// Names one particle of a World. A default-constructed handle names none. The handle of another
/// type of world does not compile.
template <class World, class Index>
struct ParticleHandle {
    /// The index of the particle.
    Index index;
    /// Names no particle.
    constexpr ParticleHandle() : index(nothing<Index>()) {}
    /// Names the particle of that index.
    constexpr ParticleHandle(Index of_particle) : index(of_particle) {}
    /// Whether it names a particle. Does not check that the particle has been added.
    constexpr explicit operator bool() const { return index != nothing<Index>(); }
};

/// Particles, the forces and constraints on them, and the step. A world has the member `gravity`,
/// in m/s^2, if the scene uses gravity.
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
    /// The largest number of particles.
    static constexpr unsigned capacity = Uses::particles;
    /// Whether anything can bounce: the scene has contacts or ropes.
    static constexpr bool bounces = may_bounce<Uses>();
    /// Whether anything acts between two particles.
    static constexpr bool has_pairs =
        Uses::springs > 0 || Uses::rods > 0 || Uses::ropes > 0 || Uses::collisions;
    /// Whether there can be springs.
    static constexpr bool has_springs = Uses::springs > 0 || Uses::anchored_springs > 0;
    /// Whether particles accumulate forces.
    static constexpr bool has_forces =
        (has_springs && !Integrator::implicit_springs) || Uses::drags > 0 || Uses::custom_force;
    /// The largest number of constraint rows in a step, in a type wider than the device's unsigned,
    /// which it could overflow.
    static constexpr unsigned long max_rows =
        Solver::rows_per_rod * (0ul + Uses::rods + Uses::anchored_rods) + Uses::ropes +
        Uses::anchored_ropes + Uses::contacts;
    static_assert(Uses::radii || !Uses::continuous_contacts, "continuous_contacts need radii.");
    static_assert(max_rows <= 65535,
                  "Rods, ropes and contacts make at most 65535 rows, but Uses states more.");

    /// A vector of the world's dimensions.
    using Vector = engine::Vector<Scalar, dimensions>;
    /// What add_particle takes.
    using Body = engine::Body<Scalar, dimensions>;
    /// The type of a particle's index.
    using Index = typename CountTo<capacity>::Type;
    /// What add_particle returns.
    using Handle = ParticleHandle<World, Index>;
    /// What the world stores for a particle.
    using Particle = engine::Particle<Scalar, Uses, has_forces, Solver::keeps_way_back>;
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

    /// Adds a particle and returns its handle. The inverse mass must be at least 0, the radius at
    /// least 0, the damping in 0..1, and all numbers finite. A member of the body that the scene
    /// does not use is ignored. If an add_ function refuses its arguments or its pool is full, it
    /// sets error() and leaves the world as it was; add_particle then returns a handle that
    /// converts to false, the others return false.
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
    /// Adds a spring between two different particles. Stiffness (N/m), damping (N s/m) and rest
    /// length (m) must be at least 0.
    bool add_spring(Handle a, Handle b, Scalar stiffness, Scalar damping, Scalar rest_length) {
        return add(springs_, {{a.index, b.index}, stiffness, damping, rest_length});
    }
    /// Adds a spring between a particle and a fixed point. Units and ranges are those of
    /// add_spring.
    bool add_anchored_spring(Handle a, const Vector& anchor, Scalar stiffness, Scalar damping,
                             Scalar rest_length) {
        return add(anchored_springs_, {{a.index, anchor}, stiffness, damping, rest_length});
    }
    /// Holds two different particles at a distance in m, which must be above 0, as must its
    /// inverse, rounded to the format.
    bool add_rod(Handle a, Handle b, Scalar length) {
        return add(rods_, {{a.index, b.index}, length, inverse_of(length)});
    }
    /// Holds a particle at a distance in m from a fixed point. The range is that of add_rod.
    bool add_anchored_rod(Handle a, const Vector& anchor, Scalar length) {
        return add(anchored_rods_, {{a.index, anchor}, length, inverse_of(length)});
    }
    /// Keeps two different particles within a distance in m; its range is that of add_rod. When the
    /// rope becomes taut, the particles rebound with `restitution` (0..1) times the velocity at
    /// which they separated.
    bool add_rope(Handle a, Handle b, Scalar length, Scalar restitution) {
        return add(ropes_, {{a.index, b.index}, length, restitution, inverse_of(length)});
    }
    /// Keeps a particle within a distance of a fixed point. Units and ranges are those of add_rope.
    bool add_anchored_rope(Handle a, const Vector& anchor, Scalar length, Scalar restitution) {
        return add(anchored_ropes_, {{a.index, anchor}, length, restitution, inverse_of(length)});
    }
    /// Slows a particle by linear (N s/m) and quadratic (N s^2/m^2) drag. Both must be at least 0.
    bool add_drag(Handle a, Scalar linear, Scalar quadratic) {
        return add(drags_, {a.index, linear, quadratic});
    }
    /// Adds a solid plane: the half space of the points x with normal . x >= offset (m) is free.
    /// The normal must have length 1 within 2^-9, as normalise() returns it, and the restitution
    /// must be in 0..1.
    bool add_plane(const Vector& normal, Scalar offset, Scalar restitution) {
        return add(planes_, {normal, offset, restitution, axis_of(normal)});
    }

    /// Changes the length of a rod, rope or spring of this world between steps, as in
    /// set_length(world.rods()[0], 0.3_d). The range is that of the add_ functions. A length out of
    /// range, or a link of another world, sets error(), changes nothing and returns false.
    template <class Link>
    bool set_length(const Link& link, Scalar length) {
        auto& pool = pool_of(link);
        if (&link < pool.begin() || !(&link < pool.end())) return fail(Error::no_such_link);
        if (!takes_length(link, length)) return fail(Error::bad_length);
        give_length(const_cast<Link&>(link), length);  // this world owns it, and is not const
        integrator_memory_.restart();
        return true;
    }

    /// Sets the restitution of particles that meet: from 0 (no bounce) to 1 (as fast as before).
    /// Any other value sets error(), changes nothing and returns false.
    bool set_restitution(Scalar restitution) {
        if (!is_between_0_and_1(restitution)) return fail(Error::bad_restitution);
        this->restitution_ = restitution;
        return true;
    }
    /// Sets the threshold in m/s: particles that meet no faster than this do not bounce. A negative
    /// value sets error(), changes nothing and returns false.
    bool set_restitution_threshold(Scalar threshold) {
        if (!is_at_least_0(threshold)) return fail(Error::bad_restitution);
        this->restitution_threshold_ = threshold;
        return true;
    }
    /// The restitution of particles that meet, in 0..1.
    const Scalar& restitution() const { return this->restitution_; }
    /// The threshold in m/s: particles that meet no faster than this do not bounce.
    const Scalar& restitution_threshold() const { return this->restitution_threshold_; }

    /// The first error since the world was made or since clear_error().
    Error error() const { return error_; }
    /// Forgets the error, so that the next one is kept.
    void clear_error() { error_ = Error::none; }

    /// The particle of a handle, which may be changed between steps. What is written there is not
    /// checked. A handle that names no particle sets error(), and the result is the first particle.
    Particle& operator[](Handle handle) { return particles()[known(handle)]; }
    /// The particle of a handle. A handle that names no particle sets error(), and the result is
    /// the first particle.
    const Particle& operator[](Handle handle) const { return particles_[known(handle)]; }
    /// All particles, which may be changed between steps. What is written there is not checked.
    Elements<Particle, Uses::particles>& particles() {
        integrator_memory_.restart();
        return particles_;
    }
    /// The scene's own force, which may be changed between steps.
    CustomForce& custom_force() {
        integrator_memory_.restart();
        return custom_force_;
    }

    /// All particles, in the order in which they were added.
    const Elements<Particle, Uses::particles>& particles() const { return particles_; }
    /// All links, drags and planes of one kind, in the order in which they were added.
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

    /// Advances the world by a step of 2^-K s, or of another type for which IsTimeStep is true.
    template <class TimeStep>
    typename OnlyIf<IsTimeStep<TimeStep>::value, void>::Type step(TimeStep dt) {
        Integrator::step(*this, dt);
    }
    /// Advances the world by dt seconds. `dt` must be positive and finite; any other value sets
    /// error() and does nothing.
    void step(Scalar dt) {
        if (!is_finite(dt) || !(dt > Scalar())) return report(Error::bad_time_step);
        Integrator::step(*this, dt);
    }

    // The parts of a step, for integrators, solvers and custom forces.

    /// The particles, for a step to change: the integrator is not told of the change.
    Elements<Particle, Uses::particles>& step_particles() { return particles_; }

    /// Computes the force on each particle: springs, drags and the custom force.
    void accumulate_forces() {
        only_if<has_forces>(*this, [](World& world) {
            world.for_each_particle([](Particle& particle) { force_of(particle) = Vector(); });
            world.apply_springs(If<!Integrator::implicit_springs>());
            world.drags_.for_each(Apply{world});
            observe<Scalar>(Quantity::custom_force);
            world.custom_force_.apply(world);
        });
    }

    /// Integrates velocities over dt, by forces and gravity.
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

    /// Integrates positions over dt, by velocities.
    template <class TimeStep>
    void integrate_positions(TimeStep dt) {
        observe<Scalar>(Quantity::position);
        integrate_positions(dt, If<Uses::continuous_contacts>());
    }

    /// Multiplies each velocity by its particle's damping factor, unless that is 1.
    void damp() {
        observe<Scalar>(Quantity::damping);
        only_if<Uses::damping>(*this, [](World& world) {
            world.for_each_particle([](Particle& particle) {
                const Scalar factor = damping_of(particle);
                if (!(factor == Scalar(Decimal<1, 0>()))) particle.velocity *= factor;
            });
        });
    }

    /// Finds the rows that constrain velocities and positions in this step.
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
    /// Appends a row, which fill(row) writes. If there is no room, sets error() to contacts_full.
    template <class Function>
    ENGINE_INLINE void append_row(Function fill) {
        if (rows_.full()) {
            fail(Error::contacts_full);
        } else {
            fill(rows_.append());
        }
    }
    /// The constraint rows of this step. A world whose only constraint is one rod has none: that
    /// rod is solved where it is found.
    const Rows& rows() const { return rows_; }
    /// The constraint rows of this step, for a solver to change.
    Rows& step_rows() { return rows_; }
    /// Gives the particles velocities that satisfy the rows of this step, as far as the solver's
    /// iterations reach.
    void solve_constraints() {
        observe<Scalar>(Quantity::resolution);
        solve(If<(keeps_rows && max_rows > 0)>());
    }

    /// The acceleration by gravity of a relative to b: zero where both or neither can move.
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

    /// Sets error(), unless it is already set.
    void report(Error error) { fail(error); }

    /// \cond internal
    LastReach<Scalar, Uses::collisions>& last_reach() { return *this; }
    PairMemory& pair_memory() { return pair_memory_; }
    IntegratorMemory& integrator_memory() { return integrator_memory_; }
    /// \endcond

  private:
    // The parts of a step that a scene may do without: If<false> selects the overload that does
    // nothing. The other one, which names members that are missing then, is not compiled.
    struct Apply {
        World& world;
        template <class Force>
        void operator()(const Force& force) const {
            apply(force, world);
        }
    };
    // How many particles a step visits. With a capacity of 1 the particle need not have been added:
    // until then its inverse mass is 0, unless somebody writes to it, and nothing moves it.
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
        // Otherwise the compiler would specialise the caller's code for this handle.
        return Handle(unknown(nothing<Index>()));
    }
    // The index that a handle names, or 0 where it names no particle.
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
    Rows rows_;  // of the current step
    PairMemory pair_memory_;
    IntegratorMemory integrator_memory_;
    CustomForce custom_force_;
    mutable Error error_ = Error::none;
};

}  // namespace engine
