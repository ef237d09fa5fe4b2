// SPDX-License-Identifier: GPL-3.0-or-later
// The fall that the report gives a time for: a hand holds the lever at the top and lets go.
#pragma once

#include <optional>

#include "bench/experiments/haptic/scenarios.hpp"

namespace haptic::region {

// s: what was published for an arm of 20 cm, at the dial's shortest of 23 cm. Times of fall are as
// the roots of the arms.
double published_fall();

// Loop: a HostLoop or a DeviceLoop that was made with the script of release_and_fall. Seconds from
// the hand's letting go until the servo is within a degree of its lower stop; none where it is not
// within 2 s.
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
