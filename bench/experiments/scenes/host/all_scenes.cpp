// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <scenes/all.hpp>

#include "bench/experiments/scenes/scene.hpp"

namespace scene_bench {

// Each is instantiated in a file of its own, generated from scene.cpp.in.
template <class SceneType>
Scene describe();

const std::vector<Scene>& all_scenes() {
    static const std::vector<Scene> all = [] {
        std::vector<Scene> made;
        scenes::for_each_scene([&](auto scene) { made.push_back(describe<decltype(scene)>()); });
        return made;
    }();
    return all;
}

bool finite(const State& state) {
    return std::all_of(state.begin(), state.end(), [](const ParticleState& particle) {
        const auto is_finite = [](double x) { return std::isfinite(x); };
        return std::all_of(particle.position.begin(), particle.position.end(), is_finite) &&
               std::all_of(particle.velocity.begin(), particle.velocity.end(), is_finite);
    });
}

const HostSubject* Scene::find(std::string_view scalar, std::string_view method) const {
    for (const HostSubject& subject : subjects)
        if (subject.scalar == scalar && subject.method == method) return &subject;
    return nullptr;
}

}  // namespace scene_bench
