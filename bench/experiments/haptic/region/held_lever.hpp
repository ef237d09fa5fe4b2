// SPDX-License-Identifier: GPL-3.0-or-later
// The experiment of the stable region: a hand holds the lever still in the middle of its travel,
// the lever is poked, and comes to rest or does not.
#pragma once

#include <algorithm>
#include <vector>

#include "bench/experiments/haptic/plant/plant.hpp"

namespace haptic::region {

constexpr double shortest_arm = 0.23, longest_arm = 0.48;  // m: the ends of the dial

// How the hand comes to hold the lever. Either it grasps the lever at rest and moves it within a
// second, or it holds it in the middle when the servo is switched on and throws it towards its stop
// and back.
enum class Start { grasped, released_against };

// Poked with 3 N for 50 ms at 2 s, observed from 4 to 5 s.
struct Holding {
    static constexpr double begin = 4, end = 5;  // s

    explicit Holding(double arm, Start start = Start::grasped) {
        constexpr double middle = degrees(30);
        script.hand_grip.from(1);
        if (start == Start::grasped) {
            script.hand_angle.from(0).ramp(0.2, 1.2, middle);
        } else {
            script.hand_angle.from(middle);
        }
        script.dial.from((arm - shortest_arm) / (longest_arm - shortest_arm));
        script.hand_force.step(2, 3).step(2.05, 0);
    }
    Script script;
};

// The motion of the lever in the last second.
struct Swing {
    // The contact oscillation is two degrees or more; the servo's steps and dead band leave a third
    // of a degree. The limit is between the two, as in the envelopes of the scenarios.
    static constexpr double most = degrees(1.5);

    double size = 0;       // rad, peak to peak
    double frequency = 0;  // Hz: upward passes of the mean, if it swings
    bool at_rest() const { return size <= most; }
};

inline Swing swing_of(const std::vector<double>& angles, double seconds) {
    Swing swing;
    double least = angles.front(), highest = least, sum = 0;
    for (const double angle : angles) {
        least = std::min(least, angle);
        highest = std::max(highest, angle);
        sum += angle;
    }
    swing.size = highest - least;
    // Counts passes out of the middle quarter, so that ripples on the way do not count.
    const double mean = sum / static_cast<double>(angles.size()), margin = swing.size / 8;
    int passes = 0;
    bool above = angles.front() > mean;
    for (const double angle : angles) {
        if (!above && angle > mean + margin) {
            ++passes;
            above = true;
        } else if (angle < mean - margin) {
            above = false;
        }
    }
    swing.frequency = passes / seconds;
    return swing;
}

// Loop must be a HostLoop or a DeviceLoop made with Holding's script.
template <class Loop>
Swing watch_held(Loop& loop) {
    std::vector<double> angles;
    for (double now = Holding::begin; now < Holding::end; now += 1e-3) {
        loop.run_until(now);
        angles.push_back(loop.plant().lever_angle());
    }
    return swing_of(angles, Holding::end - Holding::begin);
}

}  // namespace haptic::region
