// SPDX-License-Identifier: GPL-3.0-or-later
// The error of a scene from several initial states: one start may flatter a method or a format,
// where its two errors happen to cancel.
//
// A state is the scene with other numbers of its start (angles, speeds, heights), drawn from a
// seed; masses, lengths and radii stay. Runs are the host's, bit for bit the chip's in fixed point;
// `float` is the host's IEEE single. The error is against the truth from the same start, and of the
// box, whose truth is not known, against the same method and step in double.
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
    std::vector<std::string> scenes;  // all where empty
};

// A run from the state of that seed: the largest distance of a particle from its truth at any
// quarter of a second, m; nothing where the run failed or was off by more than the truth's extent.
struct StateSubject {
    std::string scalar, arithmetic, method;
    std::optional<double> (*error)(unsigned seed, int exponent);
};
struct SceneStates {
    std::string scene;
    std::vector<StateSubject> subjects;
};
// Of all scenes, each instantiated in a file of its own.
const std::vector<SceneStates>& scene_states();

// Smallest, median and largest; the median of an even number is the mean of the middle two.
struct Spread {
    double smallest, median, largest;
};
std::optional<Spread> spread(std::vector<double> values);

// Writes initial_states.csv.
void measure_initial_states(const StateOptions& options);

}  // namespace scene_bench
