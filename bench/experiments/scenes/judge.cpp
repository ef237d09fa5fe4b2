// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/scenes/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "reference/trajectories/invariants.hpp"

namespace scene_bench {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
// A rod whose length is off by this fraction no longer holds anything.
constexpr double lost_rod = 0.1;

double distance(const ParticleState& a, const ParticleState& b) {
    return std::hypot(a.position[0] - b.position[0], a.position[1] - b.position[1],
                      a.position[2] - b.position[2]);
}

State at_rest(State state) {
    for (ParticleState& particle : state) particle.velocity = {};
    return state;
}

}  // namespace

double largest_distance(const Trajectory& a, const Trajectory& b) {
    const std::size_t times = std::min(a.size(), b.size());
    double largest = times > 1 ? 0 : none;
    for (std::size_t t = 1; t < times; ++t) {
        for (std::size_t p = 0; p < std::min(a[t].size(), b[t].size()); ++p) {
            const double apart = distance(a[t][p], b[t][p]);
            if (!(apart <= largest)) largest = apart;
            if (std::isnan(apart)) return none;
        }
    }
    return largest;
}

double extent(const Trajectory& trajectory) {
    std::array<double, 3> low, high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (const State& state : trajectory) {
        for (const ParticleState& particle : state) {
            for (int i = 0; i < 3; ++i) {
                low[i] = std::min(low[i], particle.position[i]);
                high[i] = std::max(high[i], particle.position[i]);
            }
        }
    }
    return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

double energy_drift(std::string_view scene, const Trajectory& run, const Trajectory& truth) {
    const std::vector<reference::Mechanics> mechanics = reference::mechanics(scene);
    const auto energy = [&](const State& state) { return reference::energy(mechanics, state); };
    const auto kinetic = [&](const State& state) { return energy(state) - energy(at_rest(state)); };
    double scale = kinetic(run.front()), largest = 0;
    for (const State& state : truth) scale = std::max(scale, kinetic(state));
    const std::size_t times = truth.empty() ? run.size() : std::min(run.size(), truth.size());
    for (std::size_t t = 1; t < times; ++t) {
        const State& held_to = truth.empty() ? run.front() : truth[t];
        largest = std::max(largest, std::abs(energy(run[t]) - energy(held_to)));
    }
    return scale > 0 ? largest / scale : none;
}

std::string verdict(const Evidence& evidence) {
    const Run& run = evidence.run;
    if (!run.failure.empty()) return "failed: " + run.failure;
    double rod_error = 0;
    bool lost = false;
    for (std::size_t t = 1; t < run.trajectory.size(); ++t) {
        const double error = evidence.scene.rod_error(run.trajectory[t]);
        rod_error = std::max(rod_error, error);
        if (!(error <= lost_rod)) lost = true;
    }
    const bool away = evidence.error > evidence.extent;
    if (!lost && !away) return "held";
    if (evidence.error_method > evidence.extent)
        return fmt::format("failed: the method itself errs by {:.2g} m at this step",
                           evidence.error_method);
    if (evidence.needed_range >= evidence.range)
        return fmt::format("failed: overflow: numbers up to {:.3g} where the format ends at {:g}",
                           evidence.needed_range, evidence.range);
    if (lost) return fmt::format("failed: a rod is {:.0f}% off its length", 100 * rod_error);
    return fmt::format("failed: error beyond the size of the scene ({:.2g} m)", evidence.extent);
}

}  // namespace scene_bench
