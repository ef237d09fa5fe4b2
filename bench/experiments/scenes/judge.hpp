// SPDX-License-Identifier: GPL-3.0-or-later
// How far a run is from the truth, and whether it counts as a run of the scene at all.
#pragma once

#include <string>
#include <string_view>

#include "bench/experiments/scenes/scene.hpp"

namespace scene_bench {

// The largest distance between a particle and its counterpart in the other trajectory over the
// times that both contain, m. NaN if a position is not finite, or if either has no time beyond the
// start.
double largest_distance(const Trajectory& a, const Trajectory& b);

// The diagonal of the box that contains all particles at all times, m.
double extent(const Trajectory& trajectory);

// The largest |E - E of the truth at the same time|, relative to the truth's largest kinetic
// energy. Without a truth, |E - E at the start| relative to the kinetic energy at the start. NaN if
// nothing moves.
double energy_drift(std::string_view scene, const Trajectory& run, const Trajectory& truth);

// What a run is judged by.
struct Evidence {
    const Scene& scene;
    const Run& run;
    double error;         // relative to the truth, or NaN
    double error_method;  // of the same method in 50 digits, or NaN
    double extent;        // of the truth, m
    double range;         // one past the format's largest number; may be infinite
    double needed_range;  // the largest number that the run in double needed
};
// "held", or "failed: " and the reason.
std::string verdict(const Evidence& evidence);

}  // namespace scene_bench
