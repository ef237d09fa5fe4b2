// SPDX-License-Identifier: GPL-3.0-or-later
// One world for all cases. It has some of everything, and its results are those of a world that
// states only what the case uses. Compiled once per scalar, by subjects/<scalar>.cpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <fixedpoint/conversion.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "bench/experiments/stability/methods.hpp"
#include "bench/experiments/stability/subject.hpp"

namespace stability {

template <class Method>
struct Everything : scenes::UsesWith<Method> {
    static constexpr unsigned char dimensions = DimensionsOf<Method>::value;
    static constexpr unsigned particles = 20, springs = 17, anchored_springs = 2, drags = 2,
                              rods = 16, anchored_rods = 6, ropes = 16, anchored_ropes = 2,
                              planes = 4, contacts = 48;
    static constexpr bool gravity = true, damping = true, collisions = true, radii = true,
                          custom_force = true;
    static constexpr bool compensated_integration = IsCompensated<Method>::value;
    static constexpr bool continuous_contacts = HasContinuousContacts<Method>::value;
    using BroadPhase = typename BroadPhaseOf<Method>::Type;
    template <class World>
    using CustomForce = ConstantForces<World>;
};
// DirectRods solves rods alone.
template <>
struct Everything<scenes::Direct> : scenes::UsesWith<scenes::Direct> {
    static constexpr unsigned particles = 20, rods = 16, anchored_rods = 6;
    static constexpr bool gravity = true, custom_force = true;
    template <class World>
    using CustomForce = ConstantForces<World>;
};

// A time step chosen at run time, a power of two or not: its products are bit for bit those of
// engine::BinaryStep or of a scalar in seconds.
template <class Scalar>
struct RunStep {
    int exponent;    // of a binary step
    Scalar seconds;  // used if binary is false
    bool binary;

    operator Scalar() const {
        return binary ? Scalar(1) / Scalar(std::int64_t(1) << exponent) : seconds;
    }
    friend Scalar operator*(Scalar a, RunStep dt) { return a * static_cast<Scalar>(dt); }
    friend RunStep half(RunStep dt) {
        return {dt.exponent + 1, dt.binary ? dt.seconds : engine::half(dt.seconds), dt.binary};
    }
};
template <int I, int F, class A>
struct RunStep<fixedpoint::Fixed<I, F, A>> {
    using Scalar = fixedpoint::Fixed<I, F, A>;
    static constexpr int most = 40;  // the largest exponent
    int exponent;
    Scalar seconds;
    bool binary;

    operator Scalar() const {
        if (!binary) return seconds;
        if (exponent > F) return Scalar::from_raw(exponent == F + 1);
        return Scalar::from_raw(
            static_cast<typename Scalar::Raw>(typename Scalar::Raw(1) << (F - exponent)));
    }
    friend Scalar operator*(Scalar a, RunStep dt) {
        return dt.binary ? scaled_down(a, dt.exponent, std::make_integer_sequence<int, most + 1>())
                         : a * dt.seconds;
    }
    friend Scalar carried_product(Scalar a, RunStep dt, Scalar& residual) {
        return dt.binary ? engine::carried_shift(a, dt.exponent, residual) : a * dt.seconds;
    }
    friend RunStep half(RunStep dt) {
        return {dt.exponent + 1, dt.binary ? dt.seconds : engine::half(dt.seconds), dt.binary};
    }

  private:
    template <int... K>
    static Scalar scaled_down(Scalar a, int exponent, std::integer_sequence<int, K...>) {
        Scalar result;
        (void)((K == exponent && (result = fixedpoint::scale_down<K>(a), true)) || ...);
        return result;
    }
};

}  // namespace stability

template <class Scalar>
struct engine::IsTimeStep<stability::RunStep<Scalar>> {
    static constexpr bool value = true;
};

