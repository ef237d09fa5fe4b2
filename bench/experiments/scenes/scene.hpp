// SPDX-License-Identifier: GPL-3.0-or-later
// A run of a scene, wherever it ran, and the scenes with their runs on the host.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reference/trajectories/trajectory.hpp"

namespace scene_bench {

using reference::ParticleState;
using reference::State;
using reference::Trajectory;

// How often the state of a run is recorded, first at 0 s.
constexpr int observations_per_second = 4;

struct Run {
    Trajectory trajectory;              // ends early if the run failed
    std::string failure;                // empty if nothing went wrong
    std::vector<std::uint32_t> hashes;  // of the state after each step, if requested
    double largest_number = 0;          // of any result, if the scalar reports it (double)
};

// Whether every number is finite.
bool finite(const State& state);

enum class Hashes { no, of_each_step };

struct HostSubject {
    std::string scalar;  // as in scalars.hpp, or double, fifty_digits
    std::string method;  // as in scenes/methods.hpp
    // Runs for the scene's duration in steps of 2^-exponent s.
    Run (*run)(int exponent, Hashes hashes);
};

struct Scene {
    std::string name;
    unsigned duration = 0;  // s
    unsigned dimensions = 0;
    unsigned particles = 0;
    bool springs = false;
    // The 32-bit format with the most fraction bits that holds every number of the scene.
    std::string split = {};
    std::vector<HostSubject> subjects = {};
    // The largest |length - distance| / length of a rod.
    double (*rod_error)(const State& state) = nullptr;

    const HostSubject* find(std::string_view scalar, std::string_view method) const;
};

// The scenes of engine/src/scenes/, in that order.
const std::vector<Scene>& all_scenes();

}  // namespace scene_bench
