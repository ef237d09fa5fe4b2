// SPDX-License-Identifier: MIT
// Runs of scenes on the host, observed four times a second.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fixedpoint/conversion.hpp>
#include <scenes/all.hpp>

#include "reference/fifty_digits.hpp"
#include "reference/trajectories/trajectory.hpp"

namespace runs {

template <class Scalar>
double to_double(const Scalar& x) {
    return static_cast<double>(x);
}
template <int I, int F, class A>
double to_double(const engine::Fixed<I, F, A>& x) {
    return fixedpoint::to_float<double>(x);
}

template <class Scalar>
struct Rounded {
    static Scalar of(double x) { return static_cast<Scalar>(x); }
};
template <int I, int F, class A>
struct Rounded<engine::Fixed<I, F, A>> {
    static engine::Fixed<I, F, A> of(double x) {
        return fixedpoint::from_float<engine::Fixed<I, F, A>>(x);
    }
};

template <class Scene, class Method, class Scalar>
using WorldOf = engine::World<Scalar, typename Scene::template Uses<Method>>;

template <class World>
reference::State state_of(const World& world) {
    reference::State state;
    for (const auto& particle : world.particles()) {
        auto& seen = state.emplace_back();
        for (unsigned char i = 0; i < World::dimensions; ++i) {
            seen.position[i] = to_double(particle.position[i]);
            seen.velocity[i] = to_double(particle.velocity[i]);
        }
    }
    return state;
}

template <class Scene>
reference::Times observed_times() {
    reference::Times times;
    for (unsigned i = 1; i <= 4 * Scene::duration; ++i) times.push_back(i / 4.0);
    return times;
}

// In steps of 2^-K s; look(world) is called after each step.
template <class Scene, class Method, class Scalar, int K, class Look>
reference::Trajectory run(Look look) {
    WorldOf<Scene, Method, Scalar> world;
    scenes::build<Scene>(world);
    reference::Trajectory trajectory;
    for (unsigned step = 1; step <= Scene::duration << K; ++step) {
        world.step(engine::BinaryStep<K>());
        look(world);
        if (step % (1u << K >> 2) == 0) trajectory.push_back(state_of(world));
    }
    EXPECT_EQ(world.error(), engine::Error::none) << Scene::name;
    return trajectory;
}
template <class Scene, class Method, class Scalar, int K>
reference::Trajectory run() {
    return run<Scene, Method, Scalar, K>([](const auto&) {});
}

// The largest distance between positions, m.
inline double largest_distance(const reference::Trajectory& a, const reference::Trajectory& b) {
    EXPECT_EQ(a.size(), b.size());
    double largest = 0;
    for (std::size_t t = 0; t < a.size(); ++t) {
        EXPECT_EQ(a[t].size(), b[t].size());
        for (std::size_t p = 0; p < a[t].size(); ++p) {
            const auto &x = a[t][p].position, &y = b[t][p].position;
            largest = std::max(largest, std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]));
        }
    }
    return largest;
}

template <class Scene, class Method, class Scalar, int K>
double error() {
    return largest_distance(run<Scene, Method, Scalar, K>(),
                            *reference::trajectory(Scene::name, observed_times<Scene>()));
}

}  // namespace runs
