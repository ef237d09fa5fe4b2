// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of a step as a function of the number of particles.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/experiments/cost/growth/cost.hpp"

namespace growth {

// For a number of particles: the term that grows faster than that number, and the value to fit.
struct Sample {
    double particles, grown, value;
};

// a + b N + c grown.
struct Fit {
    double a, b, c;
    double worst;  // largest |fit / value - 1| of a sample

    double operator()(const Sample& at) const { return a + b * at.particles + c * at.grown; }
};

// Least squares of the relative deviations, so that small numbers count as much as large ones.
// Throws std::runtime_error if there are fewer than four samples.
Fit fitted(const std::vector<Sample>& samples);

// The costs of one broad phase.
std::vector<Cost> of_search(const std::vector<Cost>& costs, const std::string& search);

// The smallest measured number of particles from which the second broad phase is never more
// expensive; nothing if there is none. `first` must have been measured at the first numbers of
// `second`, and both must be in order of rising numbers.
std::optional<unsigned> crossing(const std::vector<Cost>& first, const std::vector<Cost>& second);

}  // namespace growth
