// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of a step as a function of the number of particles.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/experiments/cost/growth/cost.hpp"

namespace growth {

// At a number of particles: what grows faster than they do, and what is to be fitted.
struct Sample {
    double particles, grown, value;
};

// a + b N + c grown.
struct Fit {
    double a, b, c;
    double worst;  // largest |fit / value - 1| of a sample

    double operator()(const Sample& at) const { return a + b * at.particles + c * at.grown; }
};

// By least squares of the deviations relative to the value, so that small numbers count as large
// ones do. Throws std::runtime_error where there are fewer than four samples.
Fit fitted(const std::vector<Sample>& samples);

// The costs of one broad phase.
std::vector<Cost> of_search(const std::vector<Cost>& costs, const std::string& search);

// The smallest measured number of particles from which on the second is never the dearer one;
// nothing where there is none. The first has been measured at the second's first numbers; both
// rise.
std::optional<unsigned> crossing(const std::vector<Cost>& first, const std::vector<Cost>& second);

}  // namespace growth
