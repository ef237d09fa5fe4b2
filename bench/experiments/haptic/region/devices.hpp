// SPDX-License-Identifier: GPL-3.0-or-later
// The levers whose stable region is determined: each arithmetic at each loop rate, with and without
// selective damping, compiled for the host.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/experiments/haptic/region/held_lever.hpp"
#include "bench/experiments/haptic/region/released_lever.hpp"

namespace haptic::region {

// What the linear model needs to know of a lever's firmware.
struct Law {
    double step;          // s; 0 for the clock of the 2016 design
    double servo_delay;   // s, by which the servo's command is advanced
    double damping;       // fraction by which a step against the push slows the arm, 0 to 1
    bool position_first;  // explicit Euler
};

struct Device {
    std::string arithmetic;  // q16_16, float, published
    std::string change;      // to the flashed lever, for one of changes()
    bool damped;
    int rate;  // 2^rate steps a second; 0: by the clock of the 2016 design
    Law law;
    // Runs on the host; `step_takes` is the time of a step on the chip, in s.
    Swing (*hold)(const Parameters&, double arm, Start, double step_takes);
    std::optional<double> (*fall)(const Parameters&, double step_takes);
};

constexpr int slowest = 7, fastest = 11;  // rates

// Each arithmetic at each rate, damped and undamped; and the published lever with its own clock.
std::vector<Device> devices();

// The flashed lever with each of its stabilising measures left out in turn, and the other levers
// unchanged.
std::vector<Device> changes();

}  // namespace haptic::region
