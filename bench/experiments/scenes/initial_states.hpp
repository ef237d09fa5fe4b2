// SPDX-License-Identifier: GPL-3.0-or-later
// The error of a scene from several initial states: a single start may flatter a method or a format
// whose two errors happen to cancel.
//
// A state is the scene with other initial numbers (angles, speeds, heights), drawn from a seed;
// masses, lengths and radii stay the same. The runs are the host's, bit for bit those of the chip
// in fixed point; `float` is the host's IEEE single. The error is relative to the truth from the
// same start or, for the box, whose truth is not known, to the same method and step in double.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scene_bench {

constexpr unsigned initial_states = 8;

struct StateOptions {
    std::filesystem::path output;
    unsigned threads = 1;
    std::vector<std::string> scenes;  // empty: all
};

// A run from the state of that seed: the largest distance of a particle from its truth at any
// quarter of a second, m; nothing if the run failed or was off by more than the truth's extent.
struct StateSubject {
    std::string scalar, arithmetic, method;
    std::optional<double> (*error)(unsigned seed, int exponent);
};
struct SceneStates {
    std::string scene;
    std::vector<StateSubject> subjects;
};
// All scenes. Each is instantiated in a file of its own.
const std::vector<SceneStates>& scene_states();

// Smallest, median and largest; the median of an even number is the mean of the middle two.
struct Spread {
    double smallest, median, largest;
};
std::optional<Spread> spread(std::vector<double> values);

// Writes initial_states.csv.
void measure_initial_states(const StateOptions& options);

}  // namespace scene_bench