namespace stability {

// Without these the scene is another one: a mass is infinite, or a step moves nothing.
inline bool is_essential(const char* name) {
    const std::string_view text = name;
    return text == "inverse_mass" || text == "time_step" || text == "stiffness" || text == "length";
}

// Numbers of a description in a scalar. A number that does not fit is named.
template <class Scalar>
struct Rounding {
    std::string unfit, vanished;
    Scalar operator()(double x, const char* name) {
        if (!(std::abs(x) <= double(std::numeric_limits<Scalar>::max())) && unfit.empty())
            unfit = name;
        return static_cast<Scalar>(x);
    }
};
template <int I, int F, class A>
struct Rounding<fixedpoint::Fixed<I, F, A>> {
    std::string unfit, vanished;
    fixedpoint::Fixed<I, F, A> operator()(double x, const char* name) {
        const auto rounded = fixedpoint::from_float_checked<fixedpoint::Fixed<I, F, A>>(x);
        if (!rounded.fits && unfit.empty()) unfit = name;
        if (rounded.number.raw() == 0 && x != 0 && is_essential(name) && vanished.empty())
            vanished = name;
        return rounded.number;
    }
};

template <class Scalar>
double to_double(Scalar x) {
    return static_cast<double>(x);
}
template <int I, int F, class A>
double to_double(fixedpoint::Fixed<I, F, A> x) {
    return std::ldexp(static_cast<double>(x.raw()), -F);
}

template <class Scalar, class Method>
class Run {
  public:
    using World = engine::World<Scalar, Everything<Method>>;
    using Vector = typename World::Vector;

    static Outcome run(const Description& description, const Watch& watch) {
        Run run;
        const Recorded recorded(run.outcome_.record);
        run.build(description);
        if (run.outcome_.unfit.empty() && run.outcome_.vanished.empty() && run.healthy())
            run.go(description, watch);
        return std::move(run.outcome_);
    }

  private:
    World world_;
    Rounding<Scalar> rounded_;
    RunStep<Scalar> dt_{};
    Outcome outcome_;
    State state_;

    Vector vector(Point p, const char* name) {
        Vector v;
        v[0] = rounded_(p.x, name);
        v[1] = rounded_(p.y, name);
        if constexpr (World::dimensions == 3) v[2] = rounded_(p.z, name);
        return v;
    }
    static typename World::Handle handle(int body) {
        return {static_cast<typename World::Index>(body)};
    }

    void build(const Description& description) {
        world_.gravity = vector(description.gravity, "gravity");
        for (const Body& body : description.bodies) add(body);
        add_rods(description);
        if constexpr (World::bounces) {
            add_others(description);
        } else {
            must_have_only_rods(description);
        }
        const TimeStep dt = description.dt;
        dt_ = {dt.exponent, rounded_(dt.seconds, "time_step"), !(dt.seconds > 0)};
        outcome_.unfit = rounded_.unfit;
        outcome_.vanished = rounded_.vanished;
    }
    void add_rods(const Description& description) {
        for (const Link& rod : description.rods) {
            add_link(
                rod, [&](auto b, Scalar length) { world_.add_rod(handle(rod.a), b, length); },
                [&](const Vector& anchor, Scalar length) {
                    world_.add_anchored_rod(handle(rod.a), anchor, length);
                });
        }
    }
    void add_others(const Description& description) {
        world_.set_restitution(rounded_(description.restitution, "restitution"));
        world_.set_restitution_threshold(
            rounded_(description.restitution_threshold, "restitution_threshold"));
        for (const Spring& spring : description.springs) {
            const Scalar stiffness = rounded_(spring.stiffness, "stiffness");
            const Scalar damping = rounded_(spring.damping, "spring_damping");
            add_link(
                spring,
                [&](auto b, Scalar length) {
                    world_.add_spring(handle(spring.a), b, stiffness, damping, length);
                },
                [&](const Vector& anchor, Scalar length) {
                    world_.add_anchored_spring(handle(spring.a), anchor, stiffness, damping,
                                               length);
                });
        }
        for (const Rope& rope : description.ropes) {
            const Scalar restitution = rounded_(rope.restitution, "restitution");
            add_link(
                rope,
                [&](auto b, Scalar length) {
                    world_.add_rope(handle(rope.a), b, length, restitution);
                },
                [&](const Vector& anchor, Scalar length) {
                    world_.add_anchored_rope(handle(rope.a), anchor, length, restitution);
                });
        }
        for (const Drag& drag : description.drags) {
            world_.add_drag(handle(drag.a), rounded_(drag.linear, "drag"),
                            rounded_(drag.quadratic, "drag"));
        }
        for (const Plane& plane : description.planes) {
            world_.add_plane(vector(plane.normal, "normal"), rounded_(plane.offset, "offset"),
                             rounded_(plane.restitution, "restitution"));
        }
    }
    static void must_have_only_rods(const Description& made) {
        bool plain =
            made.springs.empty() && made.drags.empty() && made.ropes.empty() && made.planes.empty();
        for (const Body& body : made.bodies) plain = plain && body.radius == 0 && body.damping == 1;
        if (!plain) throw std::logic_error("a world of rods alone cannot hold this description");
    }
    template <class Between, class Anchored>
    void add_link(const Link& link, Between between, Anchored anchored) {
        const Scalar length = rounded_(link.length, "length");
        if (link.b == no_body) {
            anchored(vector(link.anchor, "anchor"), length);
        } else {
            between(handle(link.b), length);
        }
    }
    void add(const Body& body) {
        typename World::Body made;
        made.position = vector(body.position, "position");
        made.velocity = vector(body.velocity, "velocity");
        made.inverse_mass = rounded_(body.inverse_mass, "inverse_mass");
        made.radius = rounded_(body.radius, "radius");
        made.damping = rounded_(body.damping, "damping");
        const auto added = world_.add_particle(made);
        if (added) world_.custom_force().force[added.index] = vector(body.force, "force");
    }

