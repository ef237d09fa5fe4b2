// SPDX-License-Identifier: GPL-3.0-or-later
// How far a run is from the truth, and whether it can be called a run of the scene at all.
#pragma once

#include <string>
#include <string_view>

#include "bench/experiments/scenes/scene.hpp"

namespace scene_bench {

// The largest distance between a particle and itself in the other trajectory over the times that
// both have, m. NaN where a position is none, or where neither has a time beyond the start.
double largest_distance(const Trajectory& a, const Trajectory& b);

// The diagonal of the box that holds all particles at all times, m.
double extent(const Trajectory& trajectory);

// The largest |E - E of the truth at the same time|, against the truth's largest kinetic energy;
// where the truth is empty, |E - E at the start| against the kinetic energy at the start. NaN where
// nothing moves.
double energy_drift(std::string_view scene, const Trajectory& run, const Trajectory& truth);

// What a run is judged by.
struct Evidence {
    const Scene& scene;
    const Run& run;
    double error;         // against the truth, or NaN
    double error_method;  // of the same method in 50 digits, or NaN
    double extent;        // of the truth, m
    double range;         // one past the format's largest number, maybe infinite
    double needed_range;  // the largest number that the run in double needed
};
// "held", or "failed: " and the reason.
std::string verdict(const Evidence& evidence);

}  // namespace scene_bench
