// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of a step as a polynomial of the number of particles.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/experiments/cost/growth/cost.hpp"

namespace growth {

// a + b N + c N^2.
struct Fit {
    double a, b, c;
    double worst;  // largest |cost / fit - 1| of a point

    double operator()(double n) const { return a + n * (b + n * c); }
};

// By least squares of the deviations relative to the cost, so that small numbers count as large
// ones do. Throws std::runtime_error where there are fewer than four points.
Fit fitted(const std::vector<Cost>& costs);

// The costs of one broad phase.
std::vector<Cost> of_search(const std::vector<Cost>& costs, const std::string& search);

// The smallest measured number of particles from which on the second is never the dearer one;
// nothing where there is none. Both have been measured at the same numbers, in rising order.
std::optional<unsigned> crossing(const std::vector<Cost>& first, const std::vector<Cost>& second);

}  // namespace growth
