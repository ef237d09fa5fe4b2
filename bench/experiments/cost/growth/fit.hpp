// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of a step as a function of the number of particles.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/experiments/cost/growth/cost.hpp"

namespace growth {

// What grows faster than the number of particles.
struct Term {
    const char* name;
    double (*value)(double n);
};

// Every pair; neighbours along an axis of a plane's crowd, whose strip holds the root of N; a tree.
extern const Term squares, strips, trees;

// a + b N + c term(N).
struct Fit {
    double a, b, c;
    Term term;
    double worst;  // largest |cost / fit - 1| of a point

    double operator()(double n) const { return a + b * n + c * term.value(n); }
};

// By least squares of the deviations relative to the cost, so that small numbers count as large
// ones do. Throws std::runtime_error where there are fewer than four points.
Fit fitted(const std::vector<Cost>& costs, const Term& term);

// The costs of one broad phase.
std::vector<Cost> of_search(const std::vector<Cost>& costs, const std::string& search);

// The smallest measured number of particles from which on the second is never the dearer one;
// nothing where there is none. The first has been measured at the second's first numbers; both
// rise.
std::optional<unsigned> crossing(const std::vector<Cost>& first, const std::vector<Cost>& second);

}  // namespace growth
