// SPDX-License-Identifier: GPL-3.0-or-later
// Methods in addition to those of scenes/methods.hpp, for the host and the chip: the engine with
// residuals, and the engine without one of its measures, each otherwise scenes::SemiImplicit.
#pragma once

#include <scenes/methods.hpp>

namespace stability {

// SemiImplicit with residuals of products with the step.
struct CompensatedIntegration : scenes::SemiImplicit {
    static constexpr const char* name = "semi_implicit_compensated";
};
template <class Method>
struct IsCompensated {
    static constexpr bool value = false;
};
template <>
struct IsCompensated<CompensatedIntegration> {
    static constexpr bool value = true;
};

// SemiImplicit whose iterations start where the last step ended.
struct WarmStarted : scenes::SemiImplicit {
    static constexpr const char* name = "warm_started";
    using Solver = engine::WarmStartedGaussSeidel<10>;
};

// SemiImplicit with one iteration, for small steps in place of many iterations (Macklin et al.,
// Small Steps in Physics Simulation, 2019).
struct OneIteration : scenes::SemiImplicit {
    static constexpr const char* name = "one_iteration";
    using Solver = engine::ProjectedGaussSeidel<1>;
};

// Implicit with all springs of a chain solved together.
struct DirectSprings : scenes::Implicit {
    static constexpr const char* name = "direct_springs";
    using Integrator = engine::DirectSprings;
};

// Springs by the implicit midpoint rule.
struct ImplicitMidpoint : scenes::Implicit {
    static constexpr const char* name = "implicit_midpoint";
    using Integrator = engine::ImplicitMidpoint;
};

// In ten iterations over all springs.
struct GaussSeidelSprings : scenes::Implicit {
    static constexpr const char* name = "gauss_seidel_springs";
    using Integrator = engine::GaussSeidelSprings<10>;
};

// SemiImplicit that finds the contacts of fast particles along their path.
struct ContinuousContacts : scenes::SemiImplicit {
    static constexpr const char* name = "continuous_contacts";
};
template <class Method>
struct HasContinuousContacts {
    static constexpr bool value = false;
};
template <>
struct HasContinuousContacts<ContinuousContacts> {
    static constexpr bool value = true;
};

// SemiImplicit with a broad phase that sorts, and in three dimensions.
struct SortedPairs : scenes::SemiImplicit {
    static constexpr const char* name = "sort_and_sweep";
};
struct CachedSortedPairs : scenes::SemiImplicit {
    static constexpr const char* name = "cached_sort_and_sweep";
};
struct ThreeDimensions : scenes::SemiImplicit {
    static constexpr const char* name = "three_dimensions";
};
template <class Method>
struct BroadPhaseOf {
    using Type = engine::BruteForce;
};
template <>
struct BroadPhaseOf<SortedPairs> {
    using Type = engine::SortAndSweep;
};
template <>
struct BroadPhaseOf<CachedSortedPairs> {
    using Type = engine::CachedSortAndSweep;
};
template <class Method>
struct DimensionsOf {
    static constexpr unsigned char value = 2;
};
template <>
struct DimensionsOf<ThreeDimensions> {
    static constexpr unsigned char value = 3;
};

// Positions use the velocities before the step.
struct PositionsFirst : scenes::SemiImplicit {
    static constexpr const char* name = "positions_first";
    using Integrator = engine::ExplicitEuler;
};

// In each round, solves only the worst contact of the step; there are as many rounds as iterations.
struct WorstContactFirst : scenes::SemiImplicit {
    static constexpr const char* name = "worst_contact_first";
    using Solver = engine::WorstFirst<10>;
};

using PlainIterations = engine::ProjectedGaussSeidel<10>;

// A rod is two opposed contacts where its length is off.
struct OpposedContacts : scenes::SemiImplicit {
    static constexpr const char* name = "rods_as_opposed_contacts";
    struct Solver : PlainIterations {
        static constexpr unsigned rows_per_rod = 2;

        template <class World, class Index, class Vector, class Scalar, class TimeStep>
        static void rod(World& world, Index a, Index b, const Vector& direction, Scalar excess,
                        const engine::Inverse<Scalar>&, TimeStep) {
            if (excess == Scalar()) return;
            bind(world, a, b, true, direction, -excess, Scalar(), Scalar());
            bind(world, a, b, true, -direction, Scalar(), Scalar(), Scalar());
        }
    };
};

// A rod's end moves along the tangent of its arc.
struct TangentRods : scenes::SemiImplicit {
    static constexpr const char* name = "rods_along_tangents";
    struct Solver : PlainIterations {
        template <class World, class Index, class Vector, class Scalar, class TimeStep>
        static void rod(World& world, Index a, Index b, const Vector& direction, Scalar excess,
                        const engine::Inverse<Scalar>&, TimeStep) {
            bind(world, a, b, false, direction, -excess, Scalar(), Scalar());
        }
    };
};

// A bounce starts where it is found.
struct LateBounces : scenes::SemiImplicit {
    static constexpr const char* name = "bounces_when_found";
    struct Solver : PlainIterations {
        template <class World, class Index, class Vector, class Scalar, class TimeStep>
        static void contact(World& world, Index a, Index b, const Vector& normal,
                            Scalar penetration, Scalar restitution, TimeStep) {
            bind(world, a, b, true, normal, penetration, Scalar(), restitution);
        }
    };
};

// Velocities by impulses, change / (sum of inverse masses), instead of shares.
struct Impulses : scenes::SemiImplicit {
    static constexpr const char* name = "velocities_by_impulses";
    struct Solver : PlainIterations {
        template <class World>
        static void solve(World& world) {
            for (unsigned char sweep = 0; sweep < 10; ++sweep) {
                bool changed = false;
                world.rows().for_each([&](const auto& row) {
                    if (Solver::push(world, row)) changed = true;
                });
                if (!changed || world.rows().size() == 1) break;
            }
        }

      private:
        template <class World, class Row>
        static bool push(World& world, const Row& row) {
            using namespace engine;
            using Scalar = typename World::Scalar;
            const Scalar velocity = dot(relative_velocity(world, row.a, row.b), row.normal);
            Scalar goal = row.target;
            if (!row.acts(world, velocity, goal)) return false;
            const Scalar change = goal - velocity;
            if (change == Scalar()) return false;
            auto& a = world.step_particles()[row.a];
            Scalar total = a.inverse_mass;
            if (is_particle(world, row.b)) total += world.particles()[row.b].inverse_mass;
            const Scalar impulse = change / total;
            a.velocity.add_scaled(row.normal, impulse * a.inverse_mass);
            if (is_particle(world, row.b)) {
                auto& b = world.step_particles()[row.b];
                b.velocity.add_scaled(row.normal, -(impulse * b.inverse_mass));
            }
            return true;
        }
    };
};

// A constant force on each particle, N.
template <class World>
struct ConstantForces {
    typename World::Vector force[World::capacity];
    void apply(World& world) const {
        for (typename World::Index i = 0; i < world.particles().size(); ++i) {
            world.step_particles()[i].force += force[i];
        }
    }
};

}  // namespace stability
