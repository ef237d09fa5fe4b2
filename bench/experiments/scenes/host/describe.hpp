// SPDX-License-Identifier: GPL-3.0-or-later
// describe<Scene>(): a scene of engine/src/scenes/ with its runs on the host. Each scene is
// compiled as a file of its own, generated from scene.cpp.in, since that takes ten seconds.
#pragma once

#include <algorithm>
#include <cmath>
#include <engine/hash.hpp>
#include <fixedpoint/arithmetic/checked.hpp>
#include <fixedpoint/conversion.hpp>
#include <scenes/all.hpp>
#include <string>
#include <type_traits>

#include "bench/experiments/scenes/host/ranged.hpp"
#include "bench/experiments/scenes/host/time_step.hpp"
#include "bench/experiments/scenes/scalars.hpp"
#include "bench/experiments/scenes/scene.hpp"
#include "reference/fifty_digits.hpp"

namespace scene_bench {

template <class Scalar>
double to_double(Scalar x) {
    return static_cast<double>(x);
}
template <int I, int F, class A>
double to_double(fixedpoint::Fixed<I, F, A> x) {
    return fixedpoint::to_float<double>(x);
}

template <class World>
State state_of(const World& world) {
    State state;
    for (const auto& particle : world.particles()) {
        ParticleState& seen = state.emplace_back();
        for (unsigned char i = 0; i < World::dimensions; ++i) {
            seen.position[i] = to_double(particle.position[i]);
            seen.velocity[i] = to_double(particle.velocity[i]);
        }
    }
    return state;
}

// Whether a result of this thread did not fit its format, until it is reset.
struct Overflow {
    static bool& seen() {
        static thread_local bool any = false;
        return any;
    }
    static void notify(fixedpoint::Event event, fixedpoint::Operation) {
        if (event == fixedpoint::Event::overflow) seen() = true;
    }
};

// The best split of 32 bits: the fewest integer bits that hold every number of the scene. Stated in
// initial_states.hpp; a test compares them with the largest number of the run in double.
template <class SceneType>
constexpr int integer_bits = 0;

template <class SceneType, class Scalar, class Method>
using WorldOf = engine::World<Scalar, typename SceneType::template Uses<Method>>;

template <class SceneType, class Scalar, class Method>
Run run_on_host(int exponent, Hashes hashes) {
    // The constants of the scene are numbers that a format must hold, too.
    Ranged::largest() = 0;
    Overflow::seen() = false;
    WorldOf<SceneType, Scalar, Method> world;
    scenes::build<SceneType>(world);
    Run run;
    run.trajectory.push_back(state_of(world));
    const unsigned steps = SceneType::duration << exponent;
    const unsigned between = (1u << exponent) / observations_per_second;
    for (unsigned step = 1; step <= steps && run.failure.empty(); ++step) {
        world.step(PowerOfTwoStep{exponent});
        if (hashes == Hashes::of_each_step) run.hashes.push_back(engine::state_hash(world));
        if (world.error() != engine::Error::none) run.failure = engine::describe(world.error());
        if (step % between != 0) continue;
        run.trajectory.push_back(state_of(world));
        if (!finite(run.trajectory.back())) run.failure = "a number is not finite";
    }
    if (Overflow::seen()) run.failure = "a result does not fit the format";
    run.largest_number = Ranged::largest();
    return run;
}

// The scene's world of doubles, set to a state.
template <class SceneType>
auto world_in(const State& state) {
    WorldOf<SceneType, double, scenes::SemiImplicit> world;
    scenes::build<SceneType>(world);
    for (std::size_t p = 0; p < state.size(); ++p) {
        auto& particle = world.particles()[p];
        for (unsigned char i = 0; i < world.dimensions; ++i) {
            particle.position[i] = state[p].position[i];
            particle.velocity[i] = state[p].velocity[i];
        }
    }
    return world;
}

template <class SceneType>
double rod_error_of(const State& state) {
    auto world = world_in<SceneType>(state);
    double largest = 0;
    const auto look = [&](const auto& rod) {
        const double excess = engine::length(rod.ends.difference(world)) - rod.length;
        largest = std::max(largest, std::abs(excess) / rod.length);
    };
    world.rods().for_each(look);
    world.anchored_rods().for_each(look);
    return largest;
}

template <class SceneType, class Method>
void add_runs(std::vector<HostSubject>& subjects) {
    const auto add = [&](const char* scalar, auto run) {
        subjects.push_back({scalar, Method::name, run});
    };
#define ADD_FORMAT(name, I, F) add(#name, run_on_host<SceneType, scalars::name, Method>);
    SCENE_FORMATS(ADD_FORMAT)
#undef ADD_FORMAT
    add("double", run_on_host<SceneType, Ranged, Method>);
    add("fifty_digits", run_on_host<SceneType, reference::FiftyDigits, Method>);
}

template <class SceneType>
std::string split_name() {
    constexpr int I = integer_bits<SceneType>;
    return "q" + std::to_string(I) + "_" + std::to_string(32 - I);
}

// The best split runs with one method and reports overflow.
template <class SceneType, class Method>
void add_split(Scene& scene) {
    constexpr int I = integer_bits<SceneType>;
    using Split = fixedpoint::Fixed<I, 32 - I, fixedpoint::Checked<Overflow>>;
    scene.split = split_name<SceneType>();
    scene.subjects.push_back({scene.split, Method::name, run_on_host<SceneType, Split, Method>});
}

// Two formats also run with compensated integration, with the same method as the best split.
template <class SceneType, class Method>
void add_compensated(std::vector<HostSubject>& subjects) {
    using Compensated = scenes::Compensated<Method>;
    subjects.push_back(
        {"q8_8_compensated", Method::name, run_on_host<SceneType, scalars::q8_8, Compensated>});
    subjects.push_back(
        {"q16_16_compensated", Method::name, run_on_host<SceneType, scalars::q16_16, Compensated>});
}

// Whether the method for stiff springs differs from SemiImplicit.
template <class SceneType>
constexpr bool has_springs() {
    using Uses = typename SceneType::template Uses<scenes::SemiImplicit>;
    return Uses::springs + Uses::anchored_springs > 0;
}

// Whether the direct method applies and differs from Verlet.
template <class SceneType>
constexpr bool is_of_rods() {
    using Uses = typename SceneType::template Uses<scenes::SemiImplicit>;
    return Uses::rods > 0 && !engine::may_bounce<Uses>();
}

// The method with the smallest error: that of the best split and of compensated integration.
template <class SceneType>
using BestMethod = std::conditional_t<is_of_rods<SceneType>(), scenes::Direct, scenes::Verlet>;

template <class SceneType>
Scene describe() {
    WorldOf<SceneType, double, scenes::SemiImplicit> world;
    scenes::build<SceneType>(world);
    Scene scene;
    scene.name = SceneType::name;
    scene.duration = SceneType::duration;
    scene.dimensions = world.dimensions;
    scene.particles = world.particles().size();
    scene.springs = has_springs<SceneType>();
    scene.rod_error = rod_error_of<SceneType>;
    add_runs<SceneType, scenes::Published>(scene.subjects);
    scene.subjects.push_back(
        {"q16_16_published", scenes::Published::name,
         run_on_host<SceneType, scalars::q16_16_published, scenes::Published>});
    scene.subjects.push_back(
        {"q16_16_saturating", scenes::SemiImplicit::name,
         run_on_host<SceneType, scalars::q16_16_saturating, scenes::SemiImplicit>});
    add_runs<SceneType, scenes::SemiImplicit>(scene.subjects);
    add_runs<SceneType, scenes::Verlet>(scene.subjects);
    if constexpr (has_springs<SceneType>()) add_runs<SceneType, scenes::Implicit>(scene.subjects);
    if constexpr (is_of_rods<SceneType>()) add_runs<SceneType, scenes::Direct>(scene.subjects);
    using Best = BestMethod<SceneType>;
    add_split<SceneType, Best>(scene);
    add_compensated<SceneType, Best>(scene.subjects);
    return scene;
}

}  // namespace scene_bench
