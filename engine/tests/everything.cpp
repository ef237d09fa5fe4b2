// SPDX-License-Identifier: MIT
// Everything that the engine offers, in every kind of scalar, so that the compiler's warnings about
// its headers appear here. Compiled, and not run.
#include <engine.h>

#include <engine/hash.hpp>
#include <fixedpoint/arithmetic/published.hpp>
#include <fixedpoint/arithmetic/small.hpp>
#include <scenes/all.hpp>

using namespace engine;
using namespace engine::literals;

// Constants are computed by the compiler in every standard.
constexpr Fixed<16, 16> pendulum_arm = 0.38_d;
static_assert(pendulum_arm.raw() == 24904, "0.38 2^16 = 24903.68");
constexpr Fixed<8, 24> smallest = -128_d;
static_assert(smallest.raw() == -2147483647 - 1, "the smallest number");
constexpr float gravity = -9.81_d;
static_assert(gravity == -9.81f, "the nearest float");

namespace {

template <class World>
struct Push {
    typename World::Vector force;
    void apply(World& world) const { world.step_particles()[0].force += force; }
};

template <class ChosenIntegrator, class ChosenSolver, class ChosenBroadPhase>
struct All : Uses {
    static constexpr unsigned char dimensions = 3;
    static constexpr unsigned particles = 2, springs = 1, anchored_springs = 1, drags = 1, rods = 1,
                              anchored_rods = 1, ropes = 1, anchored_ropes = 1, planes = 1,
                              contacts = 2;
    static constexpr bool gravity = true, damping = true, collisions = true, radii = true,
                          compensated_integration = true, continuous_contacts = true,
                          custom_force = true;
    template <class World>
    using CustomForce = Push<World>;
    using Integrator = ChosenIntegrator;
    using Solver = ChosenSolver;
    using BroadPhase = ChosenBroadPhase;
};

template <class Scalar, class ChosenUses>
void use_all() {
    using Scene = World<Scalar, ChosenUses>;
    static Scene world;
    world.gravity = {0_d, 0_d, -9.81_d};
    typename Scene::Body body;
    body.position = {0_d, 0_d, 1_d};
    const auto a = world.add_particle(body);
    const auto b = world.add_particle(body);
    const typename Scene::Vector pivot(0_d, 0_d, 0_d);
    world.add_spring(a, b, 1_d, 0_d, 1_d);
    world.add_anchored_spring(a, pivot, 1_d, 0_d, 1_d);
    world.add_rod(a, b, 1_d);
    world.add_anchored_rod(a, pivot, 1_d);
    world.add_rope(a, b, 1_d, 0_d);
    world.add_anchored_rope(b, pivot, 1_d, 0_d);
    world.add_drag(a, 0_d, 0_d);
    world.add_plane({0_d, 0_d, 1_d}, 0_d, 0.5_d);
    world.set_restitution(0.5_d);
    world.set_restitution_threshold(0.25_d);
    world.set_length(world.rods()[0], 2_d);
    world.custom_force().force = normalise(cross(world[a].position, world[b].velocity));
    world.step(BinaryStep<10>());
    world.step(Scalar(0.001_d));
    if (world.error() != Error::none && describe(world.error()) != nullptr) world.clear_error();
    if (state_hash(world) == 0) world.particles()[0].velocity *= half(Scalar(1_d));
}

template <class Scalar>
void use_chain() {
    static World<Scalar, scenes::DoublePendulum::Uses<scenes::Direct>> world;
    scenes::build<scenes::DoublePendulum>(world);
    world.step(BinaryStep<10>());
}

struct Build {
    template <class Scene>
    void operator()(Scene) const {
        static World<SaturatingFixed<16, 16>, typename Scene::template Uses<scenes::SemiImplicit>>
            world;
        scenes::build<Scene>(world);
    }
};

}  // namespace

int main() {
    use_all<SaturatingFixed<16, 16>, All<SemiImplicitEuler, ProjectedGaussSeidel<4>, BruteForce>>();
    use_all<Fixed<16, 16, fixedpoint::Published>, All<ExplicitEuler, WorstFirst<4>, BruteForce>>();
    use_all<Fixed<32, 32, fixedpoint::Small>,
            All<ImplicitSprings, WarmStartedGaussSeidel<4>, BruteForce>>();
    use_all<Fixed<16, 16>, All<DirectSprings, ProjectedGaussSeidel<4>, BruteForce>>();
    use_all<double, All<GaussSeidelSprings<4>, ProjectedGaussSeidel<4>, BruteForce>>();
    use_all<Fixed<16, 16>, All<ImplicitMidpoint, ProjectedGaussSeidel<4>, BruteForce>>();
    use_all<float, All<VelocityVerlet, ProjectedGaussSeidel<4>, SortAndSweep>>();
    use_all<double, All<ImplicitSprings, WorstFirst<4>, CachedSortAndSweep>>();
    use_chain<SaturatingFixed<16, 16>>();
    use_chain<Fixed<32, 32, fixedpoint::Small>>();
    use_chain<float>();
    scenes::for_each_scene(Build());
}
