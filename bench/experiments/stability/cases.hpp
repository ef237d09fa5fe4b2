// SPDX-License-Identifier: GPL-3.0-or-later
// The battery: what is driven until it fails. A case sweeps one parameter from easy to hard; an
// experiment is the case at one value of it.
#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "bench/experiments/stability/description.hpp"

namespace stability {

// How far the state after a step is from what the case allows: it holds up to 1, and not for NaN.
class Measure {
  public:
    Measure() = default;
    // `holds` says what is allowed, with the numbers and units that the function compares with.
    template <class Function, class = std::enable_if_t<
                                  std::is_invocable_r_v<double, Function, const State&, unsigned> &&
                                  !std::is_same_v<std::decay_t<Function>, Measure>>>
    Measure(Function function, std::string holds = {})
        : function_(std::move(function)), holds_(std::move(holds)) {}

    double operator()(const State& state, unsigned step) const { return function_(state, step); }
    const std::string& holds() const { return holds_; }

  private:
    std::function<double(const State& state, unsigned step)> function_;
    std::string holds_;
};

struct Experiment {
    Description description;
    Measure measure;
};

struct Case {
    std::string name;
    std::string group;  // springs, links, contacts, edges
    std::string parameter, unit;
    double from = 0, to = 0;  // from easy to hard; either may be larger, both are positive
    std::string reference;    // what the measure compares with
    std::function<Experiment(double)> at;
    // In an endurance case the parameter is a number of steps: at most `to`, in one run.
    bool endurance = false;
    // The methods of more_subjects() that it runs with as well.
    std::vector<std::string> more_methods{};
};

std::vector<Case> spring_cases();
std::vector<Case> link_cases();
std::vector<Case> contact_cases();
std::vector<Case> edge_cases();
const std::vector<Case>& all_cases();
// Throws std::logic_error if there is none of that name.
const Case& case_named(const std::string& name);

// The cases of the maps: the limit along one axis at a value of the other.
Case stiffness_at_step(int exponent, bool softer);  // a step of 2^-exponent s
Case mass_ratio_at_links(unsigned links);           // a hanging chain of rods
Case speed_at_length(double length, int exponent);  // a body circling on a rod

}  // namespace stability
