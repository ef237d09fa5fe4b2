// SPDX-License-Identifier: GPL-3.0-or-later
// The fall for which a time was published: a hand holds the lever at the top and lets go.
#pragma once

#include <optional>

#include "bench/experiments/haptic/scenarios.hpp"

namespace haptic::region {

// The published time in s for an arm of 20 cm, converted to the dial's shortest of 23 cm: times of
// fall are proportional to the square roots of the arms.
double published_fall();

// The seconds from the hand's release until the servo is within a degree of its lower stop; none if
// that takes over 2 s. Loop must be a HostLoop or a DeviceLoop made with the script of
// release_and_fall.
template <class Loop>
std::optional<double> watch_fall(Loop& loop) {
    constexpr double let_go = 1, longest = 2;
    const double lowered = Travel().lowered;
    for (double now = let_go; now < let_go + longest; now += 1e-3) {
        loop.run_until(now);
        if (loop.plant().servo_angle() - lowered < degrees(1)) return now - let_go;
    }
    return std::nullopt;
}

}  // namespace haptic::region
