// SPDX-License-Identifier: MIT
/// \file
/// What a scene uses. A scene's own struct derives from Uses and states what differs:
///
///     struct Pendulum : engine::Uses {
///         static constexpr unsigned particles = 2, rods = 1;
///         static constexpr bool gravity = true;
///     };
///     engine::World<Q16_16, Pendulum> world;
///
/// What is left at 0 or false is not compiled: it takes no code, no table and no RAM.
#pragma once

#include <engine/broad_phase/brute_force.hpp>
#include <engine/integrators/semi_implicit_euler.hpp>
#include <engine/solvers/projected_gauss_seidel.hpp>

namespace engine {

/// The custom force of a scene that does not have one.
struct NoCustomForce {
    /// Adds no force.
    template <class World>
    void apply(World&) const {}
};

/// What a scene uses: derive from it and hide the members that differ. What is 0 or false is not
/// compiled.
struct Uses {
    /// The number of dimensions, 2 or 3.
    static constexpr unsigned char dimensions = 2;

    static constexpr unsigned particles = 0;         ///< the capacity of each pool, from here on
    static constexpr unsigned springs = 0;           ///< between two particles
    static constexpr unsigned anchored_springs = 0;  ///< between a particle and a point
    static constexpr unsigned drags = 0;             ///< on one particle
    static constexpr unsigned rods = 0;              ///< between two particles
    static constexpr unsigned anchored_rods = 0;     ///< between a particle and a point
    static constexpr unsigned ropes = 0;             ///< between two particles
    static constexpr unsigned anchored_ropes = 0;    ///< between a particle and a point
    static constexpr unsigned planes = 0;            ///< solid half spaces
    static constexpr unsigned contacts = 0;          ///< in one step, besides rods and ropes

    static constexpr bool gravity = false;     ///< one acceleration of all movable particles
    static constexpr bool damping = false;     ///< a factor of each particle's velocity
    static constexpr bool collisions = false;  ///< between particles
    static constexpr bool radii = false;       ///< particles are spheres, not points
    /// A fast particle stops in the step in which it touches something, instead of passing through
    /// it. Needs radii.
    static constexpr bool continuous_contacts = false;
    /// Velocities and positions carry what rounding a product with a binary step loses, for slow
    /// motion and small steps. Takes 4 scalars of RAM per particle in two dimensions, 6 in three.
    static constexpr bool compensated_integration = false;

    /// A force of the scene's own: `void apply(World&)` adds to the force on the particles in each
    /// step.
    template <class World>
    using CustomForce = NoCustomForce;
    /// Whether CustomForce is applied.
    static constexpr bool custom_force = false;

    /// ExplicitEuler, SemiImplicitEuler, VelocityVerlet, ImplicitSprings, DirectSprings,
    /// ImplicitMidpoint or GaussSeidelSprings with its number of iterations.
    using Integrator = SemiImplicitEuler;
    /// ProjectedGaussSeidel, WarmStartedGaussSeidel or WorstFirst, each with its number of
    /// iterations, or DirectRods.
    using Solver = ProjectedGaussSeidel<4>;
    /// BruteForce, SortAndSweep or CachedSortAndSweep.
    using BroadPhase = BruteForce;
};

/// Whether a scene has constraints that only push: contacts and ropes.
template <class SceneUses>
constexpr bool may_bounce() {
    return SceneUses::contacts > 0 || SceneUses::ropes > 0 || SceneUses::anchored_ropes > 0;
}

}  // namespace engine