    bool healthy() {
        if (world_.error() == engine::Error::none) return true;
        outcome_.error = engine::describe(world_.error());
        return false;
    }

    void go(const Description& description, const Watch& watch) {
        look();
        if (!watch(state_, 0)) return;
        for (unsigned step = 1; step <= description.steps; ++step) {
            outcome_.record.step = step;
            if (step == description.dial_step && !turn_dial(description.dial_length)) return;
            World::Integrator::step(world_, dt_);
            outcome_.steps = step;
            look();
            if (!healthy() || !watch(state_, step)) return;
        }
    }
    bool turn_dial(double length) {
        const Scalar rounded = rounded_(length, "length");
        outcome_.unfit = rounded_.unfit;
        if (!outcome_.unfit.empty()) return false;
        world_.set_length(*world_.anchored_rods().begin(), rounded);
        return healthy();
    }
    void look() {
        // Through a const world: otherwise it would count as a change by hand, after which a step
        // starts with new forces.
        const World& world = world_;
        state_.resize(world.particles().size());
        Recorder& record = outcome_.record;
        for (std::size_t i = 0; i < state_.size(); ++i) {
            const auto& particle = world.particles()[static_cast<typename World::Index>(i)];
            const Point position = point(particle.position), velocity = point(particle.velocity);
            const Point force = point(particle.force);
            state_[i] = {position, velocity};
            include(record.position, position);
            include(record.velocity, velocity);
            include(record.force, force);
        }
    }
    static Point point(const Vector& v) {
        Point p{to_double(v[0]), to_double(v[1])};
        if constexpr (World::dimensions == 3) p.z = to_double(v[2]);
        return p;
    }
    static void include(Magnitudes& magnitudes, Point p) {
        magnitudes.include(p.x);
        magnitudes.include(p.y);
        magnitudes.include(p.z);
    }
};

template <class Scalar, class... Method>
std::vector<Subject> subjects_of_methods(const char* scalar, const char* arithmetic, double largest,
                                         double ulp) {
    return {{scalar, arithmetic, Method::name, largest, ulp, Run<Scalar, Method>::run}...};
}
template <class Scalar>
std::vector<Subject> subjects_with(const char* scalar, const char* arithmetic, double largest,
                                   double ulp) {
    return subjects_of_methods<Scalar, scenes::Published, scenes::SemiImplicit, scenes::Verlet,
                               scenes::Implicit, CompensatedIntegration>(scalar, arithmetic,
                                                                         largest, ulp);
}
template <int I, int F, class Arithmetic>
std::vector<Subject> subjects_of_format(const char* scalar, const char* arithmetic) {
    using Scalar = fixedpoint::Fixed<I, F, Arithmetic>;
    return subjects_with<Scalar>(scalar, arithmetic, to_double(Scalar::max()),
                                 to_double(Scalar::ulp()));
}

}  // namespace stability
