// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <stdexcept>
#include <string>

#include "reference/trajectories/invariants.hpp"
#include "reference/trajectories/trajectory.hpp"
#include "reference/trajectories/vector.hpp"

namespace reference {
namespace {

// Calls function(scene) with the scene of that name; throws std::invalid_argument if there is none.
template <class Function>
void with_scene(std::string_view name, Function function) {
    bool found = false;
    scenes::for_each_scene([&](auto scene) {
        if (scene.name != name) return;
        found = true;
        function(scene);
    });
    if (!found) throw std::invalid_argument("there is no scene '" + std::string(name) + "'");
}

template <class Scene>
std::vector<Mechanics> mechanics_of(Scene scene) {
    const typename Scene::template Parameters<double> with;
    Mechanics one;
    std::size_t count = 1;
    if constexpr (requires { with.inverse_mass; }) one.mass = 1 / with.inverse_mass;
    if constexpr (requires { with.gravity; }) one.force[1] = -with.gravity * one.mass;
    if constexpr (requires { with.stiffness; })
        one.spring = {{0, 0, 0}, with.stiffness, with.rest_length};
    if constexpr (requires { scene.balls; }) count = scene.balls;
    if constexpr (requires { scene.links; }) count = scene.links;
    return std::vector<Mechanics>(count, one);
}
std::vector<Mechanics> mechanics_of(scenes::DoublePendulum) {
    const scenes::DoublePendulum::Parameters<double> with;
    return std::vector<Mechanics>(2, {1, {0, -with.gravity, 0}, {}});
}
std::vector<Mechanics> mechanics_of(scenes::TwoBodyCollision) {
    const scenes::TwoBodyCollision::Parameters<double> with;
    return {{1 / with.inverse_mass, {}, {}}, {1 / with.other_inverse_mass, {}, {}}};
}
std::vector<Mechanics> mechanics_of(scenes::Lever) {
    const scenes::Lever::Parameters<double> with;
    const double mass = 1 / with.inverse_mass;
    return {{mass, {with.force_x, with.force_y - mass * with.gravity, 0}, {}}};
}
std::vector<Mechanics> mechanics_of(scenes::PublishedLever) {
    return {{0, {}, {}}, {0.1, {0, -0.981, 0}, {}}};
}

}  // namespace

void check(const Times& times) {
    double last = 0;
    for (double time : times) {
        if (!(time >= last)) throw std::invalid_argument("times are not negative and never fall");
        last = time;
    }
}

std::optional<Trajectory> trajectory(std::string_view name, const Times& times) {
    std::optional<Trajectory> result;
    with_scene(name, [&](auto scene) {
        const typename decltype(scene)::template Parameters<double> with;
        if constexpr (requires { trajectory(with, times); }) result = trajectory(with, times);
    });
    return result;
}

std::vector<Mechanics> mechanics(std::string_view name) {
    std::vector<Mechanics> result;
    with_scene(name, [&](auto scene) { result = mechanics_of(scene); });
    return result;
}

double energy(const std::vector<Mechanics>& mechanics, const State& state) {
    double sum = 0;
    for (std::size_t i = 0; i < state.size(); ++i) {
        const Mechanics& of = mechanics.at(i);
        const Vector3 away = state[i].position - of.spring.anchor;
        const double extension = std::sqrt(dot(away, away)) - of.spring.rest_length;
        sum += of.mass / 2 * dot(state[i].velocity, state[i].velocity) -
               dot(of.force, state[i].position) + of.spring.stiffness / 2 * extension * extension;
    }
    return sum;
}

std::array<double, 3> momentum(const std::vector<Mechanics>& mechanics, const State& state) {
    Vector3 sum{};
    for (std::size_t i = 0; i < state.size(); ++i)
        sum = sum + mechanics.at(i).mass * state[i].velocity;
    return sum;
}

}  // namespace reference
