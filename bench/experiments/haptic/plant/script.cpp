// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/plant/script.hpp"

#include <algorithm>

namespace haptic {

double Signal::at(double time) const {
    const auto next = std::upper_bound(points_.begin(), points_.end(), time,
                                       [](double t, const Point& point) { return t < point.time; });
    if (next == points_.begin()) return points_.front().value;
    const Point& before = *std::prev(next);
    if (next == points_.end()) return before.value;
    return before.value +
           (next->value - before.value) * (time - before.time) / (next->time - before.time);
}

void Signal::add(double time, double value) {
    if (!(time >= points_.back().time))
        throw std::invalid_argument("the points of a signal must be in order of time");
    points_.push_back({time, value});
}

}  // namespace haptic
