// SPDX-License-Identifier: MIT
// The methods that scenes run with: each is an integrator and a solver. A scene's Uses derives from
// UsesWith<Method>.
#pragma once

#include <engine.h>

namespace scenes {

// As published: the baseline.
struct Published {
    static constexpr const char* name = "explicit_euler";
    using Integrator = engine::ExplicitEuler;
    using Solver = engine::WorstFirst<10>;
};
struct SemiImplicit {
    static constexpr const char* name = "semi_implicit_euler";
    using Integrator = engine::SemiImplicitEuler;
    using Solver = engine::ProjectedGaussSeidel<10>;
};
struct Verlet {
    static constexpr const char* name = "velocity_verlet";
    using Integrator = engine::VelocityVerlet;
    using Solver = engine::ProjectedGaussSeidel<10>;
};
struct Implicit {
    static constexpr const char* name = "implicit_springs";
    using Integrator = engine::ImplicitSprings;
    using Solver = engine::ProjectedGaussSeidel<10>;
};
// For scenes with several rods and nothing that only pushes.
struct Direct {
    static constexpr const char* name = "direct_rods";
    using Integrator = engine::VelocityVerlet;
    using Solver = engine::DirectRods;
};

// The same method with compensated integration.
template <class Method>
struct Compensated : Method {};

template <class Method>
struct UsesWith : engine::Uses {
    using Integrator = typename Method::Integrator;
    using Solver = typename Method::Solver;
};
template <class Method>
struct UsesWith<Compensated<Method>> : UsesWith<Method> {
    static constexpr bool compensated_integration = true;
};

// Builds the scene with its default parameters. (A default argument would do the same, but avr-gcc
// 5.4 leaves the conversions of constants undefined in one.)
template <class Scene, class World>
void build(World& world) {
    const typename Scene::template Parameters<typename World::Scalar> numbers{};
    Scene::build(world, numbers);
}

}  // namespace scenes
